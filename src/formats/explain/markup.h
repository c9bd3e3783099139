#pragma once
// Pieces of SVG and HTML.

#include <glm/vec3.hpp>

#include <string>
#include <string_view>

namespace glint {

/// Text with & < > and quotes escaped.
std::string escape_markup(std::string_view text);
/// At most so many characters, with … for what is cut.
std::string cut(const std::string& text, std::size_t most);
/// "#ff8800" of linear light, by the sRGB curve; below 0 is black, above 1 white.
std::string web_color(const glm::vec3& linear);

} // namespace glint
