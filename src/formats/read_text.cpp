// Reading scene files and stdin.

#include "formats/read_text.h"

#include "formats/read_bytes.h"
#include "glint/error.h"
#include "scene/text.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace glint::formats {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_scene = std::size_t{256} << 20;

// Reads to the end, or one byte beyond the limit.
std::string read_stream(std::istream& stream) {
    std::string text;
    std::string block(1 << 16, '\0');
    while (text.size() <= longest_scene) {
        stream.read(block.data(), static_cast<std::streamsize>(block.size()));
        const auto count = static_cast<std::size_t>(stream.gcount());
        if (count == 0) break;
        text.append(block, 0, count);
    }
    return text;
}

std::string read_file(const std::string& path) {
    constexpr const char* expected = "a scene (.toml) or a mesh (.ply) was expected";
    const auto refuse = [&](const std::string& message, const char* hint) {
        throw Error(ErrorKind::input, message, hint, {.file = path});
    };
    std::error_code failed;
    const fs::file_status status = fs::status(path, failed);
    if (status.type() == fs::file_type::not_found) refuse("the file does not exist", expected);
    if (fs::is_directory(status)) refuse("this is a folder", expected);
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::string text;
    if (file) text = read_stream(file);
    const std::string cause = errno ? ": " + std::string(std::strerror(errno)) : "";
    if (!file.is_open() || file.bad()) refuse("the file cannot be read" + cause, "");
    return text;
}

} // namespace

std::string read_text(const std::string& path) {
    std::string text = path == "-" ? read_stream(std::cin) : read_file(path);
    const std::string name = path == "-" ? stdin_name : path;
    require_scene_size(text, name);
    refuse_compressed(text, name);
    return text;
}

void require_scene_size(std::string_view text, const std::string& name) {
    if (text.size() > longest_scene)
        throw Error(ErrorKind::resource, "the scene file is larger than 256 MiB",
                    "put geometry into PLY files", {name, 0, 0, {}});
}

std::string lower_extension(const std::string& path) {
    return scene::lower_case(fs::path(path).extension().string());
}

bool looks_like_ply(std::string_view text) { return text.starts_with("ply\n") || text.starts_with("ply\r"); }

} // namespace glint::formats
