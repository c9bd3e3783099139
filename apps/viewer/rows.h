#pragma once
// Rows of a panel over the keys of a table of the scene: a label, a widget, and the edit that the user makes
// with it. What a row looks like follows from the key's type and range.

#include "file_keys.h"
#include "widgets.h"

#include "glint/keys.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace glint::viewer {

/// What a pixel of dragging adds to numbers without a unit.
inline constexpr double share_step = 0.005;

/// The key of a row with the texts that explain it.
struct RowText {
    std::string key;
    std::string label;
    std::string help;
};

/// Rows about one table. The map names each by its key path; changes are added to `edits`. Rows of animated
/// keys are disabled, with a tooltip that says so.
class Rows {
  public:
    /// `path` is how -D names the table; `step` is what a pixel of dragging adds to lengths.
    Rows(Ui& ui, std::vector<Edit>& edits, std::string path, const TableSpec& table, KeyOwner owner,
         double step, const FileKeys& file);

    /// The row of a key; none for names, files and what the owner does not have.
    void row(const KeySpec& key);
    void row(std::string_view key) { row(*find_key(table_, key, {})); }
    /// A colour as three numbers: it may be brighter than a screen shows.
    void numbers(const KeySpec& key);
    /// One of several names that the scene gives.
    void names(std::string_view key, const std::vector<std::string>& names);
    /// The entries of the key `transform`, as the file has them. `add_move`: if none of them moves, there is
    /// a row for one to be added.
    void transform(bool add_move);

  private:
    void begin(const RowText& text);
    void finish(const std::string& key, bool in_map = true);
    bool is_animated(const std::string& key) const;
    void set(const std::string& key, std::string value) {
        edits_.push_back({path_ + "." + key, std::move(value)});
    }
    const std::vector<double>& written(const std::string& key) const {
        return file_.numbers(path_ + "." + key);
    }

    /// Numbers to drag, without bounds; true if they were changed.
    bool drag(const RowText& text, double* values, int count, double step);
    void drag(const RowText& text, double value, double step);
    void drag(const RowText& text, Vec3 value, double step);
    /// A factor for all directions, or one for each, as the file has it.
    void scale(const RowText& text, const std::vector<double>& factors);
    void number(const KeySpec& key, double value);
    void slider(const KeySpec& key, const RowText& text, double value);
    void slider(const KeySpec& key, const RowText& text, int value);
    /// A swatch that opens a colour picker. The value is linear, the picker shows colours of the screen.
    void color(const RowText& text, const Vec3& value);
    void check(const RowText& text, bool value);
    void choice(const RowText& text, const std::string& value, const std::vector<std::string>& choices);
    void vector(const KeySpec& key, const RowText& text, const Vec3& value);
    void vertices(const RowText& text, std::array<Vec3, 3> corners);
    bool transform_entry(const std::string& entry);

    Ui& ui_;
    std::vector<Edit>& edits_;
    std::string path_;
    const TableSpec& table_;
    KeyOwner owner_;
    std::string type_; ///< of the table, by its selector
    double step_;
    const FileKeys& file_;
};

} // namespace glint::viewer
