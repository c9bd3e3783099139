#include "outputs.h"

#include "console.h"

#include "glint/picture_files.h"
#include "glint/write_file.h"

#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace glint::cli {
namespace fs = std::filesystem;
namespace {

bool find(const std::string& path, int stream, struct stat& info) {
    return (path == "-" ? fstat(stream, &info) : stat(path.c_str(), &info)) == 0;
}

/// The same text for all names of a file: device and inode, or the path of a file that does not exist yet.
/// Devices such as /dev/null take any number of outputs. `stream`: what "-" is.
std::string identity(const std::string& path, int stream) {
    struct stat info = {};
    if (find(path, stream, info))
        return S_ISCHR(info.st_mode) ? path : fmt::format("{}:{}", info.st_dev, info.st_ino);
    constexpr int max_links = 40;
    fs::path file = path;
    std::error_code none;
    for (int i = 0; i < max_links && fs::is_symlink(file, none); ++i)
        file = file.parent_path() / fs::read_symlink(file, none);
    return fs::weakly_canonical(fs::absolute(file, none), none).string();
}

/// Two results in one file would destroy each other, or what they were made of.
void require_apart(const std::vector<std::string>& inputs, const std::vector<Output>& outputs) {
    std::map<std::string, std::string> read;
    std::map<std::string, std::string> written;
    struct stat info = {};
    for (const std::string& input : inputs)
        if (find(input, STDIN_FILENO, info) && S_ISREG(info.st_mode))
            read[identity(input, STDIN_FILENO)] = input == "-" ? "the file that stdin reads" : input;
    for (const auto& [option, path] : outputs) {
        const std::string file = identity(path, STDOUT_FILENO);
        const std::string cure = "name another file with " + option;
        if (const auto found = read.find(file); found != read.end())
            throw Error(ErrorKind::usage, fmt::format("{} would overwrite {}", option, found->second), cure);
        if (const auto [other, first] = written.emplace(file, option); !first)
            throw Error(ErrorKind::usage,
                        fmt::format("{} both go to {}",
                                    other->second == option ? "two frames" : other->second + " and " + option,
                                    shown_name(path)),
                        cure);
    }
}

} // namespace

PictureFormat output_format(const std::string& path) {
    const std::optional<PictureFormat> format = picture_format(path);
    if (!format)
        throw Error(ErrorKind::usage,
                    fmt::format("\"{}\" names no kind of picture that can be written", path),
                    "expected a name that ends in .png, .exr or .pfm, or - for PNG on stdout");
    if (format == PictureFormat::exr && !GLINT_EXR)
        throw Error(ErrorKind::output,
                    fmt::format("cannot write \"{}\": this glint was built without OpenEXR", path),
                    "use .png or .pfm");
    return *format;
}

void require_outputs(const std::vector<std::string>& inputs, const std::vector<Output>& outputs) {
    require_apart(inputs, outputs);
    for (const Output& output : outputs)
        if (output.path != "-") write_output(output, [&] { check_writable(output.path); });
}

void write_output(const Output& output, const std::function<void()>& write) {
    try {
        write();
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::output) throw;
        std::vector<Diagnostic> diagnostics = error.diagnostics();
        std::string& hint = diagnostics.front().hint;
        hint += (hint.empty() ? "" : "; ") + output.option + " names another file";
        throw Error(ErrorKind::output, std::move(diagnostics));
    }
}

void write_text(const Output& output, const std::string& text) {
    write_output(output, [&] {
        if (output.path == "-") return print_data(text);
        write_file(output.path, std::as_bytes(std::span(text)));
    });
}

bool waits_for_reader(const std::string& path) {
    std::error_code none;
    return path == "-" || (fs::exists(path, none) && !fs::is_regular_file(path, none));
}

std::string default_output(const std::string& scene, bool frames) {
    const std::string stem = scene == "-" ? "stdin" : fs::path(scene).stem().string();
    if (!frames) return stem + ".png";
    std::string pattern;
    for (const char c : stem) pattern.append(c == '%' ? 2 : 1, c);
    return pattern + "-%04d.png";
}

std::string shown_name(const std::string& path) { return path == "-" ? "stdout" : path; }

} // namespace glint::cli
