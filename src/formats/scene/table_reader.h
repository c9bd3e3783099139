#pragma once
// Reads one table of a scene file according to the key table.

#include "formats/scene/colors.h"
#include "formats/scene/key_table.h"
#include "formats/scene/tree.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glint::formats {

/// The numbers of a list of three.
Vec3 vec3_of(const TreeValue& list);

/// Context of reading.
struct ReadContext {
    Problems& problems;
    ColorValues colors = ColorValues::srgb;
    bool patch = false; ///< patching an existing description: no key is required
};

/// Reads one table. The constructor reports unknown, missing and mutually exclusive keys; each read() reports
/// a wrong type or range, otherwise sets its target. Targets are unchanged if the key is absent or invalid.
/// Every key of the specification must be read once.
class TableReader {
  public:
    /// `label` names the table in messages: "[[sphere]]". `type` is its selector's value, empty if unknown.
    TableReader(const TreeValue& table, const TableSpec& spec, std::string label, std::string type,
                const ReadContext& context);

    bool has(std::string_view key) const { return table_.find(key) != nullptr; }
    /// Position of the key's value, or of the table's header where the key is absent.
    SourcePos position_of(std::string_view key) const;
    SourcePos header() const { return table_.where; }
    /// Whether no error was found in this table.
    bool good() const { return good_; }

    /// Sets the members that the keys of this type are bound to. Those of absent and wrong keys stay as they
    /// are.
    template <class T>
    void read(T& target) {
        read_members(KeyOwner(target));
    }
    /// The value of a key; none if it is absent or wrong.
    std::optional<KeyValue> value(const KeySpec& key);
    /// The list for values read elsewhere; null if absent or not a list.
    const TreeValue* list(std::string_view key);

    /// Reports what is wrong with this table beyond single values.
    void error(const SourcePos& pos, std::string message, std::string hint = {});

  private:
    void check_known();
    void check_required();
    void read_members(const KeyOwner& owner);

    const TreeValue& table_;
    const TableSpec& spec_;
    std::string label_;
    std::string type_;
    const ReadContext& context_;
    bool good_ = true;
};

/// The value of a table's selector ("kind", "type") without reporting errors; empty if absent or invalid.
std::string selected_type(const TreeValue& table, const TableSpec& spec);

/// The matrix of a list of transform entries, the first applied first.
Mat4 read_transform(const TreeValue& list, const ReadContext& context);

} // namespace glint::formats
