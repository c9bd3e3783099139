#pragma once
// Functions on triangle meshes given as spans of vertex positions and of triangles, three vertex indices
// each.

#include "math/vec.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace glint::geometry {

/// For every vertex the index of the first one with the same position, compared by bits except that −0 is 0.
std::vector<std::uint32_t> weld_by_position(std::span<const vec3> positions);

/// Whether the mesh bounds a volume: it has triangles, and once welded by position every directed edge a→b is
/// used as often as b→a.
bool is_closed(std::span<const vec3> positions, std::span<const uvec3> triangles);

/// Whether the mesh has triangles and, once welded by position, every edge belongs to an even number of them:
/// it would be closed if they were all wound alike.
bool has_no_holes(std::span<const vec3> positions, std::span<const uvec3> triangles);

/// The volume of a closed mesh in scene units cubed, positive if triangles run counter-clockwise seen from
/// outside. Meaningless if the mesh is not closed.
double signed_volume(std::span<const vec3> positions, std::span<const uvec3> triangles);

/// The sine of the least angle between two triangles that share an edge, by position; 1 if none is below 90°.
/// Triangles with the same corners do not count.
double sine_at_sharpest_edge(std::span<const vec3> positions, std::span<const uvec3> triangles);

/// Whether a triangle has no area: at each of its corners the cross product of the two edges, in double, is
/// exactly zero. True for repeated corners, false for corners that are not finite.
bool is_degenerate(const vec3& a, const vec3& b, const vec3& c);

/// Removes the degenerate triangles, keeping the order of the others; returns their number.
std::size_t drop_degenerate(std::span<const vec3> positions, std::vector<uvec3>& triangles);

/// The angle in radians, 0 … π, whose sine and cosine have the ratio sine : cosine, for sine ≥ 0. Absolute
/// error below 1e-14. Uses + - * / sqrt only, as pictures depend on it. 0 if both are zero.
double angle_from(double sine, double cosine);

/// Unit normals of the vertices: those of the faces around each, weighted by the face's angle there (Thürmer
/// and Wüthrich, "Computing vertex normals from polygonal facets", 1998). Vertices at one position share
/// their normal. Zero for a vertex without faces of some area, or whose faces cancel.
std::vector<vec3> smooth_normals(std::span<const vec3> positions, std::span<const uvec3> triangles);

/// The vertices of a mesh, split where its faces meet in creases.
struct CreasedMesh {
    std::vector<uvec3> triangles;      ///< of the split vertices
    std::vector<std::uint32_t> source; ///< the mesh's vertex of each
    std::vector<vec3> normals;         ///< as smooth_normals(), of the faces that no crease divides
};

/// An edge is a crease if the cosine between the normals of its faces is below `min_cosine`.
CreasedMesh split_at_creases(std::span<const vec3> positions, std::span<const uvec3> triangles,
                             double min_cosine);

} // namespace glint::geometry
