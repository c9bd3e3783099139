// Reading scene files and stdin.

#include "formats/read_text.h"

#include "formats/read_bytes.h"
#include "glint/error.h"
#include "scene/text.h"

#include <unistd.h>

#include <filesystem>
#include <span>

namespace glint::formats {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_scene = std::size_t{256} << 20;

// Reads to the end: of a scene to one byte beyond the limit, of a mesh as far as there is memory.
std::string read_all(InputFile&& file, const std::string& name) {
    std::string text;
    std::string block(1 << 16, '\0');
    while (text.size() <= longest_scene || looks_like_ply(text)) {
        const std::size_t count = file.read(std::as_writable_bytes(std::span(block)));
        if (count == 0) break;
        if (text.size() + count > text.capacity()) require_memory_to_grow(text.capacity(), name);
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
    return read_all(InputFile(path), path);
}

} // namespace

std::string read_text(const std::string& path) {
    std::string text =
        path == "-" ? read_all(InputFile(::dup(STDIN_FILENO), stdin_name), stdin_name) : read_file(path);
    const std::string name = path == "-" ? stdin_name : path;
    if (!looks_like_ply(text)) require_scene_size(text, name);
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
