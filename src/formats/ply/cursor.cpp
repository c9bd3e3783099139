// Parsing text bodies.

#include "formats/ply/cursor.h"

#include <charconv>
#include <limits>

namespace glint::formats::ply {
namespace {

bool ends_line(char c) { return c == '\n' || c == '\r'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool separates_words(char c) { return is_blank(c) || ends_line(c); }

/// from_chars accepts no plus sign, but files contain it.
std::string_view skip_plus(std::string_view word) {
    const bool signed_number = word.size() > 1 && word[0] == '+' && word[1] != '-';
    return signed_number ? word.substr(1) : word;
}

/// Parses the whole word as a value; returns the error otherwise.
template <class Value>
std::errc parse(std::string_view word, Value& value) {
    const std::string_view digits = skip_plus(word);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc::invalid_argument && end != digits.data() + digits.size())
        return std::errc::invalid_argument;
    return error;
}

/// The value of a number outside the range of double: 0 or infinity.
double out_of_range_number(std::string_view word) {
    const std::size_t exponent = word.find_first_of("eE");
    const std::string_view digits = word.substr(0, exponent);
    const bool small = exponent != word.npos
                           ? word.substr(exponent + 1).starts_with('-')
                           : digits.substr(0, digits.find('.')).find_first_not_of("+-0") == digits.npos;
    const double size = small ? 0.0 : std::numeric_limits<double>::infinity();
    return word.starts_with('-') ? -size : size;
}

struct IntegerRange {
    std::int64_t min;
    std::int64_t max;
};
IntegerRange range_of(Type type) {
    const int bits = static_cast<int>(8 * size_of(type));
    const bool is_signed = type == Type::int8 || type == Type::int16 || type == Type::int32;
    const std::int64_t half = std::int64_t{1} << (bits - 1);
    return is_signed ? IntegerRange{-half, half - 1} : IntegerRange{0, 2 * half - 1};
}

} // namespace

std::string row_name(const Element& element, std::uint64_t row) {
    const std::string name = quoted_word(element.name);
    return name.substr(1, name.size() - 2) + " " + std::to_string(row);
}

/// Skips blank lines and comments up to the next value.
void TextCursor::skip_to_row() {
    while (true) {
        while (at_ < text_.size() && separates_words(text_[at_])) ++at_;
        const std::string_view rest = text_.substr(at_);
        bool comment = false;
        if (!rest.empty() && (rest[0] == 'c' || rest[0] == 'o'))
            for (const std::string_view keyword : {"comment", "obj_info"})
                if (rest.starts_with(keyword) &&
                    (rest.size() == keyword.size() || separates_words(rest[keyword.size()])))
                    comment = true;
        if (!comment) return;
        while (at_ < text_.size() && !ends_line(text_[at_])) ++at_;
    }
}

void TextCursor::begin_row(const Element& element, std::uint64_t row) {
    element_ = &element;
    row_ = row;
    skip_to_row();
    row_begin_ = at_;
}

void TextCursor::end_row() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    if (at_ == text_.size() || ends_line(text_[at_])) return;
    const std::size_t extra = at_;
    const std::string_view word = next_word();
    const std::string_view row_text = text_.substr(row_begin_, extra - row_begin_);
    const bool wrapped = row_text.find_first_of("\r\n") != row_text.npos;
    fail(extra, "unexpected " + quoted_word(word) + " after the end of " + row_name(*element_, row_),
         wrapped ? "this row began on an earlier line: a value may be missing there"
                 : "the row has more values than its header lists properties");
}

std::string_view TextCursor::next_word() {
    while (at_ < text_.size() && separates_words(text_[at_])) ++at_;
    if (at_ == text_.size()) {
        // Point behind the last word rather than at the empty line after it.
        std::size_t end = at_;
        while (end > 0 && separates_words(text_[end - 1])) --end;
        fail(end, "the file ends within " + row_name(*element_, row_),
             "its header promises " + std::to_string(element_->count) + "; the file seems to be cut");
    }
    value_ = at_;
    while (at_ < text_.size() && !separates_words(text_[at_])) ++at_;
    return text_.substr(value_, at_ - value_);
}

double TextCursor::number(Type type) {
    if (is_integer(type)) return static_cast<double>(integer(type));
    const std::string_view word = next_word();

    // Round once from the text to float; use double only for values outside the range of float.
    if (type == Type::float32) {
        float value = 0;
        if (parse(word, value) == std::errc()) return static_cast<double>(value);
    }
    double value = 0;
    const std::errc error = parse(word, value);
    if (error == std::errc::result_out_of_range) return out_of_range_number(word);
    if (error != std::errc())
        fail(value_, quoted_word(word) + " in " + row_name(*element_, row_) + " is not a number",
             "expected a number like 0.5 or -1e-3");
    return value;
}

std::int64_t TextCursor::integer(Type type) {
    const std::string_view word = next_word();
    std::int64_t value = 0;
    const std::errc error = parse(word, value);
    if (error == std::errc::invalid_argument)
        fail(value_, quoted_word(word) + " in " + row_name(*element_, row_) + " is not a whole number",
             std::string("expected a value of type ") + type_name(type));
    const IntegerRange range = range_of(type);
    if (error != std::errc() || value < range.min || value > range.max)
        fail(value_,
             quoted_word(word) + " in " + row_name(*element_, row_) + " does not fit its type " +
                 type_name(type),
             "expected a whole number from " + std::to_string(range.min) + " to " +
                 std::to_string(range.max));
    return value;
}

void TextCursor::skip(Type, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) next_word();
}

std::size_t TextCursor::trailing() {
    skip_to_row();
    return text_.size() - at_;
}

} // namespace glint::formats::ply
