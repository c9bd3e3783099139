#pragma once
// Reads one table of a scene file as its row of the key table says.

#include "formats/colors.h"
#include "formats/key_table.h"
#include "formats/scene_tree.h"
#include "glint/scene.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// What reading needs to know besides the table at hand.
struct ReadContext {
    Problems& problems;
    ColorValues colors = ColorValues::srgb;
    bool patch = false; ///< keys change values that exist already: none is required
};

/// One table while it is read. The constructor reports unknown and missing keys and keys that exclude each
/// other; each read() reports a wrong type or range and else sets its target. A target stays as it is where
/// the key is absent or wrong. Every key of the specification is to be read once.
class TableReader {
  public:
    /// `label` names the table in messages: "[[sphere]]". `type` is its selector's value, empty if unknown.
    TableReader(const TreeValue& table, const TableSpec& spec, std::string label, std::string type,
                const ReadContext& context);

    bool has(std::string_view key) const { return table_.find(key) != nullptr; }
    /// Where the key's value stands, or the table's header where it is absent.
    Place place(std::string_view key) const;
    Place header() const { return table_.where; }
    /// True while nothing was wrong with this table.
    bool good() const { return good_; }

    void read(std::string_view key, bool& target);
    void read(std::string_view key, int& target);
    void read(std::string_view key, std::uint64_t& target);
    void read(std::string_view key, double& target);
    void read(std::string_view key, std::string& target);
    /// A point, direction, colour, lengths or scale.
    void read(std::string_view key, Vec3& target);
    void read(std::string_view key, std::array<Vec3, 3>& target);
    void read(std::string_view key, Mat4& target);
    /// "auto" empties the target.
    void read(std::string_view key, std::optional<double>& target);
    void read_size(std::string_view key, int& width, int& height);
    /// [first, last], the last not before the first.
    void read_range(std::string_view key, int& first, int& last);
    /// Numbers in ascending order, at least one.
    void read_ascending(std::string_view key, std::vector<double>& target);
    /// An enumeration whose values stand in the order of the key's choices.
    template <class Enum>
    void read_choice(std::string_view key, Enum& target) {
        if (const auto index = choice(key)) target = static_cast<Enum>(*index);
    }
    /// The chosen word itself.
    void read_choice(std::string_view key, std::string& target);
    /// The list itself, for values that are read elsewhere; null where it is absent or no list.
    const TreeValue* list(std::string_view key);

    /// Reports what is wrong with this table beyond single values.
    void error(const Place& place, std::string message, std::string hint = {});

  private:
    struct Found {
        const KeySpec* spec = nullptr;
        const TreeValue* value = nullptr; ///< null: absent
    };
    Found find(std::string_view key) const;
    void check_known();
    void check_required();
    void wrong_type(const Found& found, const TreeValue& value, std::string_view expected);
    bool check_number(const Found& found, const TreeValue& value);
    bool check_integer(const Found& found, const TreeValue& value);
    bool check_numbers(const Found& found, const TreeValue& value, std::size_t count);
    std::optional<Vec3> vector(const Found& found, const TreeValue& value);
    std::optional<Vec3> color(const Found& found);
    std::optional<std::size_t> choice(std::string_view key);

    const TreeValue& table_;
    const TableSpec& spec_;
    std::string label_;
    std::string type_;
    const ReadContext& context_;
    bool good_ = true;
};

/// The value of a table's selector ("kind", "type"), reporting none; empty if absent or wrong.
std::string selected_type(const TreeValue& table, const TableSpec& spec);

} // namespace glint
