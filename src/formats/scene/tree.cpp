// Source positions and problems.

#include "formats/scene/tree.h"

#include "scene/text.h"

#include <algorithm>

namespace glint::formats {
namespace {

constexpr std::size_t longest_list = 1000;
constexpr std::size_t max_excerpt = 240;

// Length of the UTF-8 character that starts with this byte, if well formed.
std::size_t utf8_length(std::string_view text, std::size_t at) {
    std::size_t end = at + 1;
    while (end < text.size() && scene::continues_utf8(text[end])) ++end;
    return end - at;
}

// Whether the bytes form one UTF-8 character, judged by the leading bits.
bool well_formed(std::string_view character) {
    const auto first = static_cast<unsigned char>(character[0]);
    if (first < 0x80u) return character.size() == 1;
    if ((first & 0xe0u) == 0xc0u) return character.size() == 2;
    if ((first & 0xf0u) == 0xe0u) return character.size() == 3;
    return (first & 0xf8u) == 0xf0u && character.size() == 4;
}

} // namespace

const TreeEntry* TreeValue::find(std::string_view key) const {
    for (const TreeEntry& entry : entries)
        if (entry.key == key) return &entry;
    return nullptr;
}

TreeEntry* TreeValue::find(std::string_view key) {
    return const_cast<TreeEntry*>(static_cast<const TreeValue*>(this)->find(key));
}

std::string_view TreeValue::kind_words() const {
    constexpr std::string_view words[] = {"a boolean",      "an integer", "a number", "a string",
                                          "a date or time", "a list",     "a table"};
    return words[static_cast<std::size_t>(kind)];
}

SceneSource::SceneSource(std::string_view text, std::string name, std::vector<std::string> overrides)
    : text_(text), name_(std::move(name)), overrides_(std::move(overrides)) {
    if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
    line_starts_.push_back(0);
    for (std::size_t i = 0; i < text_.size(); ++i) {
        if (text_[i] == '\n') line_starts_.push_back(i + 1);
        if (scene::continues_utf8(text_[i])) continuations_.push_back(static_cast<std::uint32_t>(i));
    }
}

std::string_view SceneSource::line(int number) const {
    if (number < 1 || static_cast<std::size_t>(number) > line_starts_.size()) return {};
    const auto next = static_cast<std::size_t>(number);
    const std::size_t begin = line_starts_[next - 1];
    const std::size_t end = next < line_starts_.size() ? line_starts_[next] - 1 : text_.size();
    std::string_view text = text_.substr(begin, end - begin);
    if (text.ends_with('\r')) text.remove_suffix(1);
    return text;
}

// Binary search: a malicious file may have a million positions on one line.
std::size_t SceneSource::byte_of(const SourcePos& pos) const {
    const std::string_view text = line(pos.line);
    if (text.empty()) return 0;
    const auto start = static_cast<std::size_t>(text.data() - text_.data());
    const auto before = static_cast<std::size_t>(std::max(pos.column, 1) - 1); // characters
    const auto first = std::lower_bound(continuations_.begin(), continuations_.end(), start);

    // The k-th continuation byte of the line has its offset − k other bytes before it, which increases with
    // k.
    std::size_t low = 0, high = static_cast<std::size_t>(continuations_.end() - first);
    while (low < high) {
        const std::size_t k = low + (high - low) / 2;
        const bool within = first[static_cast<std::ptrdiff_t>(k)] - start - k <= before;
        (within ? low : high) = within ? k + 1 : k;
    }
    // Clamp positions beyond the end of the line, as the library reports for the end of the file.
    return std::min(before + low, text.size());
}

std::size_t SceneSource::offset(const SourcePos& pos) const {
    const auto number = static_cast<std::size_t>(pos.line);
    if (number < 1 || number > line_starts_.size()) return text_.size();
    return line_starts_[number - 1] + byte_of(pos);
}

Location SceneSource::locate(const SourcePos& pos) const {
    if (pos.origin > 0) return {"-D " + overrides_[static_cast<std::size_t>(pos.origin) - 1], 0, 0, {}};
    if (pos.line <= 0) return {name_, 0, 0, {}};
    return {name_, pos.line, static_cast<int>(byte_of(pos)) + 1, {}};
}

std::string SceneSource::excerpt(const SourcePos& pos) const {
    if (pos.origin > 0) return {};
    std::string_view text = line(pos.line);
    if (text.size() > max_excerpt) {
        // No excerpt for positions far from the start, whose caret would be misplaced.
        if (locate(pos).column > static_cast<int>(max_excerpt) / 2) return {};
        text = text.substr(0, max_excerpt);
    }
    std::string shown(text);
    for (std::size_t i = 0; i < shown.size();) {
        const std::size_t length = utf8_length(shown, i);
        const auto first = static_cast<unsigned char>(shown[i]);
        const bool control = (first < 0x20 && first != '\t') || first == 0x7f;
        if (control || !well_formed(std::string_view(shown).substr(i, length)))
            std::fill_n(shown.begin() + static_cast<std::ptrdiff_t>(i), length, '?');
        i += length;
    }
    return shown;
}

void Problems::add(std::vector<Problem>& list, Severity severity, const SourcePos& pos, std::string message,
                   std::string hint) const {
    list.push_back(
        {pos, {severity, source_.locate(pos), std::move(message), std::move(hint), source_.excerpt(pos)}});
}

void Problems::error(const SourcePos& pos, std::string message, std::string hint) {
    if (errors_.size() < longest_list)
        add(errors_, Severity::error, pos, std::move(message), std::move(hint));
    else
        ++unlisted_;
}

void Problems::error_elsewhere(const SourcePos& named_at, Diagnostic diagnostic) {
    errors_.push_back({named_at, std::move(diagnostic)});
}

void Problems::warning(const SourcePos& pos, std::string message, std::string hint) {
    if (warnings_.size() < longest_list)
        add(warnings_, Severity::warning, pos, std::move(message), std::move(hint));
}

std::string Problems::suggestion(std::string_view word, const std::vector<std::string>& candidates,
                                 std::string otherwise) const {
    constexpr std::size_t enough = 100;
    return errors_.size() < enough ? did_you_mean(std::string(word), candidates, std::move(otherwise))
                                   : otherwise;
}

std::vector<Diagnostic> Problems::in_order(std::vector<Problem> list) {
    std::stable_sort(list.begin(), list.end(),
                     [](const Problem& a, const Problem& b) { return a.pos < b.pos; });
    std::vector<Diagnostic> diagnostics;
    for (Problem& problem : list) diagnostics.push_back(std::move(problem.diagnostic));
    return diagnostics;
}

void Problems::throw_if_any() const {
    if (errors_.empty()) return;
    std::vector<Diagnostic> diagnostics = in_order(errors_);
    if (unlisted_ > 0)
        diagnostics.push_back({Severity::error,
                               source_.locate({}),
                               std::to_string(unlisted_) + " further errors are not listed",
                               {},
                               {}});
    throw Error(ErrorKind::input, std::move(diagnostics));
}

std::vector<Diagnostic> Problems::warnings() const { return in_order(warnings_); }

} // namespace glint::formats
