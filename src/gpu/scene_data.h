#pragma once
// A scene in the form that shaders read: arrays of records (gpu/records.shared.h), one for each buffer of
// shaders/data.glsl.

#include "gpu/records.shared.h"
#include "gpu/tree.h"
#include "scene/scene_data.h"

#include <cstdint>
#include <vector>

namespace glint::gpu {

struct GpuSceneData {
    GpuTree tree;
    std::vector<ObjectRecord> objects;
    std::vector<std::uint32_t> interiors; ///< ObjectRecord::interior of each
    std::vector<std::uint32_t> words;     ///< ranges of meshes, transparent solids by number, vertex data
    FilterTable filter_table{};
    std::vector<LightRecord> lights;
    std::vector<ShapeRecord> shapes; ///< planes, then quadrics in the order of the tree's leaves
    GpuSettings settings{};          ///< those that the scene decides
    bool glass = false;              ///< is anything transparent?
    bool contacts = false;           ///< may surfaces of objects coincide?
};

/// `tree`, if given, is the scene's tree from an earlier call. Throws Error(device) with the sizes for a
/// scene with more of anything than the shader can index.
GpuSceneData flatten(const scene::SceneData& scene, const GpuTree* tree = nullptr);

/// Sets camera and size. Throws as flatten() does.
void set_view(GpuSceneData& data, const scene::SceneData& scene);

} // namespace glint::gpu
