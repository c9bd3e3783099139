#pragma once
// Small worlds of ugly primitives.

#include "placement.h"
#include "stress_random.h"
#include "trace/world.h"

namespace glint::stress {

enum class Soup {
    random,
    needles,
    slivers,
    axis_aligned,
    coplanar,
    duplicates,
    zero_area,
    quadrics,
    mixed,
    instanced
};

/// At most 64 triangles in up to three meshes, at most 12 quadrics and 2 planes, and where it is instanced up
/// to 12 instances of three meshes of at most 48 triangles, about the cube [-1, 1]^3 before the placement.
WorldInput make_soup(Soup kind, const Placement& place, Random& random);

} // namespace glint::stress
