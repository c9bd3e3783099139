#pragma once
// Text of messages about values and scene files.

#include <glm/vec3.hpp>

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace glint::scene {

/// The shortest text that reads back as x: "0.1", "4", "nan".
std::string show(double x);
/// The same of three numbers, separated by commas.
std::string show(const glm::dvec3& v);

/// "word" between quotes, as one short line: control characters become '?', long text ends in "…".
std::string in_quotes(std::string_view text);

/// "a, b, c".
std::string listed(const std::vector<std::string>& words, std::string_view separator = ", ");

/// A number with about two digits: "0.25", "1.2", "1234".
std::string rounded(double number);

/// With the letters of ASCII in lower case.
std::string lower_case(std::string_view text);

/// The number that the whole text says; none if it says none, or one that does not fit.
template <class Number>
std::optional<Number> parse_number(std::string_view text) {
    Number number{};
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool whole = fault == std::errc() && end == text.data() + text.size();
    return whole ? std::optional(number) : std::nullopt;
}

/// Whether a byte of UTF-8 is not the first of its character.
constexpr bool continues_utf8(char byte) { return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80u; }

} // namespace glint::scene
