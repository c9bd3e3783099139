// The only file that knows the TOML library.

#include "formats/scene_tree.h"

#include "formats/scene_words.h"

#include <algorithm>

// Scene files nest four deep; the limit keeps recursion over hostile files shallow.
#define TOML_EXCEPTIONS 0
#define TOML_MAX_NESTED_VALUES 32
#include <toml++/toml.h>

namespace glint {
namespace {

constexpr int deepest_key = 16; ///< parts of a dotted key

Place place_of(const toml::source_position& position) {
    return {0, static_cast<int>(position.line), static_cast<int>(position.column)};
}

[[noreturn]] void throw_at(const SceneSource& source, const Place& place, std::string message,
                           std::string hint = {}) {
    Problems problems(source);
    problems.error(place, std::move(message), std::move(hint));
    problems.throw_if_any();
    throw Error(ErrorKind::internal, "a syntax error got lost");
}

/// What the library must not be given, and where.
struct Offence {
    std::size_t byte;
    std::string message;
    std::string hint;
};

// Walks over TOML text just well enough to tell strings and comments from the rest, and finds what the
// library (3.3) cannot bear: it recurses over dotted keys without a limit, and its test for white space is
// undefined for some characters beyond ASCII, which TOML allows in strings and comments alone.
class TextCheck {
  public:
    explicit TextCheck(std::string_view text) : text_(text) {}

    std::optional<Offence> run() {
        while (at_ < text_.size() && !found_) {
            const char c = text_[at_];
            if (c == '#')
                at_ = std::min(text_.find('\n', at_), text_.size());
            else if (c == '"' || c == '\'')
                skip_string(c);
            else
                check_plain(c);
        }
        return std::move(found_);
    }

  private:
    static bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80u; }

    void check_plain(char c) {
        if (!is_ascii(c))
            found_ = {at_, "a character beyond ASCII outside of strings and comments",
                      "names with such letters stand between quotes, like \"this\""};
        if (c == '.' && ++dots_ >= deepest_key)
            found_ = {at_, "a dotted key of more than " + std::to_string(deepest_key) + " parts", {}};
        if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) dots_ = 0;
        ++at_;
    }

    void skip_string(char quote) {
        const std::string fence(3, quote);
        const bool multiline = text_.substr(at_, 3) == fence;
        at_ += multiline ? 3 : 1;
        while (at_ < text_.size() && !found_) {
            if (quote == '"' && text_[at_] == '\\')
                skip_escape(multiline);
            else if (multiline ? text_.substr(at_, 3) == fence : text_[at_] == quote || text_[at_] == '\n')
                break;
            else
                ++at_;
        }
        at_ = std::min(at_ + (multiline ? 3 : 1), text_.size());
    }

    void skip_escape(bool multiline) {
        const std::size_t backslash = at_++;
        // In long strings a backslash swallows the white space after it, by the test in question.
        const std::size_t next = multiline ? text_.find_first_not_of(" \t\r\n", at_) : at_;
        if (multiline && next < text_.size() && !is_ascii(text_[next]))
            found_ = {backslash, "a backslash before a character beyond ASCII", "write the text in one line"};
        at_ = next == at_ ? at_ + 1 : std::min(next, text_.size());
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int dots_ = 0;
    std::optional<Offence> found_;
};

Place place_of_byte(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, byte);
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const std::size_t start = before.rfind('\n') + 1; // npos + 1 is 0
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u; };
    const auto wide =
        std::count_if(before.begin() + static_cast<std::ptrdiff_t>(start), before.end(), continues);
    return {0, static_cast<int>(lines) + 1, static_cast<int>(byte - start) + 1 - static_cast<int>(wide)};
}

void refuse_what_is_no_text(const SceneSource& source) {
    const std::string_view text = source.text();
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        throw_at(source, {0, 1, 1}, "the file is UTF-16", "save it as UTF-8");
    const std::size_t zero = text.find('\0');
    if (zero != std::string_view::npos)
        throw_at(source, place_of_byte(text, zero), "a zero byte: this is not a text file",
                 "expected a scene file (TOML) or a PLY mesh");
    if (auto offence = TextCheck(text).run())
        throw_at(source, place_of_byte(text, offence->byte), std::move(offence->message),
                 std::move(offence->hint));
}

TreeValue tree_of(const toml::node& node);

TreeValue tree_of_table(const toml::table& table) {
    TreeValue tree;
    tree.entries.reserve(table.size());
    for (const auto& [key, value] : table)
        tree.entries.push_back({std::string(key.str()), place_of(key.source().begin), tree_of(value)});
    // The library walks tables by name; people read them by place.
    std::stable_sort(tree.entries.begin(), tree.entries.end(),
                     [](const TreeEntry& a, const TreeEntry& b) { return a.where < b.where; });
    return tree;
}

TreeValue tree_of(const toml::node& node) {
    TreeValue tree;
    if (const auto* table = node.as_table())
        tree = tree_of_table(*table);
    else if (const auto* list = node.as_array()) {
        tree.kind = TreeValue::Kind::list;
        tree.items.reserve(list->size());
        for (const toml::node& item : *list) tree.items.push_back(tree_of(item));
    } else if (const auto* text = node.as_string()) {
        tree.kind = TreeValue::Kind::text;
        tree.text = text->get();
    } else if (const auto* integer = node.as_integer()) {
        tree.kind = TreeValue::Kind::integer;
        tree.integer = integer->get();
        tree.number = static_cast<double>(tree.integer);
    } else if (const auto* number = node.as_floating_point()) {
        tree.kind = TreeValue::Kind::number;
        tree.number = number->get();
    } else if (const auto* boolean = node.as_boolean()) {
        tree.kind = TreeValue::Kind::boolean;
        tree.boolean = boolean->get();
    } else
        tree.kind = TreeValue::Kind::date;
    tree.where = place_of(node.source().begin);
    return tree;
}

// "Error while parsing string: unescaped …" → "syntax error in string: unescaped …"
std::string syntax_message(std::string_view description) {
    constexpr std::string_view start = "Error while parsing ";
    const std::size_t aside = description.find(" (TOML_");
    description = description.substr(0, aside);
    if (description.starts_with(start))
        return "syntax error in " + std::string(description.substr(start.size()));
    return "syntax error: " + std::string(description);
}

void move_all(TreeValue& tree, const Place& where) {
    tree.where = where;
    for (TreeValue& item : tree.items) move_all(item, where);
    for (TreeEntry& entry : tree.entries) {
        entry.where = where;
        move_all(entry.value, where);
    }
}

} // namespace

TreeValue parse_tree(const SceneSource& source) {
    refuse_what_is_no_text(source);
    const toml::parse_result result = toml::parse(source.text(), std::string_view{});
    if (!result)
        throw_at(source, place_of(result.error().source().begin),
                 syntax_message(result.error().description()));
    return tree_of_table(result.table());
}

std::optional<TreeValue> parse_tree_value(std::string_view text, const Place& where) {
    // A line break would let a value bring further keys along.
    if (text.find_first_of(std::string_view("\n\r\0", 3)) != std::string_view::npos) return std::nullopt;
    const std::string document = "value = " + std::string(text);
    if (TextCheck(document).run()) return std::nullopt;
    const toml::parse_result result = toml::parse(std::string_view(document), std::string_view{});
    if (!result || result.table().size() != 1) return std::nullopt;
    TreeValue tree = tree_of(*result.table().get("value"));
    move_all(tree, where);
    return tree;
}

} // namespace glint
