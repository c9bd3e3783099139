// The fast reader of binary files with fixed-size rows.

#include "formats/ply/fixed_rows.h"

#include "formats/ply/srgb8_table.h"
#include "parallel/large_pages.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace glint::formats::ply {
namespace {

template <class Value>
Value value_at(const char* bytes) {
    Value value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

float finite_or_zero(float value) { return std::isfinite(value) ? value : 0.0f; }

/// Whether rows of `bytes` each fit into a file of `size`; guards against overflow, as a header may declare
/// any number.
bool fits(std::uint64_t rows, std::size_t bytes, std::size_t size) { return rows <= size / bytes; }

} // namespace

std::optional<FixedRowReader> FixedRowReader::begin(const Header& header, const MeshLayout& layout,
                                                    std::size_t size) {
    constexpr bool little = std::endian::native == std::endian::little;
    if (header.format != (little ? PlyFormat::binary_little_endian : PlyFormat::binary_big_endian)) return {};
    if (header.elements.size() != 2 || layout.vertex_element != 0 || layout.corners[1] < 0) return {};
    const Element& vertices = header.elements[0];
    const Element& faces = header.elements[1];
    FixedRowReader reader;
    if (is_strips(faces) || !reader.set_vertex_format(vertices, layout.vertex) ||
        !reader.set_face_format(faces, layout.corners[1], vertices.count))
        return {};

    if (!fits(vertices.count, reader.vertex_bytes_, size) || !fits(faces.count, reader.face_bytes_, size) ||
        header.body + vertices.count * reader.vertex_bytes_ + faces.count * reader.face_bytes_ != size)
        return {};
    reader.vertices_left_ = vertices.count;
    reader.faces_left_ = faces.count;
    parallel::reserve_large(reader.mesh_.positions, vertices.count);
    if (reader.normals_) parallel::reserve_large(reader.mesh_.normals, vertices.count);
    if (reader.colors_) parallel::reserve_large(reader.mesh_.colors, vertices.count);
    if (reader.uvs_) parallel::reserve_large(reader.mesh_.uvs, vertices.count);
    parallel::reserve_large(reader.mesh_.triangles, faces.count);
    return reader;
}

bool FixedRowReader::set_vertex_format(const Element& element, const VertexFormat& format) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const Property& property = element.properties[p];
        if (property.is_list()) return false;
        const Role role = format.roles[p];
        if (role != Role::none) {
            const bool is_color = role == Role::red || role == Role::green || role == Role::blue;
            if (property.type != (is_color ? Type::uint8 : Type::float32)) return false;
            offset_[static_cast<std::size_t>(role)] = vertex_bytes_;
        }
        vertex_bytes_ += size_of(property.type);
    }
    normals_ = format.normals;
    colors_ = format.colors;
    uvs_ = format.uvs;
    return true;
}

bool FixedRowReader::set_face_format(const Element& element, int corners, std::uint64_t vertices) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const Property& property = element.properties[p];
        if (static_cast<int>(p) != corners) {
            if (property.is_list()) return false;
            face_bytes_ += size_of(property.type);
            continue;
        }
        if (*property.count_type != Type::uint8 || size_of(property.type) != sizeof(std::uint32_t))
            return false;
        // Negative indices of type int are beyond this limit as uint.
        const std::uint64_t max_index = property.type == Type::int32 ? 0x80000000u : 0xffffffffu;
        limit_ = static_cast<std::uint32_t>(std::min(vertices, max_index));
        list_offset_ = face_bytes_;
        face_bytes_ += 1 + 3 * sizeof(std::uint32_t);
    }
    return true;
}

std::optional<std::size_t> FixedRowReader::take(std::span<const std::byte> bytes) {
    const char* const begin = reinterpret_cast<const char*>(bytes.data());
    const char* const end = begin + bytes.size();
    const char* at = begin;
    if (vertices_left_ > 0) at = take_vertices(at, end);
    if (at != nullptr && vertices_left_ == 0) at = take_faces(at, end);
    if (at == nullptr) return {};
    return static_cast<std::size_t>(at - begin);
}

Rows FixedRowReader::finish() {
    Rows rows{.mesh = std::move(mesh_), .polygons = {}, .corners = {}, .bad_vertices = {}};
    const dvec3 origin = origin_step(rows);
    if (origin == dvec3(0)) return rows;
    for (vec3& p : rows.mesh.positions) p = vec3(dvec3(p) - origin);
    rows.mesh.origin = origin;
    return rows;
}

/// Returns the position after the last row read, or null at an unusual row.
const char* FixedRowReader::take_vertices(const char* row, const char* end) {
    const std::array<float, 256>& light = srgb8_table();
    const std::uint64_t whole = static_cast<std::size_t>(end - row) / vertex_bytes_;
    const std::uint64_t rows = std::min(vertices_left_, whole);
    for (std::uint64_t i = 0; i < rows; ++i, row += vertex_bytes_) {
        const auto at = [&](Role role) { return row + offset_[static_cast<std::size_t>(role)]; };
        const auto number = [&](Role role) { return value_at<float>(at(role)); };
        const auto finite = [&](Role role) { return finite_or_zero(number(role)); };
        const auto code = [&](Role role) { return light[value_at<std::uint8_t>(at(role))]; };
        const glm::vec3 p(number(Role::x), number(Role::y), number(Role::z));
        constexpr auto max = static_cast<float>(coordinate_limit);
        if (!(std::fabs(p.x) < max && std::fabs(p.y) < max && std::fabs(p.z) < max)) return nullptr;
        mesh_.positions.push_back(p);
        if (normals_) mesh_.normals.emplace_back(finite(Role::nx), finite(Role::ny), finite(Role::nz));
        if (colors_) mesh_.colors.emplace_back(code(Role::red), code(Role::green), code(Role::blue));
        if (uvs_) mesh_.uvs.emplace_back(finite(Role::u), finite(Role::v));
    }
    vertices_left_ -= rows;
    return row;
}

const char* FixedRowReader::take_faces(const char* row, const char* end) {
    const std::uint64_t whole = static_cast<std::size_t>(end - row) / face_bytes_;
    const std::uint64_t rows = std::min(faces_left_, whole);
    for (std::uint64_t i = 0; i < rows; ++i, row += face_bytes_) {
        const char* list = row + list_offset_;
        const glm::uvec3 corners(value_at<std::uint32_t>(list + 1), value_at<std::uint32_t>(list + 5),
                                 value_at<std::uint32_t>(list + 9));
        const bool inside = corners.x < limit_ && corners.y < limit_ && corners.z < limit_;
        if (*list != 3 || !inside) return nullptr;
        mesh_.triangles.push_back(corners);
    }
    faces_left_ -= rows;
    return row;
}

} // namespace glint::formats::ply
