#pragma once
// Bodies as most binary files have them, read without a step for each value: vertices of floats, colours of
// bytes, then triangles. Whatever is unusual is left to read_body(), which also says what is wrong.

#include "formats/ply_body.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace glint::ply {

class PlainBody {
  public:
    /// Nothing where the header tells of another body, or one that is not as long as the file, of `size`
    /// bytes.
    static std::optional<PlainBody> begin(const Header& header, const Layout& layout, std::size_t size);

    /// Takes whole rows from the next bytes of the body; gives how many bytes these were, or nothing where a
    /// row is unusual: no triangle, an index or a coordinate out of range.
    std::optional<std::size_t> take(std::span<const std::byte> bytes);
    bool complete() const { return vertices_left_ == 0 && faces_left_ == 0; }
    /// What was read.
    Body finish() { return {.mesh = std::move(mesh_), .polygons = {}, .corners = {}, .bad_vertices = {}}; }

  private:
    bool plan_vertices(const Element& element, const VertexLayout& layout);
    bool plan_faces(const Element& element, int corners, std::uint64_t vertices);
    const char* take_vertices(const char* row, const char* end);
    const char* take_faces(const char* row, const char* end);

    Mesh mesh_;
    std::uint64_t vertices_left_ = 0;
    std::uint64_t faces_left_ = 0;
    bool normals_ = false;
    bool colors_ = false;
    bool uvs_ = false;
    std::array<std::size_t, role_count> at_{}; ///< by role: its place in the row of a vertex
    std::size_t vertex_bytes_ = 0;
    std::size_t list_at_ = 0; ///< place of the corners in the row of a face
    std::size_t face_bytes_ = 0;
    std::uint32_t limit_ = 0; ///< corners are below
};

} // namespace glint::ply
