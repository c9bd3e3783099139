// glint new: writes a template of a scene.
#include "commands.h"
#include "outputs.h"

#include "glint/scene_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace glint::cli {
namespace {

/// The template named by the operand, by default the first one.
std::string starter(const Arguments& arguments, const std::vector<std::string>& names) {
    if (arguments.operands().empty()) return template_text(names.front());
    const std::string& name = arguments.operands().front();
    if (std::find(names.begin(), names.end(), name) != names.end()) return template_text(name);
    const auto near = nearest_name(name, names);
    throw Error(ErrorKind::usage, fmt::format("unknown template \"{}\"", name),
                near ? fmt::format("did you mean \"{}\"?", *near)
                     : fmt::format("there are: {}", fmt::join(names, ", ")));
}

} // namespace

int new_command(const Arguments& arguments, Console& console) {
    const std::vector<std::string> names = template_names();
    if (arguments.has("list")) {
        print_data(fmt::format("{}\n", fmt::join(names, "\n")));
        return exit_code::done;
    }
    const std::string text = starter(arguments, names);
    const Output output{"-o", arguments.text("output").value_or("-")};
    const std::string& path = output.path;
    require_outputs({}, {output});
    std::error_code none;
    if (path != "-" && std::filesystem::exists(path, none) && !arguments.has("force"))
        throw Error(ErrorKind::output, fmt::format("\"{}\" exists", path), "--force overwrites it");
    write_text(output, text);
    if (path == "-") return exit_code::done;
    // A file that is named like a command needs a folder.
    console.line(
        fmt::format("{}: written; render it with: glint {}{}", path, find_command(path) ? "./" : "", path));
    return exit_code::done;
}

} // namespace glint::cli
