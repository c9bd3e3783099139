#pragma once
// Interpretation of a header as a mesh.

#include "formats/ply/header.h"

#include <array>
#include <cstdint>
#include <vector>

namespace glint::formats::ply {

/// Meaning of a vertex property.
enum class Role : std::uint8_t { x, y, z, nx, ny, nz, red, green, blue, u, v, none };
inline constexpr std::size_t role_count = static_cast<std::size_t>(Role::none);

/// Properties of the vertex element. Incomplete groups of roles (normals, colours, texture coordinates) are
/// ignored.
struct VertexFormat {
    std::vector<Role> roles; ///< by property; Role::none for lists
    std::array<Type, role_count> types{};
    bool normals = false;
    bool colors = false;
    bool uvs = false;
};

/// Where the mesh is in the file. Other elements and properties are skipped.
struct MeshLayout {
    std::size_t vertex_element = 0;
    VertexFormat vertex;
    /// By element: the property with the vertex indices of faces or strips, or −1.
    std::vector<int> corners;
    bool has_faces = false; ///< the header declares at least one face or strip
};

/// Finds vertices, faces and triangle strips under all common names. Throws Error(input) if the header
/// describes no mesh: no vertex element or two of them, no x, y or z, or faces without a list of integers.
MeshLayout interpret_header(const Source& source, const Header& header);

bool is_strips(const Element& element);
/// Is its name close to that of faces?
bool may_mean_faces(const Element& element);

/// What is in the file and not in the mesh, or not drawn, by name: "texture coordinates 's' of vertex".
std::vector<std::string> not_drawn(const Header& header, const MeshLayout& layout);

} // namespace glint::formats::ply
