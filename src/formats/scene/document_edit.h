#pragma once
// Text edits of scene files.

#include "formats/scene/key_path.h"
#include "formats/scene/tree.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace glint::formats {

/// A range of SceneSource::text() and its replacement.
struct TextEdit {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::string text;
};

/// The edit that sets a value, in TOML syntax, at the target's key. `root` is the tree of the source after
/// KeyPaths::find(), which adds missing tables.
TextEdit edit_for(const SceneSource& source, const TreeValue& root, const KeyTarget& target,
                  std::string_view value);

/// The characters of a value in the file.
std::string_view text_of(const SceneSource& source, const TreeValue& value);

/// Whether two values are equal. Integers equal floats of the same value; positions are ignored.
bool same_value(const TreeValue& a, const TreeValue& b);

} // namespace glint::formats
