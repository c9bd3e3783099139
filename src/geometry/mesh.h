#pragma once
// Tools on triangle meshes as plain spans: n positions, and triangles as three indices below n each.

#include "math/vec.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace glint {

/// For every vertex the first one with the same position. Compared by bits, but −0 is 0.
std::vector<std::uint32_t> weld_by_position(std::span<const vec3> positions);

/// Whether the mesh bounds a volume: it has triangles, and once welded by position every directed edge a→b is
/// used as often as b→a.
bool is_closed(std::span<const vec3> positions, std::span<const uvec3> triangles);

/// The volume inside a closed mesh, positive where triangles run counter-clockwise seen from outside. In
/// scene units cubed; for a mesh that is not closed the number means nothing.
double signed_volume(std::span<const vec3> positions, std::span<const uvec3> triangles);

/// Whether a triangle has no area: at each of its corners the cross product of the two edges, in double, is
/// exactly zero. A repeated corner is such a case. A corner that is not finite is none.
bool is_degenerate(const vec3& a, const vec3& b, const vec3& c);

/// Removes the degenerate triangles, keeps the order of the others; returns how many went.
std::size_t drop_degenerate(std::span<const vec3> positions, std::vector<uvec3>& triangles);

/// The angle in radians, 0 … π, whose sine and cosine have the ratio sine : cosine, for sine ≥ 0. Absolute
/// error below 1e-14. From + - * / sqrt alone, since pictures depend on it. Both zero: 0.
double angle_from(double sine, double cosine);

/// Unit normals of the vertices: those of the faces around each, weighted by the face's angle there (Thürmer
/// and Wüthrich, "Computing vertex normals from polygonal facets", 1998). Vertices at one position share
/// their normal. Zero where a vertex has no face with an area, or where its faces cancel.
std::vector<vec3> smooth_normals(std::span<const vec3> positions, std::span<const uvec3> triangles);

} // namespace glint
