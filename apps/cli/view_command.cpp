#include "commands.h"

#include <filesystem>
#include <unistd.h>

namespace glint::cli {
namespace {

/// The words that give these arguments again.
std::vector<std::string> words_of(const Arguments& arguments) {
    std::vector<std::string> words;
    for (const Option& option : arguments.command().options)
        for (const std::string& value : arguments.all(key(option))) {
            words.push_back(spelling(option));
            if (*option.value) words.push_back(value);
        }
    words.emplace_back("--");
    words.insert(words.end(), arguments.operands().begin(), arguments.operands().end());
    return words;
}

/// Becomes the program, or returns.
void become(const std::string& program, std::vector<std::string> words) {
    words.insert(words.begin(), program);
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    execvp(program.c_str(), pointers.data());
}

} // namespace

/// The window is a program of its own, so that this one needs no window system.
int view_command(const Arguments& arguments, Console& /*console*/) {
    const std::vector<std::string> words = words_of(arguments);
    std::error_code unknown;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", unknown);
    if (!unknown) become(self.parent_path() / "glint-view", words);
    become("glint-view", words);
    throw Error(
        ErrorKind::device, "the window is not installed: there is no glint-view beside glint or on PATH",
        "build glint with GLFW, Dear ImGui and libepoxy, or render to a file: glint FILE -o picture.png");
}

} // namespace glint::cli
