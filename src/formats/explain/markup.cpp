// Escaping for JSON, SVG and HTML; colours.

#include "formats/explain/markup.h"

#include "glint/error.h"
#include "imaging/tone.h"
#include "scene/text.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace glint::formats {

std::string json_number(float x) {
    if (!std::isfinite(x)) return "null";
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.9g", static_cast<double>(x));
    return buffer;
}

std::string json_text(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string json_list(std::vector<std::string> texts) {
    for (std::string& text : texts) text = json_text(text);
    return "[" + scene::listed(texts) + "]";
}

std::string escape_markup(std::string_view text) {
    std::string out;
    // XML has no control characters.
    for (const char c : printable(text, "\n\t")) {
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
        if (scene::continues_utf8(text[i])) continue;
        if (characters++ == most) return text.substr(0, i) + "…";
    }
    return text;
}

std::string web_color(const glm::vec3& linear) {
    char buffer[8];
    std::snprintf(buffer, sizeof buffer, "#%02x%02x%02x", imaging::srgb8_from_linear(linear.x),
                  imaging::srgb8_from_linear(linear.y), imaging::srgb8_from_linear(linear.z));
    return buffer;
}

} // namespace glint::formats
