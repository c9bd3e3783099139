#pragma once
// Helpers for JSON, SVG and HTML.

#include <glm/vec3.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace glint::formats {

/// Nine digits, which parse to the same float; null for values that JSON cannot represent.
std::string json_number(float x);
std::string json_text(const std::string& text);
std::string json_list(std::vector<std::string> texts);

/// Text with & < > and quotes escaped.
std::string escape_markup(std::string_view text);
/// Truncates to at most `most` characters, ending in "…" if cut.
std::string cut(const std::string& text, std::size_t most);
/// "#rrggbb" of linear light by the sRGB curve, clamped to 0 … 1.
std::string web_color(const glm::vec3& linear);

} // namespace glint::formats
