#pragma once
// The tree of values of a scene file with source positions, and the list of problems.

#include "glint/error.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glint::formats {

/// Source position of a value: in the file (origin 0), or in an override (origin 1, 2, …; without line).
struct SourcePos {
    int origin = 0;
    int line = 0;
    int column = 0; ///< in characters, not bytes, from 1

    friend bool operator==(const SourcePos&, const SourcePos&) = default;
    friend auto operator<=>(const SourcePos&, const SourcePos&) = default;
};

struct TreeEntry;

/// A value of a scene file.
struct TreeValue {
    enum class Kind { boolean, integer, number, text, date, list, table };

    Kind kind = Kind::table;
    bool boolean = false;
    std::int64_t integer = 0;
    double number = 0; ///< of integers too
    std::string text;
    std::vector<TreeValue> items;   ///< of a list
    std::vector<TreeEntry> entries; ///< of a table, in the order of the file
    SourcePos where;
    SourcePos end; ///< after the last character; of values, not of tables with headers

    /// The entry with that name; null if there is none.
    const TreeEntry* find(std::string_view key) const;
    TreeEntry* find(std::string_view key);
    bool is_number() const { return kind == Kind::integer || kind == Kind::number; }
    /// "a boolean", "an integer", … for messages.
    std::string_view kind_words() const;
};

struct TreeEntry {
    std::string key;
    SourcePos where; ///< of the key
    TreeValue value;
};

/// Text and overrides of a scene; converts positions to locations and excerpts.
class SceneSource {
  public:
    /// Skips a byte order mark. The text must outlive this object and be below 4 GiB.
    SceneSource(std::string_view text, std::string name, std::vector<std::string> overrides);

    const std::string& name() const { return name_; }
    std::string_view text() const { return text_; }
    const std::vector<std::string>& overrides() const { return overrides_; }

    /// The location of a position, with columns in bytes; an override's location has its text as the file.
    Location locate(const SourcePos& pos) const;
    /// Offset in text() of a position.
    std::size_t offset(const SourcePos& pos) const;
    /// The line of a position for display; empty if there is none or it is too long.
    std::string excerpt(const SourcePos& pos) const;

    /// A line, from 1, without its end; empty if there is none.
    std::string_view line(int number) const;

  private:
    std::size_t byte_of(const SourcePos& pos) const;

    std::string_view text_;
    std::string name_;
    std::vector<std::string> overrides_;
    std::vector<std::size_t> line_starts_;
    std::vector<std::uint32_t> continuations_; ///< offsets of the bytes that do not start a character
};

/// Collects problems of a scene, to report all at once.
class Problems {
  public:
    explicit Problems(const SceneSource& source) : source_(source) {}

    void error(const SourcePos& pos, std::string message, std::string hint = {});
    /// Adds a problem of another file that is referred to at this position.
    void error_elsewhere(const SourcePos& named_at, Diagnostic diagnostic);
    void warning(const SourcePos& pos, std::string message, std::string hint = {});
    /// did_you_mean(), or `otherwise` if nothing is near, or after so many errors that searching would take
    /// long.
    std::string suggestion(std::string_view word, const std::vector<std::string>& candidates,
                           std::string otherwise = {}) const;

    Location locate(const SourcePos& pos) const { return source_.locate(pos); }
    bool any_error() const { return !errors_.empty(); }
    /// Throws Error(input) with all errors in order of position, if any.
    void throw_if_any() const;
    /// The warnings in order of position.
    std::vector<Diagnostic> warnings() const;

  private:
    struct Problem {
        SourcePos pos;
        Diagnostic diagnostic;
    };
    void add(std::vector<Problem>& list, Severity severity, const SourcePos& pos, std::string message,
             std::string hint) const;
    static std::vector<Diagnostic> in_order(std::vector<Problem> list);

    const SceneSource& source_;
    std::vector<Problem> errors_;
    std::vector<Problem> warnings_;
    std::size_t unlisted_ = 0;
};

/// Parses a TOML document. Throws Error(input) at its first syntax error.
TreeValue parse_tree(const SceneSource& source);

/// Parses a TOML value as written after a key; none if invalid. All positions are `where` except the end of
/// the value in the text, which a comment may follow.
std::optional<TreeValue> parse_tree_value(std::string_view text, const SourcePos& where);

} // namespace glint::formats
