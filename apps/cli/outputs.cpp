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
#include <unistd.h>
#include <utility>

namespace glint::cli {
namespace fs = std::filesystem;
namespace {

/// The name of a file, or of what a standard stream is.
std::string named(const std::string& path, int stream) {
    return path == "-" ? fmt::format("/dev/fd/{}", stream) : path;
}

/// Two results in one file would destroy each other, or what they were made of. Devices take any number.
void require_apart(const std::vector<std::string>& inputs, const std::vector<Output>& outputs) {
    std::map<std::string, std::string> read;
    std::map<std::string, std::string> written;
    std::error_code none;
    for (const std::string& input : inputs)
        if (const std::string name = named(input, STDIN_FILENO); fs::is_regular_file(name, none))
            read[file_identity(name)] = input == "-" ? "the file that stdin reads" : input;
    for (const Output& output : outputs) {
        const auto& [option, path] = output;
        const std::string name = named(path, STDOUT_FILENO);
        if (fs::is_character_file(name, none) || (path == "-" && !fs::exists(name, none))) continue;
        std::string file;
        write_output(output, [&] { file = file_identity(name); });
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
