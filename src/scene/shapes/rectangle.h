#pragma once
#include "scene/shapes/shape_baker.h"

namespace glint::scene {

inline std::vector<dvec3> corners(const RectangleShape& s) {
    return {s.corner, s.corner + s.u, s.corner + s.u + s.v, s.corner + s.v};
}

inline bool has_inside(const RectangleShape&) { return false; }

inline double support(const RectangleShape& s, const dvec3& d) {
    double most = no_support;
    for (const dvec3& p : corners(s)) raise_support(most, d, p);
    return most;
}

/// Degenerate: less wide than the rounding of its coordinates.
inline std::optional<KeyFault> shape_fault(const RectangleShape& s) {
    const double longest = std::max(glm::length(s.u), glm::length(s.v));
    const double coordinate = largest(s.corner) + largest(s.u) + largest(s.v);
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * coordinate;
    if (glm::length(glm::cross(s.u, s.v)) > rounding * longest) return std::nullopt;
    return KeyFault{"the rectangle has no area: its edges are parallel", {}};
}

inline void bake(const RectangleShape& s, ShapeBaker& out) {
    out.triangles(corners(s), {{0, 1, 2}, {0, 2, 3}}, false);
}

} // namespace glint::scene
