#pragma once
// Fast path for the usual binary files: vertices of floats with byte colours, then triangles, all rows of
// fixed size. Anything unusual is left to read_rows(), which also reports errors.

#include "formats/ply/rows.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace glint::formats::ply {

class FixedRowReader {
  public:
    /// Returns nothing if the header describes other rows, or if their size is not that of the file (`size`
    /// bytes).
    static std::optional<FixedRowReader> begin(const Header& header, const MeshLayout& layout,
                                               std::size_t size);

    /// Reads complete rows from the next bytes of the body. Returns the number of bytes used, or nothing at
    /// an unusual row: not a triangle, or an index or coordinate out of range.
    std::optional<std::size_t> take(std::span<const std::byte> bytes);
    bool complete() const { return vertices_left_ == 0 && faces_left_ == 0; }
    /// The rows read. Far from zero, the positions are relative to an origin of the mesh.
    Rows finish();

  private:
    bool set_vertex_format(const Element& element, const VertexFormat& format);
    bool set_face_format(const Element& element, int corners, std::uint64_t vertices);
    const char* take_vertices(const char* row, const char* end);
    const char* take_faces(const char* row, const char* end);

    Mesh mesh_;
    std::uint64_t vertices_left_ = 0;
    std::uint64_t faces_left_ = 0;
    bool normals_ = false;
    bool colors_ = false;
    bool uvs_ = false;
    std::array<std::size_t, role_count> offset_{}; ///< by role: offset in a vertex row
    std::size_t vertex_bytes_ = 0;
    std::size_t list_offset_ = 0; ///< offset of the corner list in a face row
    std::size_t face_bytes_ = 0;
    std::uint32_t limit_ = 0; ///< exclusive upper bound of vertex indices
};

} // namespace glint::formats::ply
