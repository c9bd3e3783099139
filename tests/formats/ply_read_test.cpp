// Every dialect of PLY that is read.

#include "ply_files.h"

#include "imaging/tone.h"

#include <glm/geometric.hpp>

#include <clocale>
#include <cmath>
#include <filesystem>
#include <limits>
#include <locale>

namespace glint::formats {
namespace {

using namespace ply_test;
using glm::uvec3;
using glm::vec2;
using glm::vec3;

void expect_triangle(const LoadedMesh& loaded) {
    EXPECT_EQ(loaded.mesh->positions, (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(loaded.mesh->triangles, (std::vector<uvec3>{{0, 1, 2}}));
    for (const Diagnostic& warning : loaded.warnings)
        EXPECT_TRUE(warning.message.starts_with("not drawn: ")) << to_string(warning);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

TEST(PlyRead, TakesAsciiAndBinaryOfBothByteOrders) {
    expect_triangle(parse(ascii("3", "1", corners + "3 0 1 2\n")));
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        const Bytes body =
            Bytes(order).vertex(0, 0, 0).vertex(1, 0, 0).vertex(0, 1, 0).u8(3).i32(0).i32(1).i32(2);
        expect_triangle(parse(header(binary_format(order), "3", "1") + std::string(body)));
    }
}

TEST(PlyRead, TakesLinesThatEndInLfCrlfOrCr) {
    const std::string lf = ascii("3", "1", corners + "3 0 1 2\n");
    expect_triangle(parse(replaced(lf, "\n", "\r\n")));
    expect_triangle(parse(replaced(lf, "\n", "\r")));
    expect_triangle(parse(lf.substr(0, lf.size() - 1)));
}

TEST(PlyRead, DoesNotTakeTheFirstByteOfABinaryBodyForALineEnd) {
    // The body begins with 0x0a: with CR alone as line ends it must not be swallowed as half of a CRLF.
    const std::string body =
        Bytes().i32(0x0a).f32(0).f32(0).vertex(1, 0, 0).vertex(0, 1, 0).u8(3).i32(0).i32(1).i32(2);
    for (const char* end : {"\n", "\r\n", "\r"}) {
        const std::string head = replaced(header(binary_format(std::endian::little), "3", "1"), "\n", end);
        const LoadedMesh loaded = parse(head + body);
        EXPECT_EQ(std::bit_cast<std::uint32_t>(loaded.mesh->positions[0].x), 0x0au);
        EXPECT_EQ(loaded.mesh->triangles, (std::vector<uvec3>{{0, 1, 2}}));
        EXPECT_TRUE(loaded.warnings.empty());
    }
}

TEST(PlyRead, PassesOverBlankLinesTabsCommentsAndAByteOrderMark) {
    expect_triangle(
        parse("\xef\xbb\xbf"
              "ply \n\ncomment first\n\t format\tascii   1.0 \nobj_info a b c d e f g h\n"
              "comment\nelement vertex 3\nproperty float x\ncomment between\nproperty float y\n\n"
              "property float z\nelement face 1\nproperty list uchar int vertex_index\ncomment end_header\n"
              "end_header\n\n\t0\t0 0 \n\ncomment in the body\n1 0 0\nobj_info too\n0 1 0\n  \n3 0 1 2\n\n"));
}

TEST(PlyRead, TakesRowsThatGoOnOverSeveralLines) {
    expect_triangle(parse(ascii("3", "1", "0 0\n0\n1 0 0\n0 1 0\n3 0\n1\n2")));
}

TEST(PlyRead, TakesEveryNameOfEveryType) {
    const std::pair<const char*, const char*> names[] = {
        {"char", "int8"}, {"uchar", "uint8"}, {"short", "int16"},   {"ushort", "uint16"},
        {"int", "int32"}, {"uint", "uint32"}, {"float", "float32"}, {"double", "float64"}};
    for (const auto& [old_name, new_name] : names) {
        for (const std::string& type : {std::string(old_name), std::string(new_name)}) {
            const std::string head = "element vertex 3\nproperty " + type + " x\nproperty " + type +
                                     " y\nproperty " + type + " z\nelement face 1\nproperty list ";
            expect_triangle(parse("ply\nformat ascii 1.0\n" + head + "uchar int vertex_index\nend_header\n" +
                                  corners + "3 0 1 2\n"));
            if (type.starts_with("float") || type == "double") continue;
            expect_triangle(parse("ply\nformat ascii 1.0\n" + head + type + " " + type +
                                  " vertex_index\nend_header\n" + corners + "3 0 1 2\n"));
        }
    }
}

TEST(PlyRead, TakesEveryIntegerTypeForCountsAndIndicesOfBinaryFiles) {
    const std::pair<const char*, int> types[] = {{"char", 1},   {"uchar", 1}, {"short", 2},
                                                 {"ushort", 2}, {"int", 4},   {"uint", 4}};
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        for (const auto& [count_type, count_size] : types) {
            for (const auto& [index_type, index_size] : types) {
                Bytes body = Bytes(order).vertex(0, 0, 0).vertex(1, 0, 0).vertex(0, 1, 0);
                const auto integer = [&](int size, int value) {
                    size == 1 ? body.u8(value) : size == 2 ? body.i16(value) : body.i32(value);
                };
                integer(count_size, 3);
                for (int i = 0; i < 3; ++i) integer(index_size, i);
                const std::string head = header(binary_format(order), "3", "1");
                expect_triangle(
                    parse(replaced(head, "uchar int", std::string(count_type) + " " + index_type) +
                          std::string(body)));
            }
        }
    }
}

TEST(PlyRead, TakesNumbersOfEveryTypeFromBinaryFiles) {
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        const std::string head =
            "ply\n" + binary_format(order) +
            "element vertex 2\nproperty char x\nproperty double y\nproperty short z\nproperty "
            "ushort nx\nproperty int ny\nproperty uint nz\nend_header\n";
        const Bytes body = Bytes(order)
                               .u8(-2)
                               .f64(0.1)
                               .i16(-300)
                               .i16(60000)
                               .i32(-70000)
                               .i32(4000000000)
                               .u8(127)
                               .f64(-1e9)
                               .i16(5)
                               .i16(0)
                               .i32(1)
                               .i32(2);
        const LoadedMesh loaded = parse(head + std::string(body));
        EXPECT_EQ(loaded.mesh->positions, (std::vector<vec3>{{-2, 0.1f, -300}, {127, -1e9f, 5}}));
        EXPECT_EQ(loaded.mesh->normals, (std::vector<vec3>{{60000, -70000, 4e9f}, {0, 1, 2}}));
    }
}

TEST(PlyRead, RoundsTextToTheNearestFloat) {
    const LoadedMesh loaded =
        parse(ascii("3", "0", "0.1 +0.5 -0\n16777217.0000001 1e-50 1e-45\n1E3 .5 5.\n"));
    const std::vector<vec3>& p = loaded.mesh->positions;
    EXPECT_EQ(p[0], vec3(0.1f, 0.5f, 0));
    EXPECT_TRUE(std::signbit(p[0].z));
    EXPECT_EQ(p[1], vec3(16777218.0f, 0, std::numeric_limits<float>::denorm_min()));
    EXPECT_EQ(p[2], vec3(1000, 0.5f, 5));
}

/// Numbers with a decimal comma, and a point between thousands.
class CommaNumbers : public std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(PlyRead, ReadsNumbersAlikeInEveryLocale) {
    // The C library knows a comma only where such a locale is installed; the C++ library can be given one.
    const std::locale before = std::locale::global(std::locale(std::locale(), new CommaNumbers));
    const std::string c_before = std::setlocale(LC_ALL, nullptr);
    std::setlocale(LC_ALL, "de_DE.UTF-8");
    const LoadedMesh loaded = parse(ascii("1", "0", "0.5 1.25 -1234.75\n"));
    std::setlocale(LC_ALL, c_before.c_str());
    std::locale::global(before);
    EXPECT_EQ(loaded.mesh->origin + Vec3(loaded.mesh->positions[0]), Vec3(0.5, 1.25, -1234.75));
}

TEST(PlyRead, PassesOverUnknownElementsAndPropertiesWithListsInThem) {
    const std::string head =
        "element camera 2\nproperty float focus\nproperty list ushort double matrix\n"
        "element empty 4000000000\n"
        "element vertex 3\nproperty list uchar uchar tags\nproperty double x\nproperty uchar "
        "flags\nproperty float y\nproperty float z\nproperty list int short more\n"
        "element edge 1\nproperty int a\nproperty int b\n"
        "element face 1\nproperty uchar quality\nproperty list uchar float texcoord\nproperty "
        "list int uint vertex_indices\nproperty int tail\nend_header\n";
    expect_triangle(parse("ply\nformat ascii 1.0\n" + head +
                          "1.5 2 0.5 0.25\n2 0\n1 9 0 7 0 0 0\n0 1 7 0 0 2 5 6\n2 1 2 0 7 1 0 1 3\n5 6\n"
                          "1 2 0.5 0.5 3 0 1 2 -1\n"));
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        Bytes body(order);
        body.f32(1.5f).i16(2).f64(0.5).f64(0.25).f32(2).i16(0);
        body.u8(1).u8(9).f64(0).u8(7).f32(0).f32(0).i32(0);
        body.u8(0).f64(1).u8(7).f32(0).f32(0).i32(2).i16(5).i16(6);
        body.u8(2).u8(1).u8(2).f64(0).u8(7).f32(1).f32(0).i32(1).i16(3);
        body.i32(5).i32(6);
        body.u8(1).u8(2).f32(0.5f).f32(0.5f).i32(3).i32(0).i32(1).i32(2).i32(-1);
        expect_triangle(parse("ply\n" + binary_format(order) + head + std::string(body)));
    }
}

TEST(PlyRead, TakesFacesBeforeVerticesAndSeveralElementsOfFaces) {
    const std::string list = "property list uchar int vertex_indices\n";
    const LoadedMesh loaded =
        parse("ply\nformat ascii 1.0\nelement face 1\n" + list +
              "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n" +
              list + "end_header\n4 0 1 2 3\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 2 1 0\n");
    EXPECT_EQ(loaded.mesh->triangles, (std::vector<uvec3>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {2, 1, 0}}));
}

