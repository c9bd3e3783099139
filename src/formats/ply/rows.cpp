// Reading rows in any order, with any types, from text or bytes.

#include "formats/ply/rows.h"

#include "formats/ply/cursor.h"
#include "formats/ply/srgb8_table.h"
#include "geometry/point_cloud.h"
#include "math/far_origin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace glint::formats::ply {
namespace {

/// Converts to float; finite values stay finite.
float to_float(double value) {
    constexpr double max = std::numeric_limits<float>::max();
    if (std::isfinite(value)) value = std::clamp(value, -max, max);
    return static_cast<float>(value);
}

/// Non-finite directions and texture coordinates become 0.
float finite_or_zero(double value) { return std::isfinite(value) ? to_float(value) : 0.0f; }

/// Linear light of a stored colour. 8- and 16-bit values are sRGB codes, wider integers are clamped to 0 …
/// 255 and read as 8-bit codes; floats are linear, with negative values and NaN as black.
float to_light(double value, Type type) {
    if (type == Type::uint16) return imaging::linear_from_srgb16(static_cast<std::uint16_t>(value));
    if (is_integer(type)) return srgb8_table()[static_cast<std::size_t>(std::clamp(value, 0.0, 255.0))];
    return std::max(0.0f, finite_or_zero(value));
}

template <class Cursor>
class RowReader {
  public:
    RowReader(const Source& source, const Header& header, const MeshLayout& layout, const LoadWatch& watch,
              const dvec3& origin)
        : header_(header), layout_(layout), watch_(watch), cursor_(source, header.body), size_(source.size()),
          vertices_(header.elements[layout.vertex_element].count) {
        rows_.mesh.origin = origin;
    }

    Rows read() {
        for (std::size_t i = 0; i < header_.elements.size(); ++i) {
            const Element& element = header_.elements[i];
            if (element.properties.empty()) continue;
            check_row_count(element);
            if (i == layout_.vertex_element) {
                read_vertices(element);
            } else {
                read_other_rows(element, layout_.corners[i]);
            }
        }
        rows_.trailing = cursor_.trailing();
        return std::move(rows_);
    }

  private:
    using Values = std::array<double, role_count>;

    void begin_row(const Element& element, std::uint64_t row) {
        constexpr std::uint64_t rows_between = 1U << 14U;
        if (row % rows_between == 0) watch_.at(size_ - std::min(size_, cursor_.remaining()), size_);
        cursor_.begin_row(element, row);
    }

    /// Rejects row counts that exceed the rest of the file before allocating memory for them.
    void check_row_count(const Element& element) const {
        std::size_t min_size = 0;
        for (const Property& p : element.properties)
            min_size += Cursor::min_bytes(p.is_list() ? *p.count_type : p.type);
        const std::size_t max_rows = cursor_.remaining() / min_size;
        if (element.count > max_rows)
            cursor_.fail(cursor_.count_error_offset(element),
                         "the header promises " + std::to_string(element.count) + " rows of " +
                             quoted_word(element.name) + ", but the file has room for at most " +
                             std::to_string(max_rows),
                         "the file is cut, or its header is wrong");
    }

    std::uint64_t list_length(const Property& property, const Element& element, std::uint64_t row) {
        // Counts have 32 bits, so the product cannot overflow.
        const std::int64_t length = cursor_.integer(*property.count_type);
        const std::uint64_t min_size = Cursor::min_bytes(property.type);
        if (length < 0 || static_cast<std::uint64_t>(length) * min_size > cursor_.remaining())
            fail_length(length, property, element, row);
        return static_cast<std::uint64_t>(length);
    }

    [[noreturn]] void fail_length(std::int64_t length, const Property& list, const Element& element,
                                  std::uint64_t row) const {
        const std::size_t max_rows = cursor_.remaining() / Cursor::min_bytes(list.type);
        cursor_.fail(cursor_.value_offset(),
                     "list " + quoted_word(list.name) + " of " + row_name(element, row) + " claims " +
                         std::to_string(length) + " values",
                     length < 0 ? "a length cannot be negative"
                                : "there is room for at most " + std::to_string(max_rows) +
                                      ": the file is cut, or this length is wrong");
    }

    void skip_property(const Property& property, const Element& element, std::uint64_t row) {
        const std::uint64_t count = property.is_list() ? list_length(property, element, row) : 1;
        cursor_.skip(property.type, count);
    }

