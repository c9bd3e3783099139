// What is written and read again is the same, bit for bit.

#include "ply_files.h"

#include "imaging/tone.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <unistd.h>

namespace glint::formats {
namespace {

using glm::uvec3;
using glm::vec2;
using glm::vec3;

constexpr PlyFormat all_formats[] = {PlyFormat::ascii, PlyFormat::binary_little_endian,
                                     PlyFormat::binary_big_endian};

/// A file of this test alone that goes when it ends.
class PlyWrite : public testing::Test {
  protected:
    void TearDown() override { std::filesystem::remove(path_); }

    std::string written(const Mesh& mesh, PlyFormat format) const {
        write_ply(path_, mesh, format);
        std::ifstream file(path_, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    std::string path_ = testing::TempDir() + "glint_ply_" + std::to_string(::getpid()) +
                        testing::UnitTest::GetInstance()->current_test_info()->name() + ".ply";
};

template <class Value>
bool same_bits(const std::vector<Value>& a, const std::vector<Value>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

void expect_same(const Mesh& a, const Mesh& b) {
    EXPECT_TRUE(same_bits(a.positions, b.positions));
    EXPECT_TRUE(same_bits(a.normals, b.normals));
    EXPECT_TRUE(same_bits(a.colors, b.colors));
    EXPECT_TRUE(same_bits(a.uvs, b.uvs));
    EXPECT_TRUE(same_bits(a.triangles, b.triangles));
}

/// Vertices of random bits, so far as they are allowed, and random triangles.
Mesh random_mesh(std::mt19937& random, bool everything) {
    const auto number = [&] {
        while (true) {
            const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
            if (std::fabs(value) <= 1e12f) return value;
        }
    };
    const auto vector = [&] {
        vec3 v;
        for (int k = 0; k < 3; ++k) v[k] = number();
        return v;
    };
    Mesh mesh;
    for (int i = 0; i < 500; ++i) {
        mesh.positions.push_back(vector());
        if (!everything) continue;
        mesh.normals.push_back(vector());
        mesh.colors.push_back(glm::abs(vector()));
        mesh.uvs.emplace_back(vector());
    }
    std::uniform_int_distribution<std::uint32_t> corner(0, 499);
    while (mesh.triangles.size() < 700) {
        uvec3 t;
        for (int k = 0; k < 3; ++k) t[k] = corner(random);
        if (t.x != t.y && t.y != t.z && t.z != t.x) mesh.triangles.push_back(t);
    }
    return mesh;
}

TEST_F(PlyWrite, GivesEveryBitBackInEveryFormat) {
    std::mt19937 random(3);
    for (const bool everything : {false, true}) {
        const Mesh mesh = random_mesh(random, everything);
        for (const PlyFormat format : all_formats) {
            write_ply(path_, mesh, format);
            expect_same(*load_mesh(path_).mesh, mesh);
        }
    }
}

TEST_F(PlyWrite, GivesTheExtremesOfFloatBack) {
    const float tiny = std::numeric_limits<float>::denorm_min(), small = std::numeric_limits<float>::min();
    Mesh mesh;
    mesh.positions = {
        {tiny, -tiny, -0.0f}, {small, std::nextafter(small, 0.0f), 1e12f}, {0.1f, 1.0f / 3, 16777217.0f}};
    mesh.triangles = {{0, 1, 2}};
    for (const PlyFormat format : all_formats) {
        write_ply(path_, mesh, format);
        expect_same(*load_mesh(path_).mesh, mesh);
    }
}

TEST_F(PlyWrite, WritesColoursAsBytesWhereBytesSayItAll) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    for (int i = 0; i < 3; ++i)
        mesh.colors.emplace_back(imaging::linear_from_srgb8(static_cast<std::uint8_t>(i)),
                                 imaging::linear_from_srgb8(100), 1.0f);
    for (const PlyFormat format : all_formats) {
        EXPECT_NE(written(mesh, format).find("property uchar red"), std::string::npos);
        expect_same(*load_mesh(path_).mesh, mesh);
    }
    mesh.colors[1].x = 0.123f;
    for (const PlyFormat format : all_formats) {
        EXPECT_NE(written(mesh, format).find("property float red"), std::string::npos);
        expect_same(*load_mesh(path_).mesh, mesh);
    }
}

TEST_F(PlyWrite, WritesPlainTextThatOthersRead) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0.5f, 0, 0}, {0, -1e-7f, 3}};
    mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    EXPECT_EQ(
        written(mesh, PlyFormat::ascii),
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n"
        "0 0 0 0 0 1\n0.5 0 0 0 0 1\n0 -1e-07 3 0 1 0\n3 0 1 2\n");
}

TEST_F(PlyWrite, WritesAPointCloudThatIsReadAsOne) {
    Mesh cloud;
    cloud.positions = {{1, 2, 3}, {4, 5, 6}};
    for (const PlyFormat format : all_formats) {
        write_ply(path_, cloud, format);
        const LoadedMesh loaded = load_mesh(path_);
        expect_same(*loaded.mesh, cloud);
        ASSERT_EQ(loaded.warnings.size(), 1u);
        EXPECT_NE(loaded.warnings[0].message.find("no faces"), std::string::npos);
    }
}

TEST_F(PlyWrite, FailsWithAPlaceThatCannotBeWritten) {
    const std::string nowhere = testing::TempDir() + "no-such-folder-of-glint/mesh.ply";
    Mesh mesh;
    mesh.positions = {{1, 2, 3}};
    try {
        write_ply(nowhere, mesh);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::output);
        EXPECT_EQ(error.diagnostics().at(0).location.file, nowhere);
    }
}

} // namespace
} // namespace glint::formats