TEST(PlyRead, SplitsPolygonsWhereTheyStandAmongTheFaces) {
    const LoadedMesh loaded = parse(ascii("6", "4",
                                          "0 0 0\n3 0 0\n3 1 0\n1 1 0\n1 3 0\n0 3 0\n"
                                          "3 0 1 2\n4 0 1 2 3\n3 3 4 5\n6 1 2 3 4 5 0\n"));
    ASSERT_EQ(loaded.mesh->triangles.size(), 8u);
    EXPECT_EQ(loaded.mesh->triangles[0], uvec3(0, 1, 2));
    EXPECT_EQ(loaded.mesh->triangles[1], uvec3(0, 1, 2));
    EXPECT_EQ(loaded.mesh->triangles[2], uvec3(0, 2, 3));
    EXPECT_EQ(loaded.mesh->triangles[3], uvec3(3, 4, 5));

    // The concave L has an area of 5: a fan from its second corner would cover more.
    double area = 0;
    for (std::size_t i = 4; i < 8; ++i) {
        const uvec3& t = loaded.mesh->triangles[i];
        const auto& p = loaded.mesh->positions;
        area += static_cast<double>(glm::length(glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]))) / 2;
    }
    EXPECT_DOUBLE_EQ(area, 5.0);
}

TEST(PlyRead, UnrollsTristripsTurningEverySecondTriangle) {
    const std::string head = "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
                             "element tristrips 2\nproperty list int int vertex_indices\nend_header\n";
    const std::vector<uvec3> expected{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {1, 2, 3}, {4, 3, 2}, {2, 3, 1}};
    const std::string points = "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 1\n";

    // 0 1 2 3 4 is one strip; 1 2 3 stands between restarts; 4 3 | 4 3 2 starts anew; 2 3 3 1 turns on a
    // repeated corner.
    const LoadedMesh text = parse("ply\nformat ascii 1.0\n" + head + points +
                                  "14 0 1 2 3 4 -1 1 2 3 -1 4 3 -1 -1\n8 4 3 2 -1 2 3 3 1\n");
    EXPECT_TRUE(text.warnings.empty());
    std::vector<uvec3> triangles = text.mesh->triangles;
    ASSERT_EQ(triangles.size(), 5u);
    EXPECT_EQ(triangles, (std::vector<uvec3>(expected.begin(), expected.begin() + 5)));

    Bytes body;
    body.vertex(0, 0, 0).vertex(0, 1, 0).vertex(1, 0, 0).vertex(1, 1, 0).vertex(2, 0, 1);
    body.i32(9);
    for (const int i : {0, 1, 2, 3, 4, -1, 1, 2, 3}) body.i32(i);
    body.i32(3).i32(4).i32(3).i32(2);
    const LoadedMesh binary = parse("ply\nformat binary_little_endian 1.0\n" + head + std::string(body));
    EXPECT_EQ(binary.mesh->triangles, triangles);
}

