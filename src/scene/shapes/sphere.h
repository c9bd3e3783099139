#pragma once
#include "scene/shapes/shape_baker.h"

namespace glint::scene {

inline bool has_inside(const SphereShape&) { return true; }

inline double support(const SphereShape& s, const dvec3& d) {
    return glm::dot(d, s.center) + s.radius * glm::length(d);
}

inline void bake(const SphereShape& s, ShapeBaker& out) {
    out.quadric(geometry::make_sphere(s.center, s.radius));
}

} // namespace glint::scene
