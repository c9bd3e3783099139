#pragma once
// A frozen scene as the shader reads it: flat arrays, records found by their numbers (shaders/data.glsl).

#include "gpu/records.shared.h"
#include "gpu/tree.h"
#include "scene/frozen.h"

#include <cstdint>
#include <vector>

namespace glint {

struct GpuSceneData {
    GpuTree tree;
    std::vector<uvec4> objects;
    std::vector<std::uint32_t> words;
    std::vector<vec4> tables;
    std::vector<double> shapes;
    GpuSettings settings{}; ///< all that the scene decides
    bool glass = false;   ///< does anything let light through?
};

/// Where `tree` is given it is the scene's, made before. Throws Error(device) for a scene that the shader's
/// numbers cannot name, with the sizes.
GpuSceneData flatten(const FrozenScene& scene, const GpuTree* tree = nullptr);

/// Another camera or size of the scene that was flattened. Throws as flatten() does.
void set_view(GpuSceneData& data, const FrozenScene& scene);

} // namespace glint
