#pragma once
// Origins for what lies far from zero.

#include "math/bounds.h"

#include <algorithm>
#include <cmath>

namespace glint {

/// The origin from which single precision resolves what a box holds. It is zero unless the middle of the box
/// is farther from zero than 64 times its largest side, so that rounding to float would move what it holds by
/// more than 2^-18 of that side. Then it is a point near the middle, on a grid no coarser than the box: it
/// seldom changes while the box moves a little.
inline dvec3 far_origin(const Bounds& box) {
    if (box.empty()) return dvec3(0);
    const dvec3 lo(box.lo), hi(box.hi);
    const dvec3 middle = (lo + hi) / 2.0, sides = hi - lo, far = glm::abs(middle);
    const double side = std::max({sides.x, sides.y, sides.z});
    if (!(std::max({far.x, far.y, far.z}) > 64 * side)) return dvec3(0);
    if (side == 0) return middle;
    int exponent;
    std::frexp(side, &exponent);
    const double grid = std::ldexp(1.0, exponent - 1);
    return glm::floor(middle / grid + 0.5) * grid;
}

} // namespace glint
