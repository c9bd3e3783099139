// From rows to a mesh: checks vertices, triangulates polygons, drops degenerate faces, and collects warnings.

#include "formats/ply/mesh.h"

#include "geometry/mesh.h"
#include "geometry/polygon.h"
#include "scene/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace glint::formats::ply {
namespace {

std::string count_text(std::uint64_t n, const char* one, const char* many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
}

/// Shortest text of a number, such as "2.5".
std::string number_text(double value) {
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, static_cast<float>(value)).ptr};
}

class Assembler {
  public:
    Assembler(const Source& source, const Header& header, const MeshLayout& layout, Rows rows,
              const LoadWatch& watch)
        : source_(source), header_(header), layout_(layout), rows_(std::move(rows)), watch_(watch) {}

    LoadedMesh assemble() {
        poll_cancel();
        refuse_bad_vertices_in_use();
        poll_cancel();
        split_polygons();
        poll_cancel();
        const std::uint64_t dropped =
            rows_.small_faces + geometry::drop_degenerate(mesh().positions, mesh().triangles);
        if (dropped > 0)
            warn("dropped " + count_text(dropped, "degenerate face", "degenerate faces"),
                 "they have fewer than three different corners, or no area");
        poll_cancel();
        drop_bad_vertices();
        warn_of_missing_faces();
        warn_of_rounding();
        warn_of_the_rest();
        warn_of_what_is_not_drawn();
        return {std::make_shared<const Mesh>(std::move(mesh())), std::move(warnings_)};
    }

  private:
    Mesh& mesh() { return rows_.mesh; }

    /// Poll for cancellation between passes.
    void poll_cancel() const { watch_.at(1, 1); }

    void warn(std::string message, std::string hint) {
        const Location where{source_.name(), 0, 0, {}};
        warnings_.push_back({Severity::warning, where, std::move(message), std::move(hint), {}});
    }

    [[noreturn]] void fail(std::size_t offset, std::string message, std::string hint) const {
        if (header_.format == PlyFormat::ascii)
            source_.fail_in_text(offset, std::move(message), std::move(hint));
        source_.fail_at_byte(offset, std::move(message), std::move(hint));
    }

    void refuse_bad_vertices_in_use() {
        if (rows_.bad_vertices.empty()) return;
        std::vector<bool> used(mesh().positions.size(), false);
        for (const uvec3& t : mesh().triangles) used[t.x] = used[t.y] = used[t.z] = true;
        for (const std::uint32_t corner : rows_.corners) used[corner] = true;
        for (const Rows::BadVertex& bad : rows_.bad_vertices) {
            if (!used[bad.vertex]) continue;
            const std::string name = "vertex " + std::to_string(bad.vertex);
            if (bad.finite)
                fail(bad.offset, name + " lies beyond 10^12, and a face uses it",
                     "coordinates must be within ±10^12: scale the mesh down");
            fail(bad.offset, name + " is not finite, and a face uses it",
                 "correct this coordinate, or remove the faces that use the vertex");
        }
    }

    /// Triangulates polygons in the order of the faces.
    void split_polygons() {
        if (rows_.polygons.empty()) return;
        const std::vector<uvec3> whole = std::move(mesh().triangles);
        std::vector<uvec3> all;
        all.reserve(whole.size() + rows_.corners.size() - 2 * rows_.polygons.size());
        auto next = whole.begin();
        for (const Rows::Polygon& polygon : rows_.polygons) {
            const auto before = whole.begin() + static_cast<std::ptrdiff_t>(polygon.triangles_before);
            all.insert(all.end(), next, before);
            next = before;
            const auto corners = std::span(rows_.corners).subspan(polygon.first, polygon.size);
            if (!geometry::triangulate(mesh().positions, corners, all))
                fail(polygon.offset,
                     "a concave face of " + std::to_string(polygon.size) + " corners is too large",
                     "split it: concave faces may have up to " +
                         std::to_string(geometry::max_concave_corners) + " corners");
        }
        all.insert(all.end(), next, whole.end());
        mesh().triangles = std::move(all);
        rows_.polygons = {};
        rows_.corners = {};
    }

    void drop_bad_vertices() {
        if (rows_.bad_vertices.empty()) return;
        warn("dropped " + count_text(rows_.bad_vertices.size(), "vertex that is", "vertices that are") +
                 " not finite or beyond 10^12",
             "no face uses " + std::string(rows_.bad_vertices.size() == 1 ? "it" : "them"));
        const std::size_t before = mesh().positions.size();
        if (rows_.bad_vertices.size() == before)
            fail(rows_.bad_vertices.front().offset, "no vertex of the file is finite and within ±10^12",
                 "there is nothing to draw");

        // Renumber the remaining vertices.
        std::vector<std::uint32_t> number(before);
        std::vector<bool> bad(before, false);
        for (const Rows::BadVertex& vertex : rows_.bad_vertices) bad[vertex.vertex] = true;
        std::uint32_t kept = 0;
        for (std::size_t i = 0; i < before; ++i) number[i] = bad[i] ? kept : kept++;
        for (uvec3& t : mesh().triangles) t = {number[t.x], number[t.y], number[t.z]};

        const auto keep = [&](auto& values) {
            if (values.empty()) return;
            for (std::size_t i = 0; i < before; ++i)
                if (!bad[i]) values[number[i]] = values[i];
            values.resize(kept);
        };
        keep(mesh().positions);
        keep(mesh().normals);
        keep(mesh().colors);
        keep(mesh().uvs);
    }

