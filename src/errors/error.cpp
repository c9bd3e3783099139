// Errors as text, and the nearest of several names.

#include "glint/error.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace glint {
namespace {

// The caret stands under the column; tabs before it are kept, so that it does on any terminal.
std::string caret_line(const std::string& excerpt, int column) {
    std::string pad;
    const auto length = static_cast<std::size_t>(std::max(column - 1, 0));
    for (const char character : printable(std::string_view(excerpt).substr(0, length), "\t")) {
        const auto byte = static_cast<unsigned char>(character);
        const bool continues_utf8 = (byte & 0xc0u) == 0x80u;
        if (!continues_utf8) pad += byte == '\t' ? '\t' : ' ';
    }
    return pad + "^";
}

std::string all_texts(const std::vector<Diagnostic>& diagnostics) {
    std::string text;
    for (const Diagnostic& d : diagnostics) {
        if (!text.empty()) text += '\n';
        text += to_string(d);
    }
    return text;
}

std::string lower(std::string word) {
    for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return word;
}

// Edits to turn a into b, two neighbouring letters swapped counting as one (optimal string alignment).
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> before(b.size() + 1), row(b.size() + 1), next(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        next[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = row[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            next[j] = std::min({row[j] + 1, next[j - 1] + 1, change});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) next[j] = std::min(next[j], before[j - 2] + 1);
        }
        before = row;
        row = next;
    }
    return row[b.size()];
}

} // namespace

std::string printable(std::string_view text, std::string_view kept) {
    constexpr const char* digits = "0123456789abcdef";
    std::string shown;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        // U+0080 to U+009F are two bytes in UTF-8.
        const bool second = byte == 0xc2u && i + 1 < text.size() &&
                            static_cast<unsigned char>(text[i + 1]) >= 0x80u &&
                            static_cast<unsigned char>(text[i + 1]) < 0xa0u;
        const bool control = second || byte < 0x20u || byte == 0x7fu;
        if (!control || kept.find(text[i]) != std::string_view::npos) {
            shown += text[i];
            continue;
        }
        const auto code = second ? static_cast<unsigned char>(text[++i]) : byte;
        shown += std::string("\\u00") + digits[code >> 4u] + digits[code & 15u];
    }
    return shown;
}

std::string to_string(const Location& location) {
    std::string text = printable(location.file);
    if (location.line > 0) text += ":" + std::to_string(location.line);
    if (location.line > 0 && location.column > 0) text += ":" + std::to_string(location.column);
    if (location.byte) text += ": byte " + std::to_string(*location.byte);
    return text;
}

std::string to_string(const Diagnostic& diagnostic) {
    std::string text = to_string(diagnostic.location);
    if (!text.empty()) text += ": ";
    text += diagnostic.severity == Severity::error ? "error: " : "warning: ";
    text += printable(diagnostic.message, "\n");
    if (!diagnostic.excerpt.empty()) {
        text += "\n    " + printable(diagnostic.excerpt, "\t");
        if (diagnostic.location.column > 0)
            text += "\n    " + caret_line(diagnostic.excerpt, diagnostic.location.column);
    }
    if (!diagnostic.hint.empty()) text += "\n    " + printable(diagnostic.hint, "\n");
    return text;
}

Error::Error(ErrorKind kind, std::string message, std::string hint, Location location)
    : Error(kind, std::vector<Diagnostic>{
                      {Severity::error, std::move(location), std::move(message), std::move(hint), {}}}) {}

Error::Error(ErrorKind kind, std::vector<Diagnostic> diagnostics)
    : kind_(kind), diagnostics_(std::move(diagnostics)), text_(all_texts(diagnostics_)) {}

std::optional<std::string> nearest_name(const std::string& word, const std::vector<std::string>& candidates) {
    if (word.empty() || word.size() > 64) return std::nullopt;
    const std::string wanted = lower(word);
    std::optional<std::string> best;
    std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string& candidate : candidates) {
        if (candidate.size() > 2 * word.size() + 4) continue;
        const std::size_t distance = edit_distance(wanted, lower(candidate));
        if (distance < best_distance) {
            best_distance = distance;
            best = candidate;
        }
    }
    return best;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates,
                         std::string otherwise) {
    const auto nearest = nearest_name(word, candidates);
    return nearest ? "did you mean \"" + printable(*nearest) + "\"?" : std::move(otherwise);
}

} // namespace glint
