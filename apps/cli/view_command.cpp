// glint view: starts glint-view.
#include "commands.h"

#include <filesystem>
#include <unistd.h>

namespace glint::cli {
namespace {

/// The command line of these arguments.
std::vector<std::string> command_line(const Arguments& arguments) {
    std::vector<std::string> line;
    for (const Option& option : arguments.command().options)
        for (const std::string& value : arguments.all(key(option))) {
            line.push_back(spelling(option));
            if (*option.value) line.push_back(value);
        }
    line.emplace_back("--");
    line.insert(line.end(), arguments.operands().begin(), arguments.operands().end());
    return line;
}

/// Replaces this process by the program; returns if that fails.
void exec(const std::string& program, std::vector<std::string> line) {
    line.insert(line.begin(), program);
    std::vector<char*> pointers;
    for (std::string& argument : line) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    execvp(program.c_str(), pointers.data());
}

} // namespace

/// The window is a program of its own, so that this one needs no window system.
int view_command(const Arguments& arguments, Console& /*console*/) {
    const std::vector<std::string> line = command_line(arguments);
    std::error_code unknown;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", unknown);
    if (!unknown) exec(self.parent_path() / "glint-view", line);
    exec("glint-view", line);
    throw Error(
        ErrorKind::device, "the window is not installed: there is no glint-view beside glint or on PATH",
        "build glint with GLFW, Dear ImGui and libepoxy, or render to a file: glint FILE -o picture.png");
}

} // namespace glint::cli
