#pragma once
// -D path=value: overrides applied to the tree of a scene file before it is checked.

#include "formats/scene/tree.h"

namespace glint {

/// Applies the overrides of the source in order; find_target() defines paths. Values that are not TOML are
/// text. Reports invalid paths; throws Error(usage) if '=' is missing.
void apply_overrides(TreeValue& root, const SceneSource& source, Problems& problems);

} // namespace glint
