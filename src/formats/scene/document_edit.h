#pragma once
// Where in the text of a scene file a value is written.

#include "formats/scene/key_path.h"
#include "formats/scene/tree.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace glint {

/// Characters of SceneSource::text() and what takes their place.
struct TextEdit {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::string text;
};

/// What puts a value, as TOML writes it, under the target's key. `root` is the tree of the source, as
/// find_target() left it: only there are tables that the file lacks.
TextEdit edit_for(const SceneSource& source, const TreeValue& root, const KeyTarget& target,
                  std::string_view value);

/// The characters of a value of the file.
std::string_view text_of(const SceneSource& source, const TreeValue& value);

/// Do two values say the same? An integer is the number; places do not matter.
bool same_value(const TreeValue& a, const TreeValue& b);

} // namespace glint
