#pragma once
// Transparent solids that nobody can see.

#include "scene/scene_data.h"

#include <cstdint>
#include <vector>

namespace glint::scene {

/// A transparent solid that lies wholly in one that owns the space.
struct HiddenSolid {
    std::uint32_t object;
    std::uint32_t owner;
};

/// In the order of objects; judged by sample rays.
std::vector<HiddenSolid> find_hidden_solids(const SceneData& scene);

} // namespace glint::scene
