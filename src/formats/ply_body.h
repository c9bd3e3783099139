#pragma once
// The body of a PLY file as it was stored, before it is made a mesh.

#include "formats/load_watch.h"
#include "formats/ply_layout.h"
#include "glint/limits.h"
#include "glint/scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace glint::ply {

/// What the rows of a body hold. Indices are checked; coordinates are not.
struct Body {
    /// A face of more than three corners, to be split once all vertices are known.
    struct Polygon {
        std::size_t triangles_before = 0; ///< its place in the order of the faces
        std::size_t first = 0;            ///< in `corners`
        std::size_t size = 0;
        std::size_t offset = 0; ///< of its list in the file
    };
    /// A vertex that is not finite, or beyond the greatest coordinate.
    struct BadVertex {
        std::uint32_t vertex = 0;
        std::size_t offset = 0; ///< of the coordinate in the file
        bool finite = false;
    };

    Mesh mesh; ///< `triangles` are the faces of three corners, and the strips
    std::vector<Polygon> polygons;
    std::vector<std::uint32_t> corners;
    std::vector<BadVertex> bad_vertices; ///< by vertex
    std::uint64_t small_faces = 0;       ///< with fewer than three corners, left out
    double brightest = 0;                ///< of vertex colours that are stored as float
    std::size_t trailing = 0;            ///< bytes after the last row
};

/// Reads all rows. Throws Error(input) with line and column, or byte: a cut file, a header that promises more
/// than the file can hold, a list of impossible length, a word that is no number, an index out of range.
/// Memory stays in proportion to the file. `watch` is told every some thousand rows.
Body read_body(const Source& source, const Header& header, const Layout& layout, const LoadWatch& watch);

} // namespace glint::ply
