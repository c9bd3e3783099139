// Files are read part by part where they are as most are. Whatever the bytes, that gives what reading them
// from memory gives, the error's text included.

#include "formats/ply/fixed_rows.h"
#include "ply_files.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace glint::formats {
namespace {

using namespace ply_test;

/// A file of its own, gone at the end.
class TemporaryFile {
  public:
    TemporaryFile() : path_(testing::TempDir() + "glint-plain-" + std::to_string(::getpid()) + ".ply") {}
    ~TemporaryFile() { std::filesystem::remove(path_); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    void write(const std::string& bytes) const { std::ofstream(path_, std::ios::binary) << bytes; }
    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

/// Vertices with all that they may have, and faces with a number before and after their corners.
std::string rich_file(int side) {
    const int count = side * side;
    Bytes body;
    for (int i = 0; i < count; ++i) {
        const auto x = static_cast<float>(i % side);
        const auto y = static_cast<float>(i / side);
        body.u8(7).vertex(x, y, std::sin(x + y)).vertex(0, 0, 1).u8(i % 256).u8(17).u8(255).u8(3);
        body.f32(x).f32(y).i16(5);
    }
    int faces = 0;
    for (int y = 0; y + 1 < side; ++y)
        for (int x = 0; x + 1 < side; ++x, faces += 2) {
            const int a = y * side + x;
            body.i16(1).u8(3).i32(a).i32(a + 1).i32(a + side).u8(9);
            body.i16(2).u8(3).i32(a + 1).i32(a + side + 1).i32(a + side).u8(9);
        }
    return "ply\n" + binary_format(std::endian::little) + "element vertex " + std::to_string(count) +
           "\nproperty uchar flag\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n"
           "property float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\nproperty uchar "
           "blue\n"
           "property uchar alpha\nproperty float u\nproperty float v\nproperty short more\nelement face " +
           std::to_string(faces) +
           "\nproperty short group\nproperty list uchar int vertex_indices\nproperty uchar "
           "flag\nend_header\n" +
           std::string(body);
}

/// What reading gives, or its error.
struct Outcome {
    LoadedMesh loaded;
    std::string error;
};

template <class Read>
Outcome outcome_of(Read read) {
    try {
        return {read(), {}};
    } catch (const Error& error) {
        return {{}, error.what()};
    }
}

/// By the bytes, so that NaN equals itself.
template <class Value>
bool same_bytes(const std::vector<Value>& a, const std::vector<Value>& b) {
    return std::ranges::equal(std::as_bytes(std::span(a)), std::as_bytes(std::span(b)));
}

/// True where the file was accepted.
bool expect_same(const TemporaryFile& file, const std::string& bytes) {
    file.write(bytes);
    const Outcome whole = outcome_of([&] { return parse_ply(std::as_bytes(std::span(bytes)), file.path()); });
    const Outcome parts = outcome_of([&] { return load_mesh(file.path()); });
    EXPECT_EQ(parts.error, whole.error);
    if (!whole.loaded.mesh || !parts.loaded.mesh) return false;
    const Mesh& a = *whole.loaded.mesh;
    const Mesh& b = *parts.loaded.mesh;
    EXPECT_TRUE(same_bytes(a.positions, b.positions));
    EXPECT_TRUE(same_bytes(a.normals, b.normals));
    EXPECT_TRUE(same_bytes(a.colors, b.colors));
    EXPECT_TRUE(same_bytes(a.uvs, b.uvs));
    EXPECT_TRUE(same_bytes(a.triangles, b.triangles));
    EXPECT_EQ(parts.loaded.warnings.size(), whole.loaded.warnings.size());
    return true;
}

TEST(PlyPlain, UsualFilesNeedNoOtherReader) {
    const std::string file = rich_file(5);
    const auto bytes = std::as_bytes(std::span(file));
    const ply::Source source(bytes, "rich.ply");
    const ply::Header header = ply::parse_header(source);
    auto body = ply::FixedRowReader::begin(header, ply::interpret_header(source, header), bytes.size());
    ASSERT_TRUE(body);
    EXPECT_EQ(body->take(bytes.subspan(header.body)), bytes.size() - header.body);
    EXPECT_TRUE(body->complete());
    const Mesh mesh = body->finish().mesh;
    EXPECT_EQ(mesh.positions.size(), 25u);
    EXPECT_EQ(mesh.triangles.size(), 32u);
}

TEST(PlyPlain, FilesOfManyPartsAreReadAsFromMemory) {
    const TemporaryFile file;
    for (const int side : {2, 3, 150, 201}) EXPECT_TRUE(expect_same(file, rich_file(side))) << side;
}

TEST(PlyPlain, CutFilesAreRefusedAsFromMemory) {
    const TemporaryFile file;
    const std::string whole = rich_file(4);
    for (std::size_t size = 0; size < whole.size(); size += 3)
        EXPECT_FALSE(expect_same(file, whole.substr(0, size))) << size;
    EXPECT_TRUE(expect_same(file, whole + "more"));
}

TEST(PlyPlain, DamageInAnyPartIsFoundAsFromMemory) {
    const TemporaryFile file;
    std::mt19937 random(5);
    std::size_t accepted = 0;
    for (const int side : {4, 120}) {
        const std::string whole = rich_file(side);
        for (int round = 0; round < (side < 100 ? 600 : 30); ++round) {
            std::string bytes = whole;
            const std::size_t flips = 1 + random() % 3;
            for (std::size_t k = 0; k < flips; ++k)
                bytes[random() % bytes.size()] = static_cast<char>(random() & 255u);
            accepted += expect_same(file, bytes) ? 1 : 0;
        }
    }
    EXPECT_GT(accepted, 100u);
}

TEST(PlyPlain, APipeIsReadOnce) {
    const TemporaryFile place;
    ASSERT_EQ(::mkfifo(place.path().c_str(), 0600), 0);
    const std::string bytes = rich_file(40);
    std::thread writer([&] { place.write(bytes); });
    const LoadedMesh loaded = load_mesh(place.path());
    writer.join();
    EXPECT_EQ(loaded.mesh->positions.size(), 1600u);
}

TEST(PlyPlain, VerticesBeyondReachAreSeen) {
    const TemporaryFile file;
    for (const float x : {1e12f, 1.1e12f, std::numeric_limits<float>::infinity(), std::nanf("")}) {
        const std::string head = header(binary_format(std::endian::little), "4", "1");
        Bytes used, unused;
        used.vertex(0, 0, 0).vertex(x, 0, 0).vertex(0, 1, 0).vertex(0, 0, 1).u8(3).i32(0).i32(1).i32(2);
        unused.vertex(0, 0, 0).vertex(1, 0, 0).vertex(0, 1, 0).vertex(0, 0, x).u8(3).i32(0).i32(1).i32(2);
        EXPECT_EQ(expect_same(file, head + std::string(used)), x < 1.05e12f);
        EXPECT_TRUE(expect_same(file, head + std::string(unused)));
    }
}

} // namespace
} // namespace glint::formats
