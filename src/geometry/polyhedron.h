#pragma once
// The polyhedra of scene files as closed triangle meshes, in double.

#include "math/vec.h"

#include <vector>

namespace glint::geometry {

/// A closed convex polyhedron. Triangles run counter-clockwise seen from outside and share corners, so every
/// directed edge has its opposite; the triangles of a face are consecutive.
struct Polyhedron {
    std::vector<dvec3> positions;
    std::vector<uvec3> triangles;
};

/// An axis-aligned box; `size` is its edge lengths, all > 0.
Polyhedron make_box(const dvec3& center, const dvec3& size);

/// The Platonic solids about `center` with circumscribed radius > 0. Tetrahedron, octahedron and icosahedron
/// have a vertex on +z, the dodecahedron a face centre on +z. The topmost corner off the z axis that comes
/// first lies toward +x (for the tetrahedron a corner of its base).
Polyhedron make_tetrahedron(const dvec3& center, double radius);
Polyhedron make_octahedron(const dvec3& center, double radius);
Polyhedron make_dodecahedron(const dvec3& center, double radius);
Polyhedron make_icosahedron(const dvec3& center, double radius);

/// Position and size of a prism or pyramid. Only the direction of `axis` matters; it must not be 0. The first
/// corner of the base lies toward +x, rotated with the axis by the shortest rotation from +z; for an axis
/// along −z, which has none, by half a turn about x.
struct Footing {
    dvec3 base{0}; ///< centre of the bottom face
    dvec3 axis{0, 0, 1};
    int sides = 6;     ///< ≥ 3
    double radius = 1; ///< circumscribed, > 0
    double height = 1; ///< > 0
};
Polyhedron make_prism(const Footing& footing);
Polyhedron make_pyramid(const Footing& footing);

} // namespace glint::geometry
