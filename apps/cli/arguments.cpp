// Values of options as numbers.
#include "arguments.h"

#include "glint/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace glint::cli {
namespace {

template <typename Number>
std::optional<Number> parse_number(std::string_view text) {
    Number number{};
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, number);
    if (fault != std::errc() || stop != end) return std::nullopt;
    return number;
}

[[noreturn]] void refuse(const std::string& key, const std::string& given, const std::string& expected) {
    const std::string name = key.size() == 1 ? "-" + key : "--" + key;
    throw Error(ErrorKind::usage, fmt::format("{} \"{}\" is not valid", name, given), "expected " + expected);
}

std::string range(std::int64_t min, std::int64_t max) {
    return max == INT64_MAX ? fmt::format("at least {}", min) : fmt::format("from {} to {}", min, max);
}

} // namespace

std::optional<std::int64_t> whole_number(std::string_view text) { return parse_number<std::int64_t>(text); }

Arguments::Arguments(const Command& command, std::map<std::string, std::vector<std::string>> values,
                     std::vector<std::string> operands)
    : command_(&command), values_(std::move(values)), operands_(std::move(operands)) {}

bool Arguments::has(const std::string& key) const { return values_.count(key) > 0; }

std::optional<std::string> Arguments::text(const std::string& key) const {
    const auto found = values_.find(key);
    if (found == values_.end()) return std::nullopt;
    return found->second.back();
}

std::vector<std::string> Arguments::all(const std::string& key) const {
    const auto found = values_.find(key);
    return found == values_.end() ? std::vector<std::string>() : found->second;
}

std::size_t Arguments::choice(const std::string& name) const {
    const auto is_option = [&](const Option& option) { return key(option) == name; };
    const auto option = std::find_if(command_->options.begin(), command_->options.end(), is_option);
    const std::vector<std::string> all = choices(*option);
    const auto given = text(name);
    return given ? static_cast<std::size_t>(std::find(all.begin(), all.end(), *given) - all.begin()) : 0;
}

std::optional<std::int64_t> Arguments::integer(const std::string& key, std::int64_t min,
                                               std::int64_t max) const {
    const auto given = text(key);
    if (!given) return std::nullopt;
    const auto value = whole_number(*given);
    if (!value || *value < min || *value > max) refuse(key, *given, "a whole number " + range(min, max));
    return value;
}

std::optional<double> Arguments::number(const std::string& key) const {
    const auto given = text(key);
    if (!given) return std::nullopt;
    const auto value = parse_number<double>(*given);
    if (!value || std::isnan(*value) || *value < 0) refuse(key, *given, "a number, not below 0");
    return value;
}

std::optional<std::vector<std::int64_t>> Arguments::integers(const std::string& key, std::size_t count,
                                                             char separator, std::int64_t min,
                                                             std::int64_t max, const char* example) const {
    const auto given = text(key);
    if (!given) return std::nullopt;
    const std::string expected = fmt::format("{}, each number {}", example, range(min, max));
    const std::vector<std::string> parts = split(*given, separator);
    if (parts.size() != count) refuse(key, *given, expected);
    std::vector<std::int64_t> numbers;
    for (const std::string& part : parts) {
        const auto value = whole_number(part);
        if (!value || *value < min || *value > max) refuse(key, *given, expected);
        numbers.push_back(*value);
    }
    return numbers;
}

} // namespace glint::cli
