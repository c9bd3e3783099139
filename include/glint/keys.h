#pragma once
// The keys of scene files, each bound to the member of a description that it sets. Reading, writing, checks,
// the reference page, metadata and the rows of the window run over these tables.

#include "glint/scene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <typeinfo>
#include <variant>
#include <vector>

namespace glint {

/// The form of a key's value.
enum class KeyType {
    boolean,
    whole_number,
    number,
    number_or_auto,       ///< a number, or the text "auto"
    whole_number_or_auto, ///< the same, of whole numbers
    choice,               ///< one of KeySpec::choices
    text,                 ///< not empty
    file,                 ///< the name of a file
    size,                 ///< [width, height] in pixels
    point,                ///< [x, y, z] within ±10^12
    direction,            ///< [x, y, z], not zero; its length does not matter
    rgb,                  ///< [r, g, b] of plain numbers ≥ 0
    color,                ///< rgb, "#rrggbb" or a name
    lengths,              ///< [x, y, z], each above 0
    scale,                ///< a number or [x, y, z], none of them 0
    vertices,             ///< three points
    matrix,               ///< 16 numbers by rows, affine and regular
    transform,            ///< a list of tables, applied in order
    key_path,             ///< as -D names one value of the scene
    frame_range,          ///< [first, last], integers
    frames,               ///< ascending numbers, at least one
    values,               ///< a list of values of another key
};

/// The allowed numbers, both ends included unless open.
struct NumberRange {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_open = false;
    bool high_open = false;

    bool contains(double x) const {
        return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high);
    }
    /// "at least 0", "above 0 and at most 90", "between 0 and 1"; empty where everything is allowed.
    std::string text() const;
};

/// One of KeySpec::choices.
struct Choice {
    std::size_t index = 0;
    friend bool operator==(const Choice&, const Choice&) = default;
};

/// The value of a key; std::uint64_t only beyond the other integers. Empty: the owner has no such member.
using KeyValue = std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double,
                              std::optional<double>, std::optional<std::int64_t>, Choice, std::string,
                              std::array<int, 2>, Vec3, std::array<Vec3, 3>, Mat4, std::vector<double>>;

/// Refers to the struct whose members keys set: a Material, an Object, a Light, …
class KeyOwner {
  public:
    template <class T>
    requires(!std::is_same_v<std::remove_const_t<T>, KeyOwner>) explicit KeyOwner(T& value)
        : type_(&typeid(T)), value_(const_cast<std::remove_const_t<T>*>(&value)),
          is_const_(std::is_const_v<T>) {}

    /// Null if the owner is of another type, or is const where T is not.
    template <class T>
    T* as() const {
        if (*type_ != typeid(T) || (is_const_ && !std::is_const_v<T>)) return nullptr;
        return static_cast<T*>(value_);
    }

  private:
    const std::type_info* type_;
    void* value_;
    bool is_const_;
};

/// One key of one table.
struct KeySpec {
    std::string_view key;
    KeyType type = KeyType::number;
    std::string_view unit = {};
    NumberRange range = {}; ///< of numbers
    NumberRange limits =
        {}; ///< of numbers that the renderer can compute with: beyond the range, for extremes
    NumberRange typical = {}; ///< of numbers, for sliders
    bool logarithmic = false; ///< sliders are
    bool required = false;
    bool in_metadata = true;           ///< of pictures; for keys of settings
    std::string_view alternative = {}; ///< a key that stands for this one; both are an error
    std::span<const std::string_view> choices = {};
    std::vector<std::string_view> types = {}; ///< the types of the table that have this key; empty: all
    std::string_view help = {};

    /// The value of the member; null for keys that are read only and written as their alternative.
    KeyValue (*get)(const KeyOwner&) = nullptr;
    /// Sets the member, where the owner has it; null for keys that are read elsewhere.
    void (*set)(const KeyOwner&, const KeyValue&) = nullptr;
    /// The value that the member's initializer gives; null where the key has no default.
    KeyValue (*initial)() = nullptr;

    bool belongs_to(std::string_view table_type) const;
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
    std::string_view name = {};
    TableForm form = TableForm::one;
    bool object = false;            ///< something that rays hit
    std::string_view selector = {}; ///< the key that chooses the table's type
    std::string_view help = {};
    std::vector<KeySpec> keys;

    /// "[camera]", "[material.glass]", "[[sphere]]".
    std::string header(std::string_view name_of_it = "NAME") const;
};

/// The tables of what a description holds, in the order of the reference page: [camera] … [[light]].
const std::vector<TableSpec>& description_tables();

/// One of them; throws std::out_of_range if there is none of that name.
const TableSpec& description_table(std::string_view name);

/// Calls use(name of the table, struct) for the tables of settings that a description always has.
template <class Description, class Use>
void for_settings(Description& description, const Use& use) {
    use("render", description.render);
    use("whitted", description.whitted);
    use("path", description.path);
    use("ambient_occlusion", description.ambient_occlusion);
}

/// The key of a table of that type; an empty type finds the keys of any. Null if there is none.
const KeySpec* find_key(const TableSpec& table, std::string_view key, std::string_view type);

/// A value in plain text, as metadata and panels show it: "640x480", "whitted", "1.5", "(0, 0, 1)".
std::string plain_text(const KeySpec& key, const KeyValue& value);

} // namespace glint
