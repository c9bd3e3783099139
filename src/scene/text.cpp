// Text of messages.

#include "scene/text.h"

#include "glint/error.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace glint::scene {

std::string show(double x) {
    if (std::isnan(x)) return "nan";
    if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, x);
    return {buffer, end.ptr};
}

std::string show(const glm::dvec3& v) { return show(v.x) + ", " + show(v.y) + ", " + show(v.z); }

std::string rounded(double number) {
    char text[32];
    std::snprintf(text, sizeof text, std::abs(number) < 10 ? "%.2g" : "%.0f", number);
    return text;
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t longest = 80;
    std::string shown(text.substr(0, longest));
    // A cut must not leave half a UTF-8 character behind.
    if (text.size() > longest) {
        while (!shown.empty() && continues_utf8(shown.back())) shown.pop_back();
        if (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0x80u) != 0) shown.pop_back();
        shown += "…";
    }
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    return '"' + shown + '"';
}

std::string listed(const std::vector<std::string>& words, std::string_view separator) {
    std::string text;
    for (const std::string& word : words) {
        if (&word != &words.front()) text += separator;
        text += word;
    }
    return text;
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

} // namespace glint::scene
