#pragma once
// Small worlds of degenerate and adversarial primitives.

#include "placement.h"
#include "stress_random.h"
#include "trace/world/world.h"

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

/// At most 64 triangles in up to three meshes, 12 quadrics and 2 planes; with instances, up to 12 instances
/// of three meshes of at most 48 triangles. All within about the cube [-1, 1]^3 before the placement.
trace::WorldInput make_soup(Soup kind, const Placement& placement, Random& random);

} // namespace glint::stress