    void read_vertices(const Element& element) {
        const auto count = static_cast<std::size_t>(element.count);
        const VertexFormat& vertex = layout_.vertex;
        rows_.mesh.positions.resize(count);
        if (vertex.normals) rows_.mesh.normals.resize(count);
        if (vertex.colors) rows_.mesh.colors.resize(count);
        if (vertex.uvs) rows_.mesh.uvs.resize(count);

        Values values{};
        std::array<std::size_t, role_count> offsets{};
        for (std::size_t i = 0; i < count; ++i) {
            begin_row(element, i);
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const auto role = static_cast<std::size_t>(vertex.roles[p]);
                if (role == role_count) {
                    skip_property(element.properties[p], element, i);
                    continue;
                }
                values[role] = cursor_.number(vertex.types[role]);
                offsets[role] = cursor_.value_offset();
            }
            cursor_.end_row();
            store_vertex(i, values);
            check_vertex(i, values, offsets);
        }
    }

    void store_vertex(std::size_t i, const Values& values) {
        const auto value = [&](Role role) { return values[static_cast<std::size_t>(role)]; };
        const auto light = [&](Role role) {
            const Type type = layout_.vertex.types[static_cast<std::size_t>(role)];
            if (!is_integer(type)) rows_.max_float_color = std::max(rows_.max_float_color, value(role));
            return to_light(value(role), type);
        };
        Mesh& mesh = rows_.mesh;
        mesh.positions[i] = {to_float(value(Role::x) - mesh.origin.x),
                             to_float(value(Role::y) - mesh.origin.y),
                             to_float(value(Role::z) - mesh.origin.z)};
        if (layout_.vertex.normals)
            mesh.normals[i] = {finite_or_zero(value(Role::nx)), finite_or_zero(value(Role::ny)),
                               finite_or_zero(value(Role::nz))};
        if (layout_.vertex.colors) mesh.colors[i] = {light(Role::red), light(Role::green), light(Role::blue)};
        if (layout_.vertex.uvs)
            mesh.uvs[i] = {finite_or_zero(value(Role::u)), finite_or_zero(value(Role::v))};
    }

    /// Records invalid vertices. They are errors only if a face uses them, which is known at the end.
    void check_vertex(std::size_t i, const Values& values,
                      const std::array<std::size_t, role_count>& offsets) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (std::fabs(values[k]) <= coordinate_limit) continue;
            rows_.bad_vertices.push_back(
                {static_cast<std::uint32_t>(i), offsets[k], std::isfinite(values[k])});
            return;
        }
    }

    /// Reads the rows of any other element; `corners` is the property with the vertex indices of faces or
    /// strips, or −1.
    void read_other_rows(const Element& element, int corners) {
        const bool strips = is_strips(element);
        if (corners >= 0 && !strips)
            reserve_triangles(element, element.properties[static_cast<std::size_t>(corners)]);
        for (std::uint64_t row = 0; row < element.count; ++row) {
            begin_row(element, row);
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const Property& property = element.properties[p];
                if (static_cast<int>(p) != corners) {
                    skip_property(property, element, row);
                } else if (strips) {
                    read_strip(property, element, row);
                } else {
                    read_face(property, element, row);
                }
            }
            cursor_.end_row();
        }
    }

    void reserve_triangles(const Element& element, const Property& list) {
        const std::size_t min_size = Cursor::min_bytes(*list.count_type) + 3 * Cursor::min_bytes(list.type);
        const std::uint64_t max_rows = std::min<std::uint64_t>(element.count, cursor_.remaining() / min_size);
        rows_.mesh.triangles.reserve(rows_.mesh.triangles.size() + static_cast<std::size_t>(max_rows));
    }

    std::uint32_t checked(std::int64_t value, const Element& element, std::uint64_t row) const {
        if (static_cast<std::uint64_t>(value) >= vertices_) fail_index(value, element, row);
        return static_cast<std::uint32_t>(value);
    }

    [[noreturn]] void fail_index(std::int64_t value, const Element& element, std::uint64_t row) const {
        cursor_.fail(
            cursor_.value_offset(),
            "vertex index " + std::to_string(value) + " in " + row_name(element, row) + " is out of range",
            vertices_ == 1 ? std::string("the file has 1 vertex, so the only index is 0")
                           : "the file has " + std::to_string(vertices_) +
                                 " vertices, so indices go from 0 to " + std::to_string(vertices_ - 1));
    }

    void read_face(const Property& list, const Element& element, std::uint64_t row) {
        const std::uint64_t length = list_length(list, element, row);
        const std::size_t offset = cursor_.value_offset();
        if (length == 3) {
            glm::uvec3 triangle;
            int k = 0;
            cursor_.integers(list.type, 3,
                             [&](std::int64_t value) { triangle[k++] = checked(value, element, row); });
            rows_.mesh.triangles.push_back(triangle);
            return;
        }

        const std::size_t first = rows_.corners.size();
        cursor_.integers(list.type, length,
                         [&](std::int64_t value) { rows_.corners.push_back(checked(value, element, row)); });
        if (length > 3) {
            rows_.polygons.push_back(
                {rows_.mesh.triangles.size(), first, static_cast<std::size_t>(length), offset});
        } else {
            rows_.corners.resize(first);
            ++rows_.small_faces;
        }
    }

    /// A triangle strip: each corner makes a triangle with the two before it, with alternating orientation;
    /// −1 restarts. Triangles with repeated corners only flip the orientation.
    void read_strip(const Property& list, const Element& element, std::uint64_t row) {
        const std::uint64_t length = list_length(list, element, row);
        std::uint32_t older = 0;
        std::uint32_t old = 0;
        std::uint64_t since_start = 0;
        cursor_.integers(list.type, length, [&](std::int64_t value) {
            if (value == -1) {
                since_start = 0;
                return;
            }
            const std::uint32_t corner = checked(value, element, row);
            const bool repeats = corner == old || corner == older || old == older;
            if (since_start >= 2 && !repeats) {
                const bool turned = since_start % 2 == 1;
                rows_.mesh.triangles.emplace_back(turned ? old : older, turned ? older : old, corner);
            }
            older = old;
            old = corner;
            ++since_start;
        });
    }

    const Header& header_;
    const MeshLayout& layout_;
    const LoadWatch& watch_;
    Cursor cursor_;
    std::size_t size_; ///< of the file
    std::uint64_t vertices_;
    Rows rows_;
};

