#pragma once
// Scale and offset of worlds.

#include "stress_random.h"

#include <cmath>

namespace glint::stress {

/// A scaled translation: p -> (p + offset) · scale.
struct Placement {
    dvec3 offset{0};
    double scale = 1;

    vec3 operator()(const dvec3& p) const { return vec3((p + offset) * scale); }
};

/// The identity with probability 1/2, otherwise a scale within 10^±12 and an offset of at most
/// 2^`offset_bits`.
inline Placement random_placement(Random& random, int offset_bits) {
    Placement placement;
    if (random.one_in(2)) return placement;
    if (random.one_in(2)) placement.scale = random.power_of_ten(-12, 12);
    if (random.one_in(2)) {
        const int bits = random.between(0, offset_bits);
        placement.offset = random.in_cube(std::ldexp(1.0, bits));
    }
    return placement;
}

} // namespace glint::stress
