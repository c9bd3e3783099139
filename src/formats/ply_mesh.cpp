#include "formats/ply_mesh.h"

#include "geometry/mesh.h"
#include "geometry/polygon.h"

#include <algorithm>
#include <charconv>

namespace glint::ply {
namespace {

std::string counted(std::uint64_t n, const char* one, const char* many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
}

/// "2.5": the shortest text of a number.
std::string number_text(double value) {
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, static_cast<float>(value)).ptr};
}

class Assembler {
  public:
    Assembler(const Source& source, const Header& header, const Layout& layout, Body body,
              const LoadWatch& watch)
        : source_(source), header_(header), layout_(layout), body_(std::move(body)), watch_(watch) {}

    LoadedMesh assemble() {
        go_on();
        refuse_bad_vertices_in_use();
        go_on();
        split_polygons();
        go_on();
        const std::uint64_t dropped = body_.small_faces + drop_degenerate(mesh().positions, mesh().triangles);
        if (dropped > 0)
            warn("dropped " + counted(dropped, "degenerate face", "degenerate faces"),
                 "they have fewer than three different corners, or no area");
        go_on();
        drop_bad_vertices();
        warn_of_missing_faces();
        warn_of_the_rest();
        return {std::make_shared<const Mesh>(std::move(mesh())), std::move(warnings_)};
    }

  private:
    Mesh& mesh() { return body_.mesh; }

    /// All is read, but a large mesh takes its time still: between the passes the caller may have had enough.
    void go_on() const { watch_.at(1, 1); }

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
        if (body_.bad_vertices.empty()) return;
        std::vector<bool> used(mesh().positions.size(), false);
        for (const uvec3& t : mesh().triangles) used[t.x] = used[t.y] = used[t.z] = true;
        for (const std::uint32_t corner : body_.corners) used[corner] = true;
        for (const Body::BadVertex& bad : body_.bad_vertices) {
            if (!used[bad.vertex]) continue;
            const std::string name = "vertex " + std::to_string(bad.vertex);
            if (bad.finite)
                fail(bad.offset, name + " lies beyond 10^12, and a face uses it",
                     "coordinates must be within ±10^12: scale the mesh down");
            fail(bad.offset, name + " is not finite, and a face uses it",
                 "correct this coordinate, or remove the faces that use the vertex");
        }
    }

    /// Puts the triangles of each polygon where the polygon stood among the faces.
    void split_polygons() {
        if (body_.polygons.empty()) return;
        const std::vector<uvec3> whole = std::move(mesh().triangles);
        std::vector<uvec3> all;
        all.reserve(whole.size() + body_.corners.size() - 2 * body_.polygons.size());
        auto next = whole.begin();
        for (const Body::Polygon& polygon : body_.polygons) {
            const auto before = whole.begin() + static_cast<std::ptrdiff_t>(polygon.triangles_before);
            all.insert(all.end(), next, before);
            next = before;
            const auto corners = std::span(body_.corners).subspan(polygon.first, polygon.size);
            if (!triangulate(mesh().positions, corners, all))
                fail(polygon.offset,
                     "a concave face of " + std::to_string(polygon.size) + " corners is too large",
                     "split it: concave faces may have up to " + std::to_string(max_concave_corners) +
                         " corners");
        }
        all.insert(all.end(), next, whole.end());
        mesh().triangles = std::move(all);
    }

    void drop_bad_vertices() {
        if (body_.bad_vertices.empty()) return;
        warn("dropped " + counted(body_.bad_vertices.size(), "vertex that is", "vertices that are") +
                 " not finite or beyond 10^12",
             "no face uses " + std::string(body_.bad_vertices.size() == 1 ? "it" : "them"));
        const std::size_t before = mesh().positions.size();
        if (body_.bad_vertices.size() == before)
            fail(body_.bad_vertices.front().offset, "no vertex of the file is finite and within ±10^12",
                 "there is nothing to draw");

        // New numbers for the vertices that stay.
        std::vector<std::uint32_t> number(before);
        std::vector<bool> bad(before, false);
        for (const Body::BadVertex& vertex : body_.bad_vertices) bad[vertex.vertex] = true;
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
            if (element.count > 0 && nearest_name(element.name, {"face", "faces", "triangle", "triangles"}))
                hint = "did you mean 'face' by " + in_marks(element.name) + "?";
        warn("the file has no faces: it is drawn as a point cloud", hint);
    }

    void warn_of_the_rest() {
        if (body_.brightest > 1)
            warn("vertex colours of type float go up to " + number_text(body_.brightest),
                 "they are read as linear light from 0 to 1; sRGB codes are stored as uchar");
        if (body_.trailing > 0)
            warn(counted(body_.trailing, "byte follows", "bytes follow") + " the last element",
                 "the header may count too few rows");
    }

    const Source& source_;
    const Header& header_;
    const Layout& layout_;
    Body body_;
    const LoadWatch& watch_;
    std::vector<Diagnostic> warnings_;
};

} // namespace

LoadedMesh assemble(const Source& source, const Header& header, const Layout& layout, Body body,
                    const LoadWatch& watch) {
    return Assembler(source, header, layout, std::move(body), watch).assemble();
}

} // namespace glint::ply
