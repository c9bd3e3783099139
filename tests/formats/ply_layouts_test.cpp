// The rows that are read at once against the same mesh in rows that are not: a property more, which nobody
// wants, makes all the difference to the reader and none to the mesh.

#include "ply_files.h"

#include <glm/vec3.hpp>

#include <cmath>
#include <limits>
#include <random>

namespace glint {
namespace {

using namespace ply_test;
using glm::uvec3;
using glm::vec3;

struct Rows {
    std::vector<vec3> points;
    std::vector<std::vector<std::uint32_t>> faces;
};

/// Mostly triangles, some polygons, and now and then what must be refused, warned of or dropped.
Rows random_rows(std::mt19937& random) {
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
    Rows rows;
    const std::uint32_t points = 4 + below(60);
    const bool faulty = below(3) == 0;
    for (std::uint32_t i = 0; i < points; ++i) {
        vec3 p(static_cast<float>(below(1000)), static_cast<float>(below(1000)),
               static_cast<float>(below(1000)));
        const float odd[] = {std::nanf(""), std::numeric_limits<float>::infinity(), 2e12f, -1e12f};
        if (faulty && below(40) == 0) p[static_cast<int>(below(3))] = odd[below(4)];
        rows.points.push_back(p);
    }
    for (std::uint32_t i = 0, faces = 1 + below(80); i < faces; ++i) {
        const std::uint32_t corners = below(8) == 0 ? below(6) : 3;
        std::vector<std::uint32_t> face;
        for (std::uint32_t k = 0; k < corners; ++k) face.push_back(below(points));
        if (faulty && corners > 0 && below(60) == 0)
            face[below(corners)] = below(2) == 0 ? points : 0xffffffffu;
        rows.faces.push_back(face);
    }
    return rows;
}

/// `extra`: each vertex has a list and each face a number besides.
std::string file_of(const Rows& rows, std::endian order, bool extra) {
    std::string head = "ply\n" + binary_format(order) + "element vertex " +
                       std::to_string(rows.points.size()) +
                       "\nproperty short tag\nproperty float y\nproperty float x\nproperty float z\n" +
                       (extra ? "property list uchar uchar notes\n" : "") + "element face " +
                       std::to_string(rows.faces.size()) + "\nproperty list uchar int vertex_indices\n" +
                       (extra ? "property uchar mark\n" : "") + "end_header\n";
    Bytes body(order);
    for (const vec3& p : rows.points) {
        body.u8(1).u8(2).f32(p.y).f32(p.x).f32(p.z);
        if (extra) body.u8(2).u8(3).u8(3);
    }
    for (const auto& face : rows.faces) {
        body.u8(static_cast<std::uint8_t>(face.size()));
        for (const std::uint32_t corner : face) body.i32(static_cast<std::int32_t>(corner));
        if (extra) body.u8(3);
    }
    return head + std::string(body);
}

/// The mesh's numbers and the warnings' words, or the error's: but for the place in the file, which differs.
std::string told(const std::string& file) {
    std::string text;
    try {
        const LoadedMesh loaded = parse(file);
        for (const vec3& p : loaded.mesh->positions)
            for (int k = 0; k < 3; ++k) text += std::to_string(p[k]) + " ";
        for (const uvec3& t : loaded.mesh->triangles)
            for (int k = 0; k < 3; ++k) text += std::to_string(t[k]) + " ";
        for (const Diagnostic& warning : loaded.warnings) text += warning.message + "; ";
    } catch (const Error& error) {
        text = error.diagnostics().front().message;
    }
    return text;
}

TEST(PlyLayouts, RowsReadAtOnceAreTheRowsReadOneByOne) {
    std::mt19937 random(7);
    int refused = 0;
    for (int i = 0; i < 400; ++i) {
        const Rows rows = random_rows(random);
        const std::string expected = told(file_of(rows, std::endian::little, true));
        refused += expected.find("is not finite, and a face uses it") != std::string::npos ||
                   expected.find("out of range") != std::string::npos;
        EXPECT_EQ(told(file_of(rows, std::endian::little, false)), expected) << "case " << i;
        EXPECT_EQ(told(file_of(rows, std::endian::big, false)), expected) << "case " << i;
    }
    EXPECT_GT(refused, 20);
}

TEST(PlyLayouts, RowsReadAtOnceTellTheByteOfAFault) {
    Rows rows{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, std::nanf(""), 0}}, {{0, 1, 2}, {0, 1, 3}}};
    const std::string file = file_of(rows, std::endian::little, false);
    const std::size_t body = file.find("end_header\n") + 11;
    try {
        parse(file);
        FAIL() << "a NaN was taken";
    } catch (const Error& error) {
        // y stands first, behind a tag of two bytes; a row has 14.
        EXPECT_EQ(error.diagnostics().front().location.byte, body + 3 * 14 + 2);
    }
}

TEST(PlyLayouts, ACutFileIsToldHoweverItIsRead) {
    Rows rows{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
    for (int i = 0; i < 50; ++i) rows.faces.push_back({0, 1, 2});
    const std::string file = file_of(rows, std::endian::little, false);
    for (std::size_t cut = 1; cut < 200; ++cut)
        EXPECT_THROW(parse(file.substr(0, file.size() - cut)), Error) << cut << " bytes cut off";
}

} // namespace
} // namespace glint
