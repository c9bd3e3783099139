// glint new: writes a template of a scene, or a scene around a mesh.
#include "commands.h"
#include "outputs.h"
#include "scene_input.h"

#include "glint/document.h"
#include "glint/scene_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
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

/// How a scene in that folder names a file.
std::string seen_from(const std::filesystem::path& folder, const std::string& file) {
    std::error_code unknown;
    const std::filesystem::path relative = std::filesystem::proximate(file, folder, unknown);
    return (unknown ? std::filesystem::path(file) : relative).generic_string();
}

std::filesystem::path folder_of(const std::string& output) {
    return output == "-" ? "." : std::filesystem::absolute(output).parent_path();
}

bool lies_outside(const std::string& mesh, const std::string& output) {
    const std::filesystem::path seen = seen_from(folder_of(output), mesh);
    return seen.is_absolute() || *seen.begin() == "..";
}

/// The scene in which glint shows a bare mesh.
SceneDocument stage_of(const std::string& mesh, const LoadOptions& options) {
    const SceneDocument document = SceneDocument::open(mesh, options);
    return {fmt::format("# The scene in which glint shows {}.\n\n{}",
                        std::filesystem::path(mesh).filename().string(), document.text()),
            document.name()};
}

double three_digits(double x) { return std::stod(fmt::format("{:.3g}", x)); }

/// The template with a mesh on a turntable of its size.
SceneDocument turntable_of(const std::string& mesh, const LoadOptions& options) {
    constexpr NamesUpTo<Axis::minus_z> upright{"{ rotate = [0, 1, 0], angle = -90 }, ",
                                               "{ rotate = [1, 0, 0], angle = 90 }, ",
                                               "",
                                               "{ rotate = [0, 1, 0], angle = 90 }, ",
                                               "{ rotate = [1, 0, 0], angle = -90 }, ",
                                               "{ rotate = [1, 0, 0], angle = 180 }, "};
    LoadedScene staged = load_scene(mesh, options);
    Object& object = staged.description.objects.front();
    const Axis up = options.up.value_or(guess_up_axis(*std::get<MeshShape>(object.shape).data));
    SceneDocument document(template_text("mesh"), std::filesystem::path(mesh).replace_extension(".toml"));
    document.set("mesh.model.file", scene_value(std::filesystem::path(mesh).filename().string()));
    document.set("mesh.model.transform", fmt::format("[{}{{ rotate = [0, 0, 1], angle = 25 }}]",
                                                     upright[static_cast<std::size_t>(up)]));

    // What the transform makes of the mesh says how large the table is, and where it stands.
    SceneDescription model = parse_scene(document.text(), document.name()).description;
    std::erase_if(model.objects, [](const Object& o) { return !std::holds_alternative<MeshShape>(o.shape); });
    const SceneStats stats = build_scene(model).stats();
    const Vec3 extent = stats.bounds_max - stats.bounds_min;
    const Vec3 middle = (stats.bounds_max + stats.bounds_min) / 2.0;
    const double radius = three_digits(0.6 * std::hypot(extent.x, extent.y));
    const double height = three_digits(0.05 * radius);
    document.set("cylinder.turntable.radius", radius);
    document.set("cylinder.turntable.height", height);
    // A hair below, so that faces do not coincide.
    document.set("cylinder.turntable.base",
                 Vec3(middle.x, middle.y, stats.bounds_min.z - height - 1e-4 * radius));
    return document;
}

/// --from.
std::string scene_around(const Arguments& arguments, const std::string& mesh, const std::string& output) {
    const std::string name = arguments.operands().empty() ? "" : arguments.operands().front();
    if (!name.empty() && name != "mesh")
        throw Error(ErrorKind::usage,
                    fmt::format("--from goes with no template or with mesh, not with {}", name));
    const LoadOptions options = load_options(arguments);
    SceneDocument document = name.empty() ? stage_of(mesh, options) : turntable_of(mesh, options);
    document.set("mesh.0.file", scene_value(seen_from(folder_of(output), mesh)));
    return document.text();
}

} // namespace

int new_command(const Arguments& arguments, Console& console) {
    const std::vector<std::string> names = template_names();
    if (arguments.has("list")) {
        print_data(fmt::format("{}\n", fmt::join(names, "\n")));
        return exit_code::done;
    }
    const Output output{"-o", arguments.text("output").value_or("-")};
    const std::string& path = output.path;
    const std::optional<std::string> mesh = arguments.text("from");
    require_outputs(mesh ? std::vector{*mesh} : std::vector<std::string>(), {output});
    const std::string text = mesh ? scene_around(arguments, *mesh, path) : starter(arguments, names);
    std::error_code none;
    if (path != "-" && std::filesystem::exists(path, none) && !arguments.has("force"))
        throw Error(ErrorKind::output, fmt::format("\"{}\" exists", path), "--force overwrites it");
    write_text(output, text);
    if (path == "-") return exit_code::done;
    // A file that is named like a command needs a folder.
    console.line(fmt::format("{}: written; render it with: glint {}{}{}", path,
                             find_command(path) ? "./" : "", path,
                             mesh && lies_outside(*mesh, path) ? " --allow-outside" : ""));
    return exit_code::done;
}

} // namespace glint::cli
