#pragma once
// Checks across the tables of a scene.

#include "formats/scene/read.h"

namespace glint {

/// Reports duplicate names, unknown materials and meshes, degenerate triangles, coordinates out of range (for
/// meshes that are loaded) and materials invalid for the balanced model.
void check_scene(const ReadScene& scene, Problems& problems);

/// Reports meshes and instances whose vertices are out of range after scaling and transforming.
void check_mesh_extents(const ReadScene& scene, Problems& problems);

} // namespace glint
