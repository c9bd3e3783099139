// Text edits that set a value in TOML.

#include "formats/scene/document_edit.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace glint::formats {
namespace {

using Kind = TreeValue::Kind;

/// How a table is written in the file.
enum class Writing {
    header, ///< [camera], [[light]], and tables implied by [material.glass]
    braces, ///< { … }
    dotted  ///< by dotted keys: whitted.max_depth = 3
};

class Inserter {
  public:
    Inserter(const SceneSource& source, const TreeValue& root)
        : source_(source), root_(root), text_(source.text()) {
        const std::size_t end = text_.find('\n');
        line_end_ = end != std::string_view::npos && end > 0 && text_[end - 1] == '\r' ? "\r\n" : "\n";
    }

    TextEdit insert(const KeyTarget& target, std::string_view value) const {
        const TreeValue& table = *target.table;
        const std::string statement = target.key + " = " + std::string(value);
        if (target.spec->form == TableForm::root) return insert_at_top(statement);
        if (table.where.line == 0) return append_table(target.spec->header(), statement);
        const std::size_t start = source_.offset(table.where);
        switch (writing(table)) {
        case Writing::header: {
            const auto last = last_own(table);
            return last ? line_after(last->end, indent(last->begin) + statement)
                        : line_after(start, indent(start) + statement);
        }
        case Writing::braces:
            return insert_in_braces(table, statement);
        case Writing::dotted:
            break;
        }
        return insert_beside(table, statement);
    }

  private:
    /// Where a key starts and its value ends.
    struct Extent {
        std::size_t begin;
        std::size_t end;
    };

    Writing writing(const TreeValue& table) const {
        const char first = text_[source_.offset(table.where)];
        return first == '[' ? Writing::header : first == '{' ? Writing::braces : Writing::dotted;
    }

    bool stands_under_headers(const TreeValue& value) const {
        if (value.kind == Kind::table) return writing(value) == Writing::header;
        return value.kind == Kind::list && !value.items.empty() && value.items[0].kind == Kind::table &&
               writing(value.items[0]) == Writing::header;
    }

    /// The last key of the table written under its own header, or as a dotted key.
    std::optional<Extent> last_own(const TreeValue& table) const {
        std::optional<Extent> last;
        for (const TreeEntry& entry : table.entries) {
            if (entry.where.line == 0 || stands_under_headers(entry.value)) continue;
            const bool dotted = entry.value.kind == Kind::table && writing(entry.value) == Writing::dotted;
            const auto own =
                dotted ? last_own(entry.value)
                       : std::optional(Extent{source_.offset(entry.where), source_.offset(entry.value.end)});
            if (own && (!last || own->end > last->end)) last = own;
        }
        return last;
    }

    std::size_t line_start(std::size_t at) const { return text_.rfind('\n', at == 0 ? 0 : at - 1) + 1; }

    std::string indent(std::size_t at) const {
        const std::size_t start = at == 0 ? 0 : line_start(at);
        const std::size_t end = std::min(text_.find_first_not_of(" \t", start), text_.size());
        return std::string(text_.substr(start, end - start));
    }

    /// Inserts a line after the one that contains the byte.
    TextEdit line_after(std::size_t at, const std::string& line) const {
        const std::size_t end = text_.find('\n', at);
        if (end == std::string_view::npos) return {text_.size(), text_.size(), line_end_ + line};
        return {end + 1, end + 1, line + line_end_};
    }

    TextEdit append_table(const std::string& header, const std::string& statement) const {
        std::string before;
        if (!text_.empty()) before = text_.ends_with('\n') ? line_end_ : line_end_ + line_end_;
        return {text_.size(), text_.size(), before + header + line_end_ + statement + line_end_};
    }

    /// Inserts after the top-level keys or, if there are none, after the initial comments.
    TextEdit insert_at_top(const std::string& statement) const {
        if (const auto last = last_own(root_)) return line_after(last->end, statement);
        std::size_t at = 0;
        while (at < text_.size() && text_[at] == '#')
            at = std::min(text_.find('\n', at), text_.size() - 1) + 1;
        const bool open_end = at > 0 && text_[at - 1] != '\n';
        return {at, at, (open_end ? line_end_ : "") + statement + line_end_};
    }

    TextEdit insert_in_braces(const TreeValue& table, const std::string& statement) const {
        if (const auto last = last_own(table)) return {last->end, last->end, ", " + statement};
        return {source_.offset(table.where), source_.offset(table.end), "{ " + statement + " }"};
    }

    /// Inserts after the first dotted key, with the same prefix.
    TextEdit insert_beside(const TreeValue& table, const std::string& statement) const {
        const TreeEntry* first = &table.entries.front();
        const TreeValue* leaf = &first->value;
        while (leaf->kind == Kind::table && writing(*leaf) == Writing::dotted)
            leaf = &leaf->entries.front().value;
        const std::size_t key = source_.offset(first->where), end = source_.offset(leaf->end);
        if (in_braces(root_, key)) {
            const std::size_t start = source_.offset(table.where);
            return {end, end, ", " + std::string(text_.substr(start, key - start)) + statement};
        }
        const std::size_t start = key == 0 ? 0 : line_start(key);
        return line_after(end, std::string(text_.substr(start, key - start)) + statement);
    }

    bool in_braces(const TreeValue& table, std::size_t at) const {
        return std::any_of(table.entries.begin(), table.entries.end(),
                           [&](const TreeEntry& entry) { return value_in_braces(entry.value, at); });
    }

    bool value_in_braces(const TreeValue& value, std::size_t at) const {
        if (value.where.line == 0) return false;
        if (value.kind == Kind::table && writing(value) == Writing::braces)
            return source_.offset(value.where) < at && at < source_.offset(value.end);
        if (value.kind == Kind::table) return in_braces(value, at);
        return std::any_of(value.items.begin(), value.items.end(),
                           [&](const TreeValue& item) { return value_in_braces(item, at); });
    }

    const SceneSource& source_;
    const TreeValue& root_;
    std::string_view text_;
    std::string line_end_;
};

} // namespace

TextEdit edit_for(const SceneSource& source, const TreeValue& root, const KeyTarget& target,
                  std::string_view value) {
    if (const TreeEntry* entry = target.table->find(target.key))
        return {source.offset(entry->value.where), source.offset(entry->value.end), std::string(value)};
    return Inserter(source, root).insert(target, value);
}

std::string_view text_of(const SceneSource& source, const TreeValue& value) {
    const std::size_t begin = source.offset(value.where);
    return source.text().substr(begin, source.offset(value.end) - begin);
}

bool same_value(const TreeValue& a, const TreeValue& b) {
    if (a.kind == Kind::integer && b.kind == Kind::integer) return a.integer == b.integer;
    if (a.is_number() && b.is_number())
        return a.number == b.number && std::signbit(a.number) == std::signbit(b.number);
    if (a.kind != b.kind || a.boolean != b.boolean || a.text != b.text) return false;
    if (a.items.size() != b.items.size() || a.entries.size() != b.entries.size()) return false;
    for (std::size_t i = 0; i < a.items.size(); ++i)
        if (!same_value(a.items[i], b.items[i])) return false;
    return std::all_of(a.entries.begin(), a.entries.end(), [&](const TreeEntry& entry) {
        const TreeEntry* other = b.find(entry.key);
        return other && same_value(entry.value, other->value);
    });
}

} // namespace glint::formats
