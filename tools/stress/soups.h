#pragma once
// Small worlds of degenerate and adversarial primitives.

#include "families.h"
#include "stress_random.h"
#include "trace/world/world.h"

namespace glint::stress {

/// At most 64 triangles in up to three meshes, 12 quadrics and 2 planes; with instances, up to 12 instances
/// of three meshes of at most 48 triangles. All within about the cube [-1, 1]^3 before scale and offset.
trace::WorldInput make_soup(Soup kind, const ScaledOffset& to_world, Random& random);

} // namespace glint::stress
