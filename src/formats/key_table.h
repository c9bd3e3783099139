#pragma once
// Every key of scene files in one table. It drives parsing, range checks, suggestions and the reference page.

#include "scene/validate.h"

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// What a key's value must be.
enum class KeyType {
    boolean,
    integer,
    number,
    number_or_auto, ///< a number, or the text "auto"
    choice,         ///< one of KeySpec::choices
    text,           ///< not empty
    file,           ///< the name of a file
    size,           ///< [width, height] in pixels
    point,          ///< [x, y, z] within ±10^12
    direction,      ///< [x, y, z], not zero; its length does not matter
    rgb,            ///< [r, g, b] of plain numbers ≥ 0
    color,          ///< rgb, "#rrggbb" or a name
    lengths,        ///< [x, y, z], each above 0
    scale,          ///< a number or [x, y, z], none of them 0
    vertices,       ///< three points
    matrix,         ///< 16 numbers by rows, affine and regular
    transform,      ///< a list of tables, applied in order
    key_path,       ///< as -D names one value of the scene
    frame_range,    ///< [first, last], integers
    frames,         ///< ascending numbers, at least one
    values,         ///< a list of values of another key
};

/// The allowed numbers, both ends included unless open.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_open = false;
    bool high_open = false;

    bool contains(double x) const {
        return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high);
    }
    /// "at least 0", "above 0 and at most 90", "between 0 and 1"; empty where everything is allowed.
    std::string words() const;
};

/// One key of one table.
struct KeySpec {
    std::string_view key;
    KeyType type = KeyType::number;
    std::string_view fallback = {}; ///< the default as it would be written; empty: none
    std::string_view unit = {};     ///< for the reference page
    Range range = {};               ///< of numbers
    bool required = false;
    std::string_view alternative = {}; ///< a key that stands for this one; both together are an error
    std::string_view choices = {};     ///< words between spaces
    std::string_view types = {}; ///< the types of the table that have this key, between spaces; empty: all
    std::string_view help = {};
};

enum class TableForm {
    root,  ///< the file itself
    one,   ///< [name]
    named, ///< [name.NAME]
    list,  ///< [[name]]
    entry, ///< an inline table in a list
};

/// One kind of table.
struct TableSpec {
    std::string_view name;
    TableForm form = TableForm::one;
    bool object = false;            ///< something that rays hit
    std::string_view selector = {}; ///< the key that tells the table's type
    std::string_view help = {};
    std::vector<KeySpec> keys;

    /// "[camera]", "[material.glass]", "[[sphere]]".
    std::string header(std::string_view name_of_it = "NAME") const;
};

/// All tables, in the order of the reference page.
const std::vector<TableSpec>& table_specs();

/// The table of that name; null if there is none. The file itself is "".
const TableSpec* find_table(std::string_view name);

/// The key of a table of that type; an empty type finds the keys of any. Null if there is none.
const KeySpec* find_key(const TableSpec& table, std::string_view key, std::string_view type);

/// The keys of a table of that type, in the order of the reference page.
std::vector<std::string> key_names(const TableSpec& table, std::string_view type);

/// "a b c" as words.
std::vector<std::string> split_words(std::string_view text);

} // namespace glint
