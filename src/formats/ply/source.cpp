// Error messages with lines, columns and excerpts.

#include "formats/ply/source.h"

#include <algorithm>
#include <limits>

namespace glint::formats::ply {
namespace {

constexpr std::size_t max_excerpt = 160;
constexpr std::size_t max_word = 40;

bool printable(char c) { return c >= ' ' && c <= '~'; }

int clamped(std::size_t n) {
    return static_cast<int>(std::min<std::size_t>(n, std::numeric_limits<int>::max()));
}

/// The line that starts at `start`; empty if it is too long or not plain text.
std::string shown_line(std::string_view text, std::size_t start) {
    const std::string_view line = text.substr(start, text.find_first_of("\r\n", start) - start);
    const bool plain =
        std::all_of(line.begin(), line.end(), [](char c) { return printable(c) || c == '\t'; });
    return plain && line.size() <= max_excerpt ? std::string(line) : std::string();
}

} // namespace

Source::Source(std::span<const std::byte> bytes, std::string name)
    : text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()), name_(std::move(name)) {}

void Source::fail_in_text(std::size_t offset, std::string message, std::string hint) const {
    // LF, CRLF and CR each end a line.
    std::size_t line = 1;
    std::size_t start = 0;
    for (std::size_t i = 0; i < offset; ++i) {
        const bool carriage_return = text_[i] == '\r' && (i + 1 == text_.size() || text_[i + 1] != '\n');
        if (text_[i] != '\n' && !carriage_return) continue;
        ++line;
        start = i + 1;
    }
    const Location where{name_, clamped(line), clamped(offset - start + 1), {}};
    throw Error(ErrorKind::input,
                {{Severity::error, where, std::move(message), std::move(hint), shown_line(text_, start)}});
}

void Source::fail_at_byte(std::size_t offset, std::string message, std::string hint) const {
    throw Error(ErrorKind::input, std::move(message), std::move(hint), Location{name_, 0, 0, offset});
}

std::string quoted_word(std::string_view word) {
    std::string shown(word.substr(0, max_word));
    std::replace_if(
        shown.begin(), shown.end(), [](char c) { return !printable(c); }, '?');
    return "'" + shown + (word.size() > max_word ? "…'" : "'");
}

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates,
                       std::string otherwise) {
    const auto nearest = nearest_name(std::string(word.substr(0, 2 * max_word)), candidates);
    return nearest ? "did you mean '" + *nearest + "'?" : std::move(otherwise);
}

} // namespace glint::formats::ply
