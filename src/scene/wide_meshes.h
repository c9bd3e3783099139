#pragma once
// Which meshes are traced in double. Private to this room.

#include "scene/bake.h"

namespace glint::scene {

/// Marks meshes as wide (WorldInput) whose triangles are so wide that their errors in float would show on
/// something in the scene. They may have at most 1024 triangles that are not near the origin of coordinates.
void mark_wide_meshes(Baked& baked);

} // namespace glint::scene