std::string with_properties(const std::string& properties, const std::string& row) {
    return "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n" +
           properties + "end_header\n0 0 0 " + row + "\n";
}

TEST(PlyRead, TakesNormalsAndTextureCoordinatesInTheirSpellings) {
    for (const char* p : {"n", "normal_"}) {
        const std::string n = std::string("property float ") + p;
        EXPECT_EQ(parse(with_properties(n + "x\n" + n + "y\n" + n + "z\n", "0 0.6 0.8")).mesh->normals,
                  (std::vector<vec3>{{0, 0.6f, 0.8f}}));
    }
    for (const auto& [u, v] :
         {std::pair("s", "t"), {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}) {
        const std::string properties = std::string("property float ") + u + "\nproperty float " + v + "\n";
        EXPECT_EQ(parse(with_properties(properties, "0.25 0.75")).mesh->uvs,
                  (std::vector<vec2>{{0.25f, 0.75f}}));
    }
}

TEST(PlyRead, DecodesColoursOfWholeNumbersFromSrgbAndKeepsFloatsLinear) {
    const auto color = [](const std::string& type, const std::string& row, const char* prefix = "diffuse_") {
        const std::string p = "property " + type + " " + prefix;
        const LoadedMesh loaded = parse(
            with_properties(p + "red\n" + p + "green\n" + p + "blue\nproperty uchar alpha\n", row + " 128"));
        return loaded.mesh->colors.at(0);
    };
    const vec3 codes(imaging::linear_from_srgb8(0), imaging::linear_from_srgb8(128),
                     imaging::linear_from_srgb8(255));
    EXPECT_EQ(codes.z, 1.0f);
    EXPECT_EQ(color("uchar", "0 128 255"), codes);
    EXPECT_EQ(color("uchar", "0 128 255", ""), codes);
    EXPECT_EQ(color("int", "-5 128 300"), codes);
    EXPECT_EQ(color("ushort", "0 32896 65535"), codes);
    EXPECT_EQ(color("float", "0 0.5 1"), vec3(0, 0.5f, 1));
    EXPECT_EQ(color("double", "-1 nan 0.25"), vec3(0, 0, 0.25f));
    EXPECT_EQ(parse(with_properties("property uchar r\nproperty uchar g\nproperty uchar b\n", "0 128 255"))
                  .mesh->colors,
              (std::vector<vec3>{codes}));
}

TEST(PlyRead, LeavesOutGroupsThatAreNotWhole) {
    const LoadedMesh loaded = parse(with_properties(
        "property float nx\nproperty float ny\nproperty uchar red\nproperty uchar blue\nproperty float s\n",
        "1 2 3 4 5"));
    EXPECT_TRUE(loaded.mesh->normals.empty());
    EXPECT_TRUE(loaded.mesh->colors.empty());
    EXPECT_TRUE(loaded.mesh->uvs.empty());
}

TEST(PlyRead, MakesNormalsAndTextureCoordinatesThatAreNotFiniteZero) {
    const LoadedMesh loaded = parse(with_properties(
        "property float nx\nproperty float ny\nproperty float nz\nproperty float u\nproperty float v\n",
        "nan inf 1 -inf 2"));
    EXPECT_EQ(loaded.mesh->normals, (std::vector<vec3>{{0, 0, 1}}));
    EXPECT_EQ(loaded.mesh->uvs, (std::vector<vec2>{{0, 2}}));
}

TEST(PlyWarn, OfDroppedDegenerateFaces) {
    const LoadedMesh loaded =
        parse(ascii("5", "6", corners + "2 0 0\n0 1 0\n3 0 1 2\n3 0 0 1\n3 0 1 3\n3 1 2 4\n2 0 1\n0\n"));
    EXPECT_EQ(loaded.mesh->triangles, (std::vector<uvec3>{{0, 1, 2}}));
    expect_warned(loaded, "dropped 5 degenerate faces", "fewer than three different corners");
    expect_warned(parse(ascii("3", "2", corners + "3 0 1 2\n3 2 2 2\n")), "dropped 1 degenerate face",
                  "no area");
}

TEST(PlyWarn, OfAnUnusedVertexThatIsNotFiniteAndDropIt) {
    const LoadedMesh loaded = parse(ascii("5", "1", "0 0 0\nnan 0 0\n1 0 0\n0 1e13 0\n0 1 0\n3 0 2 4\n"));
    EXPECT_EQ(loaded.mesh->positions, (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(loaded.mesh->triangles, (std::vector<uvec3>{{0, 1, 2}}));
    expect_warned(loaded, "dropped 2 vertices that are not finite", "no face uses them");
}

TEST(PlyWarn, OfAFileWithoutFacesAndDropPointsThatAreNotFinite) {
    const std::string points =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
        "float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
    const LoadedMesh cloud = parse(points + "0 0 0 1 1 1\n1 2 3 2 2 2\n4 5 6 255 255 255\n");
    expect_warned(cloud, "no faces", "point_radius");
    EXPECT_EQ(cloud.mesh->positions.size(), 3u);
    const LoadedMesh holes = parse(points + "nan nan nan 1 1 1\n1 2 3 255 255 255\n4 inf 6 0 0 0\n");
    EXPECT_EQ(holes.warnings.size(), 2u);
    ASSERT_EQ(holes.mesh->positions.size(), 1u);
    EXPECT_EQ(holes.mesh->origin + Vec3(holes.mesh->positions[0]), Vec3(1, 2, 3));
    EXPECT_EQ(holes.mesh->colors, (std::vector<vec3>{{1, 1, 1}}));
    expect_warned(
        parse("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
              "z\nelement faces 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n3 0 0 0\n"),
        "no faces", "did you mean 'face' by 'faces'?");
}

TEST(PlyWarn, OfAFileWhoseFacesAreAllDegenerate) {
    const LoadedMesh loaded = parse(ascii("3", "1", corners + "3 0 1 1\n"));
    ASSERT_EQ(loaded.warnings.size(), 2u);
    EXPECT_NE(loaded.warnings[1].message.find("no face is left"), std::string::npos);
}

TEST(PlyWarn, OfWhatIsNotDrawn) {
    const auto read = [](const std::string& vertex, const std::string& face, const std::string& rest) {
        return parse("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
                     "float z\n" +
                     vertex + "element face 1\nproperty list uchar int vertex_indices\n" + face + rest);
    };
    const std::string xyz = "0 0 0\n1 0 0\n0 1 0\n";
    const std::string xyz1 = "0 0 0 1\n1 0 0 1\n0 1 0 1\n";
    expect_warned(read("", "property list uchar float texcoord\n", "end_header\n" + xyz + "3 0 1 2 2 0 0\n"),
                  "not drawn: texture coordinate 'texcoord' of face", "textures are not");
    expect_warned(read("", "property uchar red\n", "end_header\n" + xyz + "3 0 1 2 255\n"),
                  "not drawn: colour 'red' of face", "");
    expect_warned(read("property float quality\n", "", "end_header\n" + xyz1 + "3 0 1 2\n"),
                  "not drawn: 'quality' of vertex", "");
    expect_warned(read("property float s\n", "", "end_header\n" + xyz1 + "3 0 1 2\n"),
                  "not drawn: texture coordinate 's' of vertex", "");
    expect_warned(read("", "", "element edge 1\nproperty int vertex1\nend_header\n" + xyz + "3 0 1 2\n0\n"),
                  "not drawn: element 'edge'", "");
    EXPECT_TRUE(read("", "", "element edge 0\nproperty int vertex1\nend_header\n" + xyz + "3 0 1 2\n")
                    .warnings.empty());
}

TEST(PlyWarn, OfNormalsThatHaveNoDirection) {
    const std::string head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                             "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
                             "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    expect_warned(parse(head + "0 0 0 0 0 0\n1 0 0 nan nan nan\n0 1 0 0 0 1\n3 0 1 2\n"),
                  "2 vertices have a normal that is 0 or not finite", "flat");
    EXPECT_TRUE(parse(head + "0 0 0 0 0 1\n1 0 0 0 1 1\n0 1 0 0 0 1\n3 0 1 2\n").warnings.empty());
}

TEST(PlyWarn, OfTrailingBytes) {
    expect_warned(parse(ascii("3", "1", corners + "3 0 1 2\n3 0 2 1\n")), "8 bytes follow the last element",
                  "too few");
    const Bytes body =
        Bytes().vertex(0, 0, 0).vertex(1, 0, 0).vertex(0, 1, 0).u8(3).i32(0).i32(1).i32(2).u8(7);
    expect_warned(parse(header(binary_format(std::endian::little), "3", "1") + std::string(body)),
                  "1 byte follows the last element", "too few");
}

TEST(PlyWarn, OfFloatColoursThatAreBytes) {
    const LoadedMesh loaded = parse(with_properties("property float red\nproperty float green\nproperty "
                                                    "float blue\nelement face 1\nproperty list uchar int "
                                                    "vertex_index\n",
                                                    "0 17.5 255\n3 0 0 0"));
    ASSERT_EQ(loaded.warnings.size(), 3u);
    EXPECT_NE(loaded.warnings[2].message.find("go up to 255"), std::string::npos)
        << loaded.warnings[2].message;
}

/// Loads a model of the shared folder, or skips.
class PlyModel : public testing::TestWithParam<std::tuple<const char*, std::size_t, std::size_t>> {};

TEST_P(PlyModel, HasItsVerticesAndTriangles) {
    const auto& [file, vertices, triangles] = GetParam();
    const std::string path = std::string(GLINT_SOURCE_DIR) + "/../shared/models/" + file;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    const LoadedMesh loaded = load_mesh(path);
    EXPECT_EQ(loaded.mesh->positions.size(), vertices);
    std::size_t dropped = 0;
    for (const Diagnostic& d : loaded.warnings) {
        if (d.message.starts_with("not drawn: ")) continue;
        EXPECT_TRUE(d.message.starts_with("dropped ")) << to_string(d);
        dropped += std::stoul(d.message.substr(8));
    }
    EXPECT_EQ(loaded.mesh->triangles.size() + dropped, triangles);
}

INSTANTIATE_TEST_SUITE_P(
    Shared, PlyModel,
    testing::Values(std::tuple("bun_zipper_res4.ply", 453, 948), std::tuple("cat-2.ply", 4538, 8971),
                    std::tuple("bunny.ply", 35947, 69451), std::tuple("igea.ply", 134345, 268686),
                    std::tuple("oacmpctf3.ply", 95017, 168285), std::tuple("dragon.ply", 435545, 871306)),
    [](const auto& param) { return "File" + std::to_string(param.index); });

// ── Cancelling ─────────────────────────────────────────────────────────────────────────────────────────────

TEST(PlyRead, SaysWhatRoundingLosesFarFromTheOrigin) {
    const auto warnings = [](const std::string& offset) {
        const std::string row = offset + ".25 0 0\n" + offset + ".75 0 0\n" + offset + ".25 1 0\n3 0 1 2\n";
        return parse(replaced(ascii("3", "1", row), "property float x", "property double x")).warnings;
    };
    EXPECT_TRUE(warnings("12").empty());
    EXPECT_TRUE(warnings("1024").empty());
    EXPECT_TRUE(warnings("5412349").empty()) << "has an origin of its own";

    Bytes body;
    body.vertex(5412349, 0, 0).vertex(5412350, 0, 0).vertex(5412349, 1, 0).u8(3).i32(0).i32(1).i32(2);
    const LoadedMesh floats = parse(header(binary_format(std::endian::little), "3", "1") + std::string(body));
    ASSERT_EQ(floats.warnings.size(), 1u);
    EXPECT_NE(floats.warnings[0].message.find(
                  "single precision moves its vertices by up to 0.32, about 323 pixels"),
              std::string::npos)
        << floats.warnings[0].message;
}

TEST(PlyRead, IgnoresVerticesWithoutFacesWhenItChoosesAnOrigin) {
    const LoadedMesh loaded =
        parse(replaced(ascii("4", "1", "0 0 0\n5412349.25 8 0\n5412349.75 8 0\n5412349.25 9 0\n3 1 2 3\n"),
                       "property float x", "property double x"));
    EXPECT_TRUE(loaded.warnings.empty());
    EXPECT_EQ(loaded.mesh->origin.x + double(loaded.mesh->positions[2].x), 5412349.75);
}

TEST(PlyRead, MayBeCancelledBetweenThePassesAfterItsBody) {
    const std::string file = ascii("4", "2", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 3 2\n");
    LoadOptions options;
    int read = 0;
    options.progress = [&](const LoadProgress& progress) { read += progress.fraction == 1 ? 1 : 0; };
    const auto bytes = std::as_bytes(std::span(file));
    parse_ply(bytes, "four.ply", options);
    // Bad vertices, polygons, faces without area, vertices without use.
    ASSERT_GE(read, 4);
    for (int last = 1; last <= read; ++last) {
        CancelFlag cancel{false};
        int now = 0;
        options.cancel = &cancel;
        options.progress = [&](const LoadProgress& progress) {
            if (progress.fraction == 1 && ++now == last) cancel = true;
        };
        if (last == read) {
            // Nothing is left to be cancelled.
            EXPECT_NO_THROW(parse_ply(bytes, "four.ply", options));
            continue;
        }
        try {
            parse_ply(bytes, "four.ply", options);
            ADD_FAILURE() << last;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::cancelled);
        }
        EXPECT_EQ(now, last);
    }
}

} // namespace
} // namespace glint::formats
