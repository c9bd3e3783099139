#pragma once
// Objects that meet transparent solids in a way that rarely is meant.

#include "scene/scene_data.h"

#include <cstdint>
#include <vector>

namespace glint::scene {

enum class OverlapKind {
    coincident,   ///< faces of both lie in one place, so rays may meet either first
    hidden,       ///< all of the object lies in the other, which owns the space
    partly_hidden ///< a part of an opaque object does
};

struct Overlap {
    OverlapKind kind;
    std::uint32_t object;
    std::uint32_t other;
};

/// In the order of objects. Flat faces of shapes are compared exactly; curved ones, those of meshes, and what
/// lies inside of what, by sample rays.
std::vector<Overlap> find_overlaps(const SceneData& scene);

} // namespace glint::scene
