#pragma once
#include "scene/shapes/shape_baker.h"

namespace glint::scene {

inline bool has_inside(const DiskShape&) { return false; }

inline double support(const DiskShape& s, const dvec3& d) {
    const dvec3 normal = glm::normalize(s.normal);
    return glm::dot(d, s.center) + s.radius * glm::length(d - glm::dot(d, normal) * normal);
}

inline void bake(const DiskShape& s, ShapeBaker& out) {
    out.quadric(geometry::make_disk(s.center, glm::normalize(s.normal), s.radius));
}

} // namespace glint::scene
