#pragma once
// Objects whose surfaces lie in one place.

#include "parallel/task_pool.h"
#include "scene/scene_data.h"

namespace glint::scene {

/// Sets the contact zones of all objects: where flat faces lie in one plane, where curved surfaces are the
/// same, where curved glass touches something flat. Compared in double; meshes of many triangles only with
/// planes and with objects of the same box.
void find_contacts(SceneData& scene, parallel::TaskPool& pool);

} // namespace glint::scene
