#pragma once
#include "scene/shapes/shape_baker.h"

namespace glint::scene {

inline dvec3 apex(const ConeShape& s) { return s.base + glm::normalize(s.axis) * s.height; }

inline bool has_inside(const ConeShape&) { return true; }

inline double support(const ConeShape& s, const dvec3& d) {
    const dvec3 axis = glm::normalize(s.axis);
    const double rim = glm::dot(d, s.base) + s.radius * glm::length(d - glm::dot(d, axis) * axis);
    return std::max(rim, glm::dot(d, apex(s)));
}

inline void bake(const ConeShape& s, ShapeBaker& out) {
    out.quadric(geometry::make_cone(s.base, glm::normalize(s.axis), s.height, s.radius));
}

} // namespace glint::scene
