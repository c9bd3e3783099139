#pragma once
// The parts of freezing that need no trees. Private to this room.

#include "scene/scene_data.h"

namespace glint {

/// Does a visible object let light through?
bool shows_glass(const SceneDescription& description);

/// Fills in materials, lights and what else of the description stands beside its objects.
void build_values(SceneData& scene);

/// Fills in the eye's own list: only what light goes through owns space.
void find_camera_interiors(SceneData& scene);

} // namespace glint
