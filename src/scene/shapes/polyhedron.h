#pragma once
#include "geometry/polyhedron.h"
#include "scene/shapes/cylinder.h"
#include "scene/shapes/sphere.h"

namespace glint::scene {

inline bool has_inside(const PolyhedronShape&) { return true; }

/// Polyhedra other than boxes count as the sphere or cylinder about them.
inline double support(const PolyhedronShape& s, const dvec3& d) {
    switch (s.kind) {
    case PolyhedronKind::box:
        return glm::dot(d, s.center) + glm::dot(glm::abs(d), s.size) / 2;
    case PolyhedronKind::prism:
    case PolyhedronKind::pyramid:
        return support(CylinderShape{s.center, s.axis, s.height, s.radius}, d);
    default:
        return support(SphereShape{s.center, s.radius}, d);
    }
}

inline geometry::Polyhedron make_polyhedron(const PolyhedronShape& s) {
    const geometry::Footing footing{s.center, s.axis, s.sides, s.radius, s.height};
    switch (s.kind) {
    case PolyhedronKind::box:
        return geometry::make_box(s.center, s.size);
    case PolyhedronKind::tetrahedron:
        return geometry::make_tetrahedron(s.center, s.radius);
    case PolyhedronKind::octahedron:
        return geometry::make_octahedron(s.center, s.radius);
    case PolyhedronKind::dodecahedron:
        return geometry::make_dodecahedron(s.center, s.radius);
    case PolyhedronKind::icosahedron:
        return geometry::make_icosahedron(s.center, s.radius);
    case PolyhedronKind::prism:
        return geometry::make_prism(footing);
    case PolyhedronKind::pyramid:
        return geometry::make_pyramid(footing);
    }
    return {};
}

inline void bake(const PolyhedronShape& s, ShapeBaker& out) {
    geometry::Polyhedron solid = make_polyhedron(s);
    out.triangles(solid.positions, std::move(solid.triangles), true);
}

} // namespace glint::scene
