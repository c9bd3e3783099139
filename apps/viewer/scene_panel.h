#pragma once
// Materials, objects and lights of the scene with everything in them that can be set.

#include "widgets.h"

namespace glint::viewer {

/// Draws the panel's content; what the user changes is added to `edits`.
/// `size` is about how large the scene is: what a pixel of dragging moves follows from it.
void scene_panel(Ui& ui, const SceneDescription& scene, double size, std::vector<Edit>& edits);

} // namespace glint::viewer
