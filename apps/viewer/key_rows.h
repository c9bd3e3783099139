#pragma once
// Rows of a panel over the keys of a table: what each looks like follows from the key's type and range.

#include "file_keys.h"
#include "widgets.h"

#include "glint/keys.h"

#include <string>
#include <string_view>
#include <vector>

namespace glint::viewer {

/// What a pixel of dragging adds to numbers without a unit.
inline constexpr double share_step = 0.005;

/// Rows about one table of the scene.
class KeyRows {
  public:
    /// `path` is how -D names the table; `step` is what a pixel of dragging adds to lengths.
    KeyRows(Ui& ui, std::vector<Edit>& edits, const std::string& path, const TableSpec& table, KeyOwner owner,
            double step, const FileKeys& file)
        : rows_(ui, edits, path), path_(path), table_(table), owner_(owner), type_(type_of(table, owner)),
          step_(step), file_(file) {}

    Rows& rows() { return rows_; }

    /// The row of a key; none for names, files and what the owner does not have.
    void row(const KeySpec& key);
    void row(std::string_view key);
    /// A colour as three numbers: it may be brighter than a screen shows.
    void numbers(const KeySpec& key);
    /// A word of several that the scene gives: the names of its materials or meshes.
    void names(std::string_view key, const std::vector<std::string>& words);

  private:
    struct Visitor;

    static std::string type_of(const TableSpec& table, const KeyOwner& owner);
    void number(const KeySpec& key, double value);
    void integer(const KeySpec& key, int value);
    void vector(const KeySpec& key, const Vec3& value);
    void vertices(const KeySpec& key, const std::array<Vec3, 3>& value);

    Rows rows_;
    std::string path_;
    const TableSpec& table_;
    KeyOwner owner_;
    std::string type_; ///< of the table, by its selector
    double step_;
    const FileKeys& file_;
};

/// A factor for all directions, or one for each, as the file has it.
void scale_row(Rows& rows, const std::string& key, const std::vector<double>& written, const char* help);

} // namespace glint::viewer
