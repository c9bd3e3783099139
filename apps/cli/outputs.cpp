#include "outputs.h"

#include "console.h"

#include "glint/picture_files.h"
#include "glint/write_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <span>
#include <unistd.h>

namespace glint::cli {
namespace fs = std::filesystem;

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

void require_writable(const std::string& path) {
    if (path == "-") return;
    const auto refuse = [&](const std::string& why, const std::string& cure) {
        throw Error(ErrorKind::output, fmt::format("cannot write \"{}\": {}", path, why), cure);
    };
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) refuse("it is a folder", "name a file in it");
    const fs::path parent = fs::path(path).parent_path();
    const std::string folder = parent.empty() ? "." : parent.string();
    if (!fs::exists(folder, ignored))
        refuse("its folder does not exist", "create it first: mkdir -p " + folder);
    if (!fs::is_directory(folder, ignored)) refuse(fmt::format("\"{}\" is not a folder", folder), "");

    // Permissions, read-only disks and odd file systems all show themselves by trying.
    std::string probe = (fs::path(folder) / ".glint-XXXXXX").string();
    const int file = mkstemp(probe.data());
    if (file < 0) refuse(std::strerror(errno), "");
    close(file);
    unlink(probe.c_str());
}

void write_text(const std::string& path, const std::string& text) {
    if (path == "-") return print_data(text);
    write_file(path, std::as_bytes(std::span(text)));
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
