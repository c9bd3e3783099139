#pragma once
// Implementation of glint/trace.h. Private to this room.

#include "glint/trace.h"

#include "trace/mesh/tree.h"

#include <cstddef>
#include <span>
#include <type_traits>

namespace glint::tracing {

struct Mesh::Data {
    trace::MeshTree tree;
};

// Rays and hits are passed to the kernels without conversion. This is safe because nothing here accesses them
// through both types: the kernels are compiled separately.
static_assert(sizeof(Ray) == sizeof(glint::Ray) && std::is_standard_layout_v<glint::Ray>);
static_assert(offsetof(Ray, tmin) == offsetof(glint::Ray, tmin));
static_assert(offsetof(Ray, direction) == offsetof(glint::Ray, direction));
static_assert(offsetof(Ray, tmax) == offsetof(glint::Ray, tmax));

inline std::span<const glint::Ray> inner(std::span<const Ray> rays) {
    return {reinterpret_cast<const glint::Ray*>(rays.data()), rays.size()};
}

inline glint::Ray inner(const Ray& ray) {
    return {vec3(ray.origin[0], ray.origin[1], ray.origin[2]), ray.tmin,
            vec3(ray.direction[0], ray.direction[1], ray.direction[2]), ray.tmax};
}

inline Box outer(const Bounds& b) { return {{b.lo.x, b.lo.y, b.lo.z}, {b.hi.x, b.hi.y, b.hi.z}}; }

} // namespace glint::tracing
