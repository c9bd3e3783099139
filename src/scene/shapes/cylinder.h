#pragma once
#include "scene/shapes/shape_baker.h"

namespace glint::scene {

inline bool has_inside(const CylinderShape&) { return true; }

inline double support(const CylinderShape& s, const dvec3& d) {
    const dvec3 axis = glm::normalize(s.axis);
    const dvec3 across = d - glm::dot(d, axis) * axis;
    return glm::dot(d, s.base) + std::max(0.0, s.height * glm::dot(d, axis)) + s.radius * glm::length(across);
}

inline void bake(const CylinderShape& s, ShapeBaker& out) {
    out.quadric(geometry::make_cylinder(s.base, glm::normalize(s.axis), s.height, s.radius));
}

} // namespace glint::scene
