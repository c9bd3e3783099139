#pragma once
// Key paths such as "material.glass.index", by which -D, documents and animations refer to a value of a
// scene.

#include "formats/scene/key_table.h"
#include "formats/scene/tree.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace glint::formats {

/// Removes surrounding white space.
std::string_view trimmed(std::string_view text);

/// The target of a key path.
struct KeyTarget {
    TreeValue* table = nullptr; ///< null if not found
    const TableSpec* spec = nullptr;
    std::string key;
    std::string path; ///< canonical path: tables of lists by number
};

/// The places of a table's parts by name: in the list, or among the entries.
using PartNames = std::map<std::string, std::size_t>;

/// Finds and sets what paths name in the tree of a scene. Names are gathered once, so that many paths are
/// found about as fast as the tree is read.
///
/// Paths name a key of the top ("color_values"), of a table ("whitted.max_depth"), of a table by name
/// ("material.glass.index", "mesh.cat.file") or by its number within its type ("light.0.intensity"), and of
/// an entry of a transform ("mesh.cat.transform.0.angle").
class KeyPaths {
  public:
    /// Both must outlive this. Only put() may change names meanwhile.
    KeyPaths(TreeValue& root, Problems& problems) : root_(root), problems_(problems) {}

    /// Finds the table that a path names, and makes an empty one where the scene lacks a table such as
    /// [camera]; later calls may move it. Reports a path that leads nowhere, at `where`; whether the table
    /// has such a key is for its reader to say.
    KeyTarget find(std::string_view path, const SourcePos& where);

    /// Sets the value of the target's key. Key and value get the position `where`.
    void put(const KeyTarget& target, TreeValue value, const SourcePos& where);

  private:
    TreeValue& root_;
    Problems& problems_;
    std::map<std::string_view, PartNames> names_; ///< by table, where gathered
};

/// Parses a value as for -D: TOML, otherwise text. All positions are `where`.
TreeValue read_value(std::string_view text, const SourcePos& where);

/// Applies the overrides of the source (-D) to the tree of its file, in order; KeyPaths has the paths.
/// Values that are not TOML are text. Reports invalid paths; throws Error(usage) if '=' is missing.
void apply_overrides(TreeValue& root, const SceneSource& source, Problems& problems);

} // namespace glint::formats
