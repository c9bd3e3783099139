#pragma once
// Baking: converts described objects to the input of the tracing core. Transforms are applied in double
// precision and rounded once.

#include "scene/scene_data.h"

#include <functional>

namespace glint::scene {

/// Output of baking: input of the tracing core, and attributes of meshes.
struct Baked {
    trace::WorldInput input;
    std::vector<ObjectData> objects;
    std::vector<MeshAttributes> attributes;
    std::vector<dmat3> normal_matrices; ///< of instances
};

/// Bakes all visible objects; instances of a mesh share one in local space. Sets ranks and
/// materials; determines `solid` for meshes only with `need_closedness`, as that takes a pass over all edges.
/// `between` is called before each object and each pass over a mesh; exceptions from it abort. Throws
/// Error(input) for coordinates beyond 10^12.
Baked bake(const SceneDescription& description, bool need_closedness, const std::function<void()>& between);

} // namespace glint::scene
