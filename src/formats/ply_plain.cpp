#include "formats/ply_plain.h"

#include "formats/ply_light.h"
#include "parallel/large_pages.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace glint::ply {
namespace {

template <class Value>
Value value_at(const char* bytes) {
    Value value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

float finite_or_zero(float value) { return std::isfinite(value) ? value : 0.0f; }

/// Rows of `bytes` that fit into a file of `size`; a header may promise any number.
bool fits(std::uint64_t rows, std::size_t bytes, std::size_t size) { return rows <= size / bytes; }

} // namespace

std::optional<PlainBody> PlainBody::begin(const Header& header, const Layout& layout, std::size_t size) {
    constexpr bool little = std::endian::native == std::endian::little;
    if (header.format != (little ? PlyFormat::binary_little_endian : PlyFormat::binary_big_endian)) return {};
    if (header.elements.size() != 2 || layout.vertex_element != 0 || layout.corners[1] < 0) return {};
    const Element& vertices = header.elements[0];
    const Element& faces = header.elements[1];
    PlainBody body;
    if (is_strips(faces) || !body.plan_vertices(vertices, layout.vertex) ||
        !body.plan_faces(faces, layout.corners[1], vertices.count))
        return {};

    if (!fits(vertices.count, body.vertex_bytes_, size) || !fits(faces.count, body.face_bytes_, size) ||
        header.body + vertices.count * body.vertex_bytes_ + faces.count * body.face_bytes_ != size)
        return {};
    body.vertices_left_ = vertices.count;
    body.faces_left_ = faces.count;
    parallel::reserve_large(body.mesh_.positions, vertices.count);
    if (body.normals_) parallel::reserve_large(body.mesh_.normals, vertices.count);
    if (body.colors_) parallel::reserve_large(body.mesh_.colors, vertices.count);
    if (body.uvs_) parallel::reserve_large(body.mesh_.uvs, vertices.count);
    parallel::reserve_large(body.mesh_.triangles, faces.count);
    return body;
}

bool PlainBody::plan_vertices(const Element& element, const VertexLayout& layout) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const Property& property = element.properties[p];
        if (property.is_list()) return false;
        const Role role = layout.roles[p];
        if (role != Role::none) {
            const bool is_color = role == Role::red || role == Role::green || role == Role::blue;
            if (property.type != (is_color ? Type::uint8 : Type::float32)) return false;
            at_[static_cast<std::size_t>(role)] = vertex_bytes_;
        }
        vertex_bytes_ += size_of(property.type);
    }
    normals_ = layout.normals;
    colors_ = layout.colors;
    uvs_ = layout.uvs;
    return true;
}

bool PlainBody::plan_faces(const Element& element, int corners, std::uint64_t vertices) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const Property& property = element.properties[p];
        if (static_cast<int>(p) != corners) {
            if (property.is_list()) return false;
            face_bytes_ += size_of(property.type);
            continue;
        }
        if (*property.count_type != Type::uint8 || size_of(property.type) != sizeof(std::uint32_t))
            return false;
        // What is negative as int lies beyond the limit as uint.
        const std::uint64_t most = property.type == Type::int32 ? 0x80000000u : 0xffffffffu;
        limit_ = static_cast<std::uint32_t>(std::min(vertices, most));
        list_at_ = face_bytes_;
        face_bytes_ += 1 + 3 * sizeof(std::uint32_t);
    }
    return true;
}

std::optional<std::size_t> PlainBody::take(std::span<const std::byte> bytes) {
    const char* const begin = reinterpret_cast<const char*>(bytes.data());
    const char* const end = begin + bytes.size();
    const char* at = begin;
    if (vertices_left_ > 0) at = take_vertices(at, end);
    if (at != nullptr && vertices_left_ == 0) at = take_faces(at, end);
    if (at == nullptr) return {};
    return static_cast<std::size_t>(at - begin);
}

/// The row after those taken, or null for an unusual one.
const char* PlainBody::take_vertices(const char* row, const char* end) {
    const std::array<float, 256>& light = light_of_codes();
    const std::uint64_t whole = static_cast<std::size_t>(end - row) / vertex_bytes_;
    const std::uint64_t rows = std::min(vertices_left_, whole);
    for (std::uint64_t i = 0; i < rows; ++i, row += vertex_bytes_) {
        const auto place = [&](Role role) { return row + at_[static_cast<std::size_t>(role)]; };
        const auto number = [&](Role role) { return value_at<float>(place(role)); };
        const auto finite = [&](Role role) { return finite_or_zero(number(role)); };
        const auto code = [&](Role role) { return light[value_at<std::uint8_t>(place(role))]; };
        const glm::vec3 p(number(Role::x), number(Role::y), number(Role::z));
        constexpr auto greatest = static_cast<float>(coordinate_limit);
        if (!(std::fabs(p.x) < greatest && std::fabs(p.y) < greatest && std::fabs(p.z) < greatest))
            return nullptr;
        mesh_.positions.push_back(p);
        if (normals_) mesh_.normals.emplace_back(finite(Role::nx), finite(Role::ny), finite(Role::nz));
        if (colors_) mesh_.colors.emplace_back(code(Role::red), code(Role::green), code(Role::blue));
        if (uvs_) mesh_.uvs.emplace_back(finite(Role::u), finite(Role::v));
    }
    vertices_left_ -= rows;
    return row;
}

const char* PlainBody::take_faces(const char* row, const char* end) {
    const std::uint64_t whole = static_cast<std::size_t>(end - row) / face_bytes_;
    const std::uint64_t rows = std::min(faces_left_, whole);
    for (std::uint64_t i = 0; i < rows; ++i, row += face_bytes_) {
        const char* list = row + list_at_;
        const glm::uvec3 corners(value_at<std::uint32_t>(list + 1), value_at<std::uint32_t>(list + 5),
                                 value_at<std::uint32_t>(list + 9));
        const bool inside = corners.x < limit_ && corners.y < limit_ && corners.z < limit_;
        if (*list != 3 || !inside) return nullptr;
        mesh_.triangles.push_back(corners);
    }
    faces_left_ -= rows;
    return row;
}

} // namespace glint::ply
