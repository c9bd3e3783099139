#pragma once
// Scene files as text.

#include <string>
#include <string_view>

namespace glint {

/// How messages name stdin.
inline constexpr const char* stdin_name = "<stdin>";

/// The whole text of a scene file, or of stdin for "-". Throws Error(input) where it cannot be read and
/// Error(resource) where it is larger than scene files may be.
std::string read_text(const std::string& path);

/// Throws Error(resource) for a text larger than scene files may be.
void require_scene_size(std::string_view text, const std::string& name);

/// ".toml", in small letters.
std::string lower_extension(const std::string& path);

/// Does the text begin as PLY files do?
bool looks_like_ply(std::string_view text);

} // namespace glint
