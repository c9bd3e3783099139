#pragma once
// Transparent solids that nobody can see.

#include "scene/scene_data.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace glint::scene {

/// More are not looked for: these are enough to mend before the next look.
inline constexpr std::size_t max_hidden_solids = 100;

/// A transparent solid of which nothing is outside those that own the space.
struct HiddenSolid {
    std::uint32_t object;
    std::uint32_t owner; ///< of the space around a part of it
};

/// In the order of objects; judged by sample rays.
std::vector<HiddenSolid> find_hidden_solids(const SceneData& scene);

} // namespace glint::scene
