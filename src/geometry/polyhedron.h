#pragma once
// The polyhedra of scene files as closed triangle meshes, in double.

#include "math/vec.h"

#include <vector>

namespace glint {

/// A closed convex polyhedron. Triangles run counter-clockwise seen from outside; corners are shared, so that
/// every directed edge has its opposite; the triangles of one face follow one another.
struct Polyhedron {
    std::vector<dvec3> positions;
    std::vector<uvec3> triangles;
};

/// A box with faces square to the axes; `center` is its middle, `size` its edge lengths, all > 0.
Polyhedron make_box(const dvec3& center, const dvec3& size);

/// The Platonic solids about `center` with circumscribed radius > 0. Tetrahedron, octahedron and icosahedron
/// stand with a vertex on +z, the dodecahedron with a face centre on +z. The first corner that is not on the
/// z axis, counted from the top, lies toward +x (for the tetrahedron that is a corner of its base).
Polyhedron make_tetrahedron(const dvec3& center, double radius);
Polyhedron make_octahedron(const dvec3& center, double radius);
Polyhedron make_dodecahedron(const dvec3& center, double radius);
Polyhedron make_icosahedron(const dvec3& center, double radius);

/// Where and how large a prism or pyramid stands. `axis` gives the direction only and must not be 0. The
/// first corner of the base lies toward +x, turned with the axis by the shortest rotation from +z; for an
/// axis along −z, where no rotation is the shortest, by half a turn about x.
struct Footing {
    dvec3 base{0}; ///< centre of the bottom face
    dvec3 axis{0, 0, 1};
    int sides = 6;     ///< ≥ 3
    double radius = 1; ///< circumscribed, > 0
    double height = 1; ///< > 0
};
Polyhedron make_prism(const Footing& footing);
Polyhedron make_pyramid(const Footing& footing);

} // namespace glint
