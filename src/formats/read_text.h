#pragma once
// Reading scene files as text.

#include <string>
#include <string_view>

namespace glint::formats {

/// Name of stdin in messages.
inline constexpr const char* stdin_name = "<stdin>";

/// Reads a scene or a mesh from a file, or from stdin for "-". Throws Error(input) if it cannot be read and
/// Error(resource) if it is too large.
std::string read_text(const std::string& path);

/// Throws Error(resource) if a text is too large for a scene file.
void require_scene_size(std::string_view text, const std::string& name);

/// The extension in lower case, such as ".toml".
std::string lower_extension(const std::string& path);

/// Whether the text starts like a PLY file.
bool looks_like_ply(std::string_view text);

} // namespace glint::formats