    void warn_of_missing_faces() {
        if (!mesh().triangles.empty()) return;
        if (layout_.has_faces) {
            warn("no face is left: the file is drawn as a point cloud", "all its faces are degenerate");
            return;
        }
        std::string hint = "each vertex becomes a small sphere; 'point_radius' sets its size";
        for (const Element& element : header_.elements)
            if (element.count > 0 && may_mean_faces(element))
                hint = "did you mean 'face' by " + quoted_word(element.name) + "?";
        warn("the file has no faces: it is drawn as a point cloud", hint);
    }

    /// How far single precision may move a vertex: in the file if that stores floats, otherwise in the mesh.
    struct Rounding {
        double size = 0;       ///< of the mesh
        double coordinate = 0; ///< the largest
        double error = 0;      ///< half the distance of neighbouring floats there

        static constexpr double side = 1000; ///< of a picture, in pixels
        /// Of a mesh that rounding has made smaller than its error the true size is not known.
        double pixels() const { return error > 0 ? error / std::max(size, 2 * error) * side : 0; }
    };
    Rounding rounding(std::size_t step) const {
        const Bounds bounds = bounds_of_faces(rows_, step);
        const dvec3 lo(bounds.lo), hi(bounds.hi);
        Rounding found{largest(hi - lo)};
        for (int axis = 0; axis < 3; ++axis) {
            const double stored = std::max(std::abs(lo[axis]), std::abs(hi[axis]));
            const double written = std::max(std::abs(lo[axis] + rows_.mesh.origin[axis]),
                                            std::abs(hi[axis] + rows_.mesh.origin[axis]));
            const bool floats = header_.format != PlyFormat::ascii &&
                                layout_.vertex.types[static_cast<std::size_t>(axis)] == Type::float32;
            found.coordinate = std::max(found.coordinate, written);
            found.error = std::max(found.error, (floats ? written : stored) * 0x1p-24);
        }
        return found;
    }

    void warn_of_rounding() {
        constexpr double visible = 0.1; // pixels
        if (mesh().positions.size() < 2) return;
        if (!(rounding(sparse_step(rows_)).pixels() > visible)) return;
        const Rounding found = rounding(1);
        if (!(found.pixels() > visible)) return;
        warn("the mesh is " + number_text(found.size) + " in size and lies at coordinates up to " +
                 number_text(found.coordinate) + ": single precision moves its vertices by up to " +
                 scene::rounded(found.error) + ", about " + scene::rounded(found.pixels()) +
                 " pixels where it fills a picture of 1000",
             "write its coordinates as double, and without vertices far from the others; or subtract a "
             "common offset from them before");
    }

    void warn_of_the_rest() {
        if (rows_.max_float_color > 1)
            warn("vertex colours of type float go up to " + number_text(rows_.max_float_color),
                 "they are read as linear light from 0 to 1; sRGB codes are stored as uchar");
        if (rows_.trailing > 0)
            warn(count_text(rows_.trailing, "byte follows", "bytes follow") + " the last element",
                 "the header may count too few rows");
    }

    void warn_of_what_is_not_drawn() {
        const auto lacking = std::ranges::count(mesh().normals, vec3(0.0f));
        if (lacking > 0)
            warn(count_text(static_cast<std::uint64_t>(lacking), "vertex has", "vertices have") +
                     " a normal that is 0 or not finite",
                 "where normals add up to 0, faces are shaded flat; normals = \"smooth\" computes all");
        constexpr std::size_t max_shown = 8;
        const std::vector<std::string> names = not_drawn(header_, layout_);
        if (names.empty()) return;
        std::string text;
        for (std::size_t i = 0; i < names.size() && i < max_shown; ++i) text += (i ? ", " : "") + names[i];
        if (names.size() > max_shown) text += " and " + std::to_string(names.size() - max_shown) + " more";
        warn("not drawn: " + text, "of a mesh, its vertices with their normals and colours, and its faces "
                                   "are drawn; textures are not");
    }

    const Source& source_;
    const Header& header_;
    const MeshLayout& layout_;
    Rows rows_;
    const LoadWatch& watch_;
    std::vector<Diagnostic> warnings_;
};

} // namespace

LoadedMesh assemble(const Source& source, const Header& header, const MeshLayout& layout, Rows rows,
                    const LoadWatch& watch) {
    return Assembler(source, header, layout, std::move(rows), watch).assemble();
}

} // namespace glint::formats::ply
