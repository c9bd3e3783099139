// Vertices and faces of boxes, Platonic solids, prisms and pyramids.

#include "geometry/polyhedron.h"

#include "math/trig.h"

#include <cmath>
#include <cstdint>
#include <initializer_list>

namespace glint::geometry {
namespace {

using Index = std::uint32_t;

// Splits a convex face into a fan about its first corner.
void add_face(Polyhedron& p, const std::vector<Index>& corners) {
    for (std::size_t i = 2; i < corners.size(); ++i) {
        p.triangles.emplace_back(corners[0], corners[i - 1], corners[i]);
    }
}

// `count` corners on a circle about the z axis, counter-clockwise seen from above.
void add_ring(Polyhedron& p, int count, double first_degrees, double radius, double z) {
    for (int k = 0; k < count; ++k) {
        const double angle = first_degrees + 360.0 * k / count;
        p.positions.emplace_back(radius * cos_degrees(angle), radius * sin_degrees(angle), z);
    }
}

void fit(Polyhedron& p, const dvec3& center, double radius) {
    for (dvec3& v : p.positions) v = center + radius * v;
}

// The corners first, first + 1 … of a ring as a face seen from above, or from below.
void add_cap(Polyhedron& p, Index first, Index count, bool from_above) {
    std::vector<Index> corners;
    for (Index k = 0; k < count; ++k) corners.push_back(first + (from_above ? k : (count - k) % count));
    add_face(p, corners);
}

// Columns are x, y and z after the shortest rotation that takes +z to `axis`.
dmat3 shortest_rotation_from_z(const dvec3& axis) {
    // Scaled first, as squares of very long or short axes would leave the range.
    const dvec3 a = glm::normalize(axis / largest(axis));
    const double across = a.x * a.x + a.y * a.y;
    if (across == 0) return a.z > 0 ? dmat3(1.0) : dmat3(dvec3(1, 0, 0), dvec3(0, -1, 0), dvec3(0, 0, -1));

    // 1 / (1 + a.z) without cancellation for a.z near −1.
    const double k = a.z > 0 ? 1 / (1 + a.z) : (1 - a.z) / across;
    return dmat3(dvec3(1 - k * a.x * a.x, -k * a.x * a.y, -a.x),
                 dvec3(-k * a.x * a.y, 1 - k * a.y * a.y, -a.y), a);
}

void fit(Polyhedron& p, const Footing& footing) {
    const dmat3 turn = shortest_rotation_from_z(footing.axis);
    for (dvec3& v : p.positions) v = footing.base + turn * v;
}

} // namespace

Polyhedron make_box(const dvec3& center, const dvec3& size) {
    // Bit 0, 1, 2 of a corner's number: the upper side in x, y, z.
    Polyhedron p;
    for (int i = 0; i < 8; ++i) {
        const dvec3 side((i & 1) ? 0.5 : -0.5, (i & 2) ? 0.5 : -0.5, (i & 4) ? 0.5 : -0.5);
        p.positions.push_back(center + side * size);
    }
    for (const std::vector<Index>& face : std::initializer_list<std::vector<Index>>{
             {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
        add_face(p, face);
    }
    return p;
}

Polyhedron make_tetrahedron(const dvec3& center, double radius) {
    Polyhedron p;
    p.positions.emplace_back(0, 0, 1);
    add_ring(p, 3, 0, std::sqrt(8.0) / 3, -1.0 / 3);
    for (Index k = 0; k < 3; ++k) add_face(p, {0, 1 + k, 1 + (k + 1) % 3});
    add_cap(p, 1, 3, false);
    fit(p, center, radius);
    return p;
}

Polyhedron make_octahedron(const dvec3& center, double radius) {
    Polyhedron p;
    p.positions.emplace_back(0, 0, 1);
    add_ring(p, 4, 0, 1, 0);
    p.positions.emplace_back(0, 0, -1);
    for (Index k = 0; k < 4; ++k) {
        const Index here = 1 + k;
        const Index next = 1 + (k + 1) % 4;
        add_face(p, {0, here, next});
        add_face(p, {5, next, here});
    }
    fit(p, center, radius);
    return p;
}

Polyhedron make_dodecahedron(const dvec3& center, double radius) {
    // Four rings of five corners; the heights are the roots of the regular solid in the unit sphere.
    const double outer = std::sqrt((5 + 2 * std::sqrt(5.0)) / 15);
    const double inner = std::sqrt((5 - 2 * std::sqrt(5.0)) / 15);
    const double narrow = std::sqrt((10 - 2 * std::sqrt(5.0)) / 15);
    const double wide = std::sqrt((10 + 2 * std::sqrt(5.0)) / 15);
    Polyhedron p;
    add_ring(p, 5, 0, narrow, outer);
    add_ring(p, 5, 0, wide, inner);
    add_ring(p, 5, 36, wide, -inner);
    add_ring(p, 5, 36, narrow, -outer);

    add_cap(p, 0, 5, true);
    for (Index k = 0; k < 5; ++k) {
        const Index next = (k + 1) % 5;
        add_face(p, {k, 5 + k, 10 + k, 5 + next, next});
        add_face(p, {15 + k, 15 + next, 10 + next, 5 + next, 10 + k});
    }
    add_cap(p, 15, 5, false);
    fit(p, center, radius);
    return p;
}

Polyhedron make_icosahedron(const dvec3& center, double radius) {
    const double z = 1 / std::sqrt(5.0);
    Polyhedron p;
    p.positions.emplace_back(0, 0, 1);
    add_ring(p, 5, 0, 2 * z, z);
    add_ring(p, 5, 36, 2 * z, -z);
    p.positions.emplace_back(0, 0, -1);
    for (Index k = 0; k < 5; ++k) {
        const Index upper = 1 + k;
        const Index upper_next = 1 + (k + 1) % 5;
        const Index lower = 6 + k;
        const Index lower_next = 6 + (k + 1) % 5;
        add_face(p, {0, upper, upper_next});
        add_face(p, {upper, lower, upper_next});
        add_face(p, {upper_next, lower, lower_next});
        add_face(p, {11, lower_next, lower});
    }
    fit(p, center, radius);
    return p;
}

Polyhedron make_prism(const Footing& footing) {
    const Index n = static_cast<Index>(footing.sides);
    Polyhedron p;
    add_ring(p, footing.sides, 0, footing.radius, 0);
    add_ring(p, footing.sides, 0, footing.radius, footing.height);
    add_cap(p, 0, n, false);
    for (Index k = 0; k < n; ++k) add_face(p, {k, (k + 1) % n, n + (k + 1) % n, n + k});
    add_cap(p, n, n, true);
    fit(p, footing);
    return p;
}

Polyhedron make_pyramid(const Footing& footing) {
    const Index n = static_cast<Index>(footing.sides);
    Polyhedron p;
    add_ring(p, footing.sides, 0, footing.radius, 0);
    p.positions.emplace_back(0, 0, footing.height);
    add_cap(p, 0, n, false);
    for (Index k = 0; k < n; ++k) add_face(p, {k, (k + 1) % n, n});
    fit(p, footing);
    return p;
}

} // namespace glint::geometry
