#pragma once
#include "scene/shapes/shape_baker.h"

namespace glint {

inline bool has_inside(const TriangleShape&) { return false; }

inline double support(const TriangleShape& s, const dvec3& d) {
    double most = no_support;
    for (const dvec3& p : s.vertices) raise_support(most, d, p);
    return most;
}

inline ShapeBox box(const TriangleShape& s) {
    ShapeBox box;
    for (const dvec3& p : s.vertices) box.grow(p);
    return box;
}

inline void bake(const TriangleShape& s, ShapeBaker& out) {
    out.triangles({s.vertices.begin(), s.vertices.end()}, {{0, 1, 2}}, false);
}

} // namespace glint
