#pragma once
// What the elements and properties of a header mean for a mesh.

#include "formats/ply_header.h"

#include <array>
#include <cstdint>
#include <vector>

namespace glint::ply {

/// What a number of a vertex is.
enum class Role : std::uint8_t { x, y, z, nx, ny, nz, red, green, blue, u, v, none };
inline constexpr std::size_t role_count = static_cast<std::size_t>(Role::none);

/// How the vertex element is read. A group of roles that is not whole is left out.
struct VertexLayout {
    std::vector<Role> roles; ///< by property; lists have none
    std::array<Type, role_count> types{};
    bool normals = false;
    bool colors = false;
    bool uvs = false;
};

/// What the header says about the mesh. Elements and properties that are not named here are passed over.
struct Layout {
    std::size_t vertex_element = 0;
    VertexLayout vertex;
    /// By element: the property that lists the corners of faces or tristrips, or −1.
    std::vector<int> corners;
    bool has_faces = false; ///< some face or strip is promised
};

/// Finds vertices, faces and tristrips, under all usual spellings. Throws Error(input) where the header makes
/// no mesh: no vertices, or two such elements, no x y z, faces without a list of whole numbers.
Layout understand(const Source& source, const Header& header);

bool is_strips(const Element& element);

} // namespace glint::ply
