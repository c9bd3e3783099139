#pragma once
#include "scene/shapes/shape_baker.h"

namespace glint::scene {

inline bool has_inside(const TriangleShape&) { return false; }

inline double support(const TriangleShape& s, const dvec3& d) {
    double most = no_support;
    for (const dvec3& p : s.vertices) raise_support(most, d, p);
    return most;
}

/// Degenerate: less high over its longest edge than the rounding of its coordinates.
inline std::optional<KeyFault> shape_fault(const TriangleShape& s) {
    const auto& v = s.vertices;
    const Vec3 a = v[1] - v[0], b = v[2] - v[0], c = v[2] - v[1];
    const double longest = std::max({glm::length(a), glm::length(b), glm::length(c)});
    const double coordinate = std::max({largest(v[0]), largest(v[1]), largest(v[2])});
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * coordinate;
    if (glm::length(glm::cross(a, b)) > rounding * longest) return std::nullopt;
    return KeyFault{"the triangle is degenerate: its vertices lie on one line", {}};
}

inline void bake(const TriangleShape& s, ShapeBaker& out) {
    out.triangles({s.vertices.begin(), s.vertices.end()}, {{0, 1, 2}}, false);
}

} // namespace glint::scene
