#pragma once
#include "scene/shapes/shape_baker.h"

namespace glint::scene {

inline bool has_inside(const PlaneShape& s) { return s.solid; }

inline double support(const PlaneShape&, const dvec3&) { return no_support; }

/// The plane's point nearest to the origin. The length is divided out twice to avoid overflow.
inline ShapeBox box(const PlaneShape& s) {
    const double length = glm::length(s.normal);
    ShapeBox box;
    box.grow(s.normal / length * (s.offset / length));
    return box;
}

inline void bake(const PlaneShape& s, ShapeBaker& out) { out.plane(s.normal, s.offset); }

} // namespace glint::scene
