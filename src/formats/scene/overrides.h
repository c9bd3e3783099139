#pragma once
// -D path=value: values of the command line put into the tree of a scene file before it is checked.

#include "formats/scene/tree.h"

namespace glint {

/// Puts the source's overrides into the tree, the later over the earlier; find_target() tells what paths
/// name. A value that is not TOML is taken as text. Reports paths that lead nowhere; throws Error(usage)
/// where there is no '='.
void apply_overrides(TreeValue& root, const SceneSource& source, Problems& problems);

} // namespace glint
