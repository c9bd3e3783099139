#pragma once
// Meshes made by formula, the same bytes on every machine: + - * / sqrt and our own sine only. All are about
// the origin, with z up; closed ones run counter-clockwise seen from outside and share their vertices.

#include "glint/scene.h"
#include "math/vec.h"

#include <cstddef>
#include <functional>

namespace glint::meshgen {

/// A torus about the z axis. `around` ≥ 3 steps the long way, `across` ≥ 3 the short way: 2 · around · across
/// triangles.
Mesh make_torus(int around, int across, double radius, double tube);

/// A tube along the torus knot that winds p times about the axis and q times through the hole; p and q
/// coprime. The trefoil is (2, 3).
struct Knot {
    int p = 2;
    int q = 3;
    double radius = 2; ///< of the torus that the knot lies on
    double swing = 1;  ///< its tube's radius
    double tube = 0.5; ///< radius of the knot's own tube
};
Mesh make_knot(int around, int across, const Knot& knot);

/// A ribbed spiral shell, closed at its tip and across its mouth, lying with its axis up.
Mesh make_shell(int around, int across);

/// A sphere of radius 1: an icosahedron with every triangle cut in four `levels` times, 20 · 4^levels
/// triangles.
Mesh make_icosphere(int levels);

/// Hills over the square −1 … 1 with `steps` steps each way, flattened at the level of the sea: 2 · steps²
/// triangles, open.
Mesh make_terrain(int steps, unsigned seed);

/// A ball of radius 1 cut from the sheet about the gyroid sin x cos y + sin y cos z + sin z cos x = 0, by
/// marching tetrahedra over `cells` cells each way.
Mesh make_gyroid(int cells, double periods, double thickness);

/// The surface value = 0 of a function that is positive outside, within the cube −size … size, by marching
/// tetrahedra. Closed if the function is positive on the cube's surface.
Mesh march_tetrahedra(const std::function<double(const dvec3&)>& value, double size, int cells);

/// Gives every vertex the colour that `color` has for its number and place.
void paint(Mesh& mesh, const std::function<dvec3(std::size_t, const dvec3&)>& color);

/// Bright colours once around for 0 … 1, linear RGB.
dvec3 rainbow(double turn);

/// From water (height ≤ 0) over grass and rock to snow at 1, linear RGB.
dvec3 landscape(double height);

} // namespace glint::meshgen
