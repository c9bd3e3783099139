#pragma once
// -D path=value: values of the command line put into the tree of a scene file before it is checked.

#include "formats/scene_tree.h"

namespace glint {

/// Puts the source's overrides into the tree, the later over the earlier. Paths name a key of the top
/// ("color_values"), of a table ("whitted.max_depth"), of a table by name ("material.glass.index",
/// "mesh.cat.file") or by its number within its type ("light.0.intensity"). A value that is not TOML is taken
/// as text. Reports paths that lead nowhere; throws Error(usage) where there is no '='.
void apply_overrides(TreeValue& root, const SceneSource& source, Problems& problems);

} // namespace glint
