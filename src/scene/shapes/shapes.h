#pragma once
// All shapes. Each has one header here with the functions below.
//
//   bool has_inside(const S&)                has it an inside?
//   double support(const S&, const dvec3& d) the largest d · p over its points; no_support if none is finite
//   ShapeBox box(const S&)                   only where support() does not give it
//   optional<KeyFault> shape_fault(const S&) only where keys that are good by themselves may not go together
//   void bake(const S&, ShapeBaker&)         its parts for the tracing core
//
// All in the shape's own space, before the object's transform.

#include "scene/shapes/cone.h"
#include "scene/shapes/cylinder.h"
#include "scene/shapes/disk.h"
#include "scene/shapes/mesh.h"
#include "scene/shapes/plane.h"
#include "scene/shapes/polyhedron.h"
#include "scene/shapes/rectangle.h"
#include "scene/shapes/sphere.h"
#include "scene/shapes/triangle.h"

namespace glint::scene {

/// The box that support() gives.
template <class S>
ShapeBox box(const S& s) {
    ShapeBox box;
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 d(0);
        d[axis] = 1;
        box.lo[axis] = -support(s, -d);
        box.hi[axis] = support(s, d);
    }
    return box;
}

} // namespace glint::scene