/// The same layout, but coordinates written as text are read with all their digits.
MeshLayout with_all_digits(MeshLayout layout) {
    for (const Role role : {Role::x, Role::y, Role::z}) {
        Type& type = layout.vertex.types[static_cast<std::size_t>(role)];
        if (type == Type::float32) type = Type::float64;
    }
    return layout;
}

} // namespace

Rows read_rows(const Source& source, const Header& header, const MeshLayout& layout, const LoadWatch& watch,
               const dvec3& origin) {
    switch (header.format) {
    case PlyFormat::ascii: {
        // Without an origin coordinates are rounded once, from text to float.
        const MeshLayout text_layout = origin == dvec3(0) ? layout : with_all_digits(layout);
        return RowReader<TextCursor>(source, header, text_layout, watch, origin).read();
    }
    case PlyFormat::binary_little_endian:
        return RowReader<BinaryCursor<std::endian::little>>(source, header, layout, watch, origin).read();
    default:
        return RowReader<BinaryCursor<std::endian::big>>(source, header, layout, watch, origin).read();
    }
}

Bounds bounds_of_faces(const Rows& rows, std::size_t step) {
    const std::vector<vec3>& positions = rows.mesh.positions;
    Bounds bounds;
    const auto grow = [&](const vec3& p) {
        if (largest(rows.mesh.origin + dvec3(p)) <= coordinate_limit) bounds.grow(p);
    };
    const std::vector<uvec3>& triangles = rows.mesh.triangles;
    for (std::size_t i = 0; i < triangles.size(); i += step)
        for (int k = 0; k < 3; ++k) grow(positions[triangles[i][k]]);
    for (std::size_t i = 0; i < rows.corners.size(); i += step) grow(positions[rows.corners[i]]);
    if (!triangles.empty() || !rows.corners.empty()) return bounds;
    const Bounds kept = geometry::cloud_without_outliers(positions);
    for (std::size_t i = 0; i < positions.size(); i += step)
        if (kept.contains(positions[i])) grow(positions[i]);
    return bounds;
}

std::size_t sparse_step(const Rows& rows) {
    const std::size_t faces = std::max(rows.mesh.triangles.size(), rows.corners.size());
    return 1 + (faces > 0 ? faces : rows.mesh.positions.size()) / 64;
}

dvec3 origin_step(const Rows& rows) {
    if (far_origin(bounds_of_faces(rows, sparse_step(rows))) == dvec3(0)) return dvec3(0);
    return far_origin(bounds_of_faces(rows));
}

} // namespace glint::formats::ply
