#pragma once
// From described objects to what the tracing core takes: transforms applied in double, rounded once.

#include "scene/scene_data.h"

#include <functional>

namespace glint {

/// What baking fills in: the core's input, and the attributes of meshes.
struct Baked {
    trace::WorldInput input;
    std::vector<ObjectData> objects;
    std::vector<MeshAttributes> attributes;
    std::vector<dmat3> normal_matrices; ///< of instances
};

/// Bakes all visible objects; a mesh that several of them show is stored once, in its own space. Ranks and
/// materials are set; `solid` is found out for meshes only where `need_closedness`, since that takes a pass
/// over all edges. `between` is called before each object and each pass over a mesh: what it throws ends the
/// baking. Throws Error(input) for coordinates beyond 10^12.
Baked bake(const SceneDescription& description, bool need_closedness, const std::function<void()>& between);

} // namespace glint
