#pragma once
// The rows of a PLY file as stored, before they become a mesh.

#include "formats/load_watch.h"
#include "formats/ply/layout.h"
#include "glint/limits.h"
#include "glint/scene.h"
#include "math/bounds.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace glint::formats::ply {

/// Contents of all rows. Indices are checked; coordinates are not.
struct Rows {
    /// A face with more than three corners, triangulated after all vertices are known.
    struct Polygon {
        std::size_t triangles_before = 0; ///< number of triangles before it in face order
        std::size_t first = 0;            ///< in `corners`
        std::size_t size = 0;
        std::size_t offset = 0; ///< of its list in the file
    };
    /// A vertex that is not finite or exceeds the largest coordinate.
    struct BadVertex {
        std::uint32_t vertex = 0;
        std::size_t offset = 0; ///< of the coordinate in the file
        bool finite = false;
    };

    Mesh mesh; ///< `triangles` contains faces with three corners, and strips
    std::vector<Polygon> polygons;
    std::vector<std::uint32_t> corners;
    std::vector<BadVertex> bad_vertices; ///< sorted by vertex
    std::uint64_t small_faces = 0;       ///< faces with fewer than three corners, which are skipped
    double max_float_color = 0;          ///< maximum of vertex colours stored as float
    std::size_t trailing = 0;            ///< bytes after the last row
};

/// Reads all rows. Throws Error(input) with line and column, or byte offset, for a truncated file, a header
/// that declares more rows than the file can contain, an impossible list length, a malformed number, or an
/// index out of range. Memory use is proportional to the file size. Reports to `watch` every few thousand
/// rows. The positions of the mesh are relative to `origin`, which is subtracted in double.
Rows read_rows(const Source& source, const Header& header, const MeshLayout& layout, const LoadWatch& watch,
               const dvec3& origin = dvec3(0));

/// Bounds of the vertices of every `step`-th face, or of such points without outliers if there are no faces.
/// Vertices that are not finite or exceed the largest coordinate do not count.
Bounds bounds_of_faces(const Rows& rows, std::size_t step = 1);

/// A step for bounds_of_faces() that leaves about 64 faces or points: few, but if these are not far from zero
/// compared with their size, the whole is not either.
std::size_t sparse_step(const Rows& rows);

/// What must be added to the origin of the mesh so that single precision resolves it: mostly zero.
dvec3 origin_step(const Rows& rows);

} // namespace glint::formats::ply
