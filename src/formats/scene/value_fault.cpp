// Recognizes common mistakes in values.

#include "formats/scene/value_fault.h"

#include "scene/text.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace glint::formats {
namespace {

using scene::in_quotes;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Digits, signs, points and exponents in any order.
bool looks_like_number(std::string_view text) {
    return std::any_of(text.begin(), text.end(), is_digit) &&
           text.find_first_not_of("0123456789+-.eE_") == std::string_view::npos && !is_letter(text.front());
}

bool exceeds_double(std::string_view digits) {
    double number = 0;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return fault == std::errc::result_out_of_range && end == digits.data() + digits.size();
}

std::optional<ValueFault> number_fault(std::string_view text) {
    const std::string_view digits = text.substr(text.find_first_not_of("+-"));
    const std::string sign(text.substr(0, text.size() - digits.size()));
    if (digits.front() == '.')
        return ValueFault{in_quotes(text) + " begins with a point",
                          "write " + sign + "0" + std::string(digits)};
    if (digits.back() == '.')
        return ValueFault{in_quotes(text) + " ends with a point", "write " + std::string(text) + "0"};
    const bool whole = digits.find_first_not_of("0123456789") == std::string_view::npos;
    const bool fits =
        whole ? scene::parse_number<std::int64_t>(digits) || digits.front() == '0' : !exceeds_double(digits);
    if (!fits)
        return ValueFault{"the number " + std::string(text) + " is out of range",
                          whole ? "integers go up to 9223372036854775807"
                                : "numbers go up to 1.8e308, lengths and coordinates to 1e12"};
    return std::nullopt;
}

} // namespace

std::optional<ValueFault> value_fault(std::string_view text) {
    if (text.empty()) return std::nullopt;
    const bool list = text.front() == '(' || text.front() == '{';
    if (list || (text.find(',') != std::string_view::npos && !is_letter(text.front())))
        return ValueFault{"a list without brackets",
                          "lists stand in brackets, [1, 2, 3], and numbers have a point, 1.5"};
    if (looks_like_number(text)) return number_fault(text);
    if (!is_letter(text.front())) return std::nullopt;
    const std::string word = scene::lower_case(text);
    for (const char* boolean : {"true", "false", "yes", "no", "on", "off"})
        if (word == boolean) return ValueFault{in_quotes(text) + " is no boolean", "write true or false"};
    return ValueFault{in_quotes(text) + " stands without quotes",
                      "names, colours and files stand in quotes: \"" + std::string(text) + "\"", true};
}

} // namespace glint::formats
