#pragma once
// Helpers for SVG and HTML.

#include <glm/vec3.hpp>

#include <string>
#include <string_view>

namespace glint {

/// Text with & < > and quotes escaped.
std::string escape_markup(std::string_view text);
/// Truncates to at most `most` characters, ending in "…" if cut.
std::string cut(const std::string& text, std::size_t most);
/// "#rrggbb" of linear light by the sRGB curve, clamped to 0 … 1.
std::string web_color(const glm::vec3& linear);

} // namespace glint
