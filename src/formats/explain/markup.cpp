// Escaping and colours for SVG and HTML.

#include "formats/explain/markup.h"

#include "imaging/tone.h"

#include <cstdio>

namespace glint {

std::string escape_markup(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
        case '&':
            out += "&amp;";
            break;
        case '<':
            out += "&lt;";
            break;
        case '>':
            out += "&gt;";
            break;
        case '"':
            out += "&quot;";
            break;
        default:
            out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
    }
    return out;
}

std::string cut(const std::string& text, std::size_t most) {
    std::size_t characters = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if ((static_cast<unsigned char>(text[i]) & 0xc0u) == 0x80u) continue;
        if (characters++ == most) return text.substr(0, i) + "…";
    }
    return text;
}

std::string web_color(const glm::vec3& linear) {
    char buffer[8];
    std::snprintf(buffer, sizeof buffer, "#%02x%02x%02x", srgb8_from_linear(linear.x),
                  srgb8_from_linear(linear.y), srgb8_from_linear(linear.z));
    return buffer;
}

} // namespace glint
