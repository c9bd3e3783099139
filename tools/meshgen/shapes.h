#pragma once
// Procedural meshes, the same bytes on every machine: only + - * / sqrt and our own sine. All are centred at
// the origin with z up. Closed ones are oriented counter-clockwise seen from outside and share vertices.

#include "glint/scene.h"
#include "math/vec.h"

#include <cstddef>
#include <functional>

namespace glint::meshgen {

/// A torus about the z axis with `around` ≥ 3 steps along its ring and `across` ≥ 3 around its tube: 2 ·
/// around · across triangles.
Mesh make_torus(int around, int across, double radius, double tube);

/// A tube along the torus knot that winds p times about the axis and q times through the hole; p and q
/// coprime. The trefoil is (2, 3).
struct Knot {
    int p = 2;
    int q = 3;
    double radius = 2; ///< major radius of the torus that the knot lies on
    double swing = 1;  ///< minor radius of that torus
    double tube = 0.5; ///< radius of the knot's tube
};
Mesh make_knot(int around, int across, const Knot& knot);

/// A ribbed spiral shell, closed at tip and mouth, with its axis up.
Mesh make_shell(int around, int across);

/// A unit sphere: an icosahedron whose triangles are divided in four `levels` times, 20 · 4^levels triangles.
Mesh make_icosphere(int levels);

/// A height field over the square −1 … 1 with `steps` steps in both directions, flattened at sea level: 2 ·
/// steps² triangles, open.
Mesh make_terrain(int steps, unsigned seed);

/// A unit ball cut from a sheet about the gyroid sin x cos y + sin y cos z + sin z cos x = 0, by marching
/// tetrahedra on `cells`³ cells.
Mesh make_gyroid(int cells, double periods, double thickness);

/// The zero surface of a function that is positive outside, within the cube −size … size, by marching
/// tetrahedra. Closed if the function is positive on the cube's surface.
Mesh march_tetrahedra(const std::function<double(const dvec3&)>& value, double size, int cells);

/// Sets vertex colours by a function of index and position.
void paint(Mesh& mesh, const std::function<dvec3(std::size_t, const dvec3&)>& color);

/// A rainbow colour map for 0 … 1, linear RGB.
dvec3 rainbow(double turn);

/// A colour map from water (height ≤ 0) over grass and rock to snow at 1, linear RGB.
dvec3 landscape(double height);

} // namespace glint::meshgen
