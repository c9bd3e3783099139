#pragma once
// What is wrong with a scene beyond its single tables.

#include "formats/scene/read.h"

namespace glint {

/// Reports names given twice, unknown materials and meshes, degenerate triangles, coordinates out of range
/// (of meshes as far as they are loaded) and materials that the balanced model cannot have.
void check_scene(const ReadScene& scene, Problems& problems);

/// Reports meshes and instances whose vertices are out of range after scaling and transforming.
void check_mesh_extents(const ReadScene& scene, Problems& problems);

} // namespace glint
