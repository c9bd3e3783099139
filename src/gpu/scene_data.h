#pragma once
// A scene as the shader reads it: arrays of records (gpu/records.shared.h), one for each buffer of
// shaders/data.glsl.

#include "gpu/records.shared.h"
#include "gpu/tree.h"
#include "scene/scene_data.h"

#include <cstdint>
#include <vector>

namespace glint {

struct GpuSceneData {
    GpuTree tree;
    std::vector<ObjectRecord> objects;
    std::vector<std::uint32_t> interiors; ///< ObjectRecord::interior of each
    std::vector<std::uint32_t> words;     ///< ranges of meshes, numbers of transparent solids, vertex data
    FilterTable filter_table{};
    std::vector<LightRecord> lights;
    std::vector<ShapeRecord> shapes; ///< planes, then quadrics in the order of the tree's leaves
    GpuSettings settings{};          ///< all that the scene decides
    bool glass = false;              ///< does anything let light through?
};

/// Where `tree` is given it is the scene's, made before. Throws Error(device) for a scene that the shader's
/// numbers cannot name, with the sizes.
GpuSceneData flatten(const SceneData& scene, const GpuTree* tree = nullptr);

/// Another camera or size of the scene that was flattened. Throws as flatten() does.
void set_view(GpuSceneData& data, const SceneData& scene);

} // namespace glint
