#pragma once
// Closed meshes, and where worlds are put.

#include "geometry/polyhedron.h"
#include "math/vec.h"
#include "stress_random.h"

namespace glint::stress {

/// The icosahedron in the unit sphere, each triangle cut in four `levels` times, all vertices on the sphere.
/// The ball of radius 0.79 is inside.
Polyhedron make_icosphere(int levels);

/// A torus about z: `around` quads along the circle of radius 1, `across` along the tube of radius 0.4.
Polyhedron make_torus(int around, int across);

/// A change of size and place: p -> (p + offset) · scale.
struct Placement {
    dvec3 offset{0};
    double scale = 1;

    vec3 operator()(const dvec3& p) const { return vec3((p + offset) * scale); }
};

/// Half the time none, else a scale of 10^±12 at most and an offset of 2^`offset_bits` at most.
Placement random_placement(Random& random, int offset_bits);

} // namespace glint::stress
