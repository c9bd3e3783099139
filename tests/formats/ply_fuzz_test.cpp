// Damaged files: whatever the bytes, they give a sound mesh or an error, and quickly.

#include "ply_files.h"

#include <cmath>
#include <random>

namespace glint::formats {
namespace {

using namespace ply_test;

/// Small files that together use every part of the reader.
std::vector<std::string> seeds() {
    const std::string vertices =
        "element vertex 6\nproperty double x\nproperty float y\nproperty short z\n"
        "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\n"
        "property uchar green\nproperty uchar blue\nproperty list uchar int more\n";
    const std::string faces = "element face 3\nproperty list uchar int vertex_indices\nproperty float q\n"
                              "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
    std::vector<std::string> files;
    std::string text = "ply\ncomment a\nformat ascii 1.0\n" + vertices + faces;
    for (int i = 0; i < 6; ++i)
        text += std::to_string(i % 3) + ".5 " + std::to_string(i / 3) + " " + std::to_string(i * i % 4) +
                " 0 0 1 1 2 3 1 9\n";
    text += "3 0 1 2 0.5\n5 0 1 2 5 3 1\n4 0 4 1 3 nan\n8 0 1 2 3 -1 3 4 5\n";
    files.push_back(text);
    std::string carriage = text;
    for (char& c : carriage) c = c == '\n' ? '\r' : c;
    files.push_back(carriage);
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        Bytes body(order);
        for (int i = 0; i < 6; ++i) {
            body.f64(i % 3 + 0.5).f32(static_cast<float>(i / 3)).i16(i * i % 4).vertex(0, 0, 1);
            body.u8(1).u8(2).u8(3).u8(1).i32(9);
        }
        body.u8(3).i32(0).i32(1).i32(2).f32(0.5f).u8(5).i32(0).i32(1).i32(2).i32(5).i32(3).f32(1);
        body.u8(4).i32(0).i32(4).i32(1).i32(3).f32(2).i32(8);
        for (const int i : {0, 1, 2, 3, -1, 3, 4, 5}) body.i32(i);
        files.push_back("ply\n" + binary_format(order) + vertices + faces + std::string(body));
    }
    return files;
}

/// Flips, overwrites, inserts, removes, repeats or cuts, a few times.
std::string damaged(std::string file, std::mt19937& random, const std::vector<std::string>& others) {
    const auto below = [&](std::size_t n) {
        return static_cast<std::size_t>(random()) % std::max<std::size_t>(n, 1);
    };
    static const char* const words[] = {
        "-1",   "4294967295",           "1e400", "nan",  " ",      "\n",       "\r",
        "list", "18446744073709551615", "0",     "face", "vertex", "property", "\xff\xff\xff\xff",
        "uint"};
    const std::size_t rounds = 1 + below(3);
    for (std::size_t round = 0; round < rounds && !file.empty(); ++round) {
        // Damage to a header is mostly found there: more of it goes to the bodies.
        const std::size_t found = file.find("end_header");
        const std::size_t from = found == std::string::npos || below(5) == 0 ? 0 : found;
        const std::size_t at = from + below(file.size() - from);
        switch (below(7)) {
        case 0:
            file[at] = static_cast<char>(static_cast<unsigned char>(file[at]) ^ (1u << below(8)));
            break;
        case 1:
            file[at] = static_cast<char>(below(256));
            break;
        case 2:
            file.resize(at);
            break;
        case 3:
            file.erase(at, 1 + below(8));
            break;
        case 4:
            file.insert(at, words[below(std::size(words))]);
            break;
        case 5:
            file.insert(at, file.substr(below(file.size()), below(64)));
            break;
        default: {
            const std::string& other = others[below(others.size())];
            file = file.substr(0, at) + other.substr(below(other.size()));
        }
        }
    }
    return file;
}

/// What every mesh that is accepted holds.
void expect_sound(const Mesh& mesh) {
    const std::size_t n = mesh.positions.size();
    ASSERT_GT(n, 0u);
    for (const auto* values : {&mesh.normals, &mesh.colors})
        ASSERT_TRUE(values->empty() || values->size() == n);
    ASSERT_TRUE(mesh.uvs.empty() || mesh.uvs.size() == n);
    for (const glm::vec3& p : mesh.positions)
        for (int k = 0; k < 3; ++k) ASSERT_LE(std::fabs(p[k]), 1e12f);
    for (const glm::vec3& c : mesh.colors)
        for (int k = 0; k < 3; ++k) ASSERT_GE(c[k], 0.0f);
    for (const glm::uvec3& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) ASSERT_LT(t[k], n);
}

TEST(PlyFuzz, DamagedFilesGiveASoundMeshOrAnError) {
    const std::vector<std::string> files = seeds();
    for (const std::string& file : files) expect_sound(*parse(file).mesh);

    std::mt19937 random(20'240'601);
    int accepted = 0, refused = 0;
    for (int round = 0; round < 40'000 && !HasFatalFailure(); ++round) {
        const std::string file =
            damaged(files[static_cast<std::size_t>(round) % files.size()], random, files);
        try {
            const LoadedMesh loaded = parse(file);
            expect_sound(*loaded.mesh);
            ++accepted;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::input);
            EXPECT_FALSE(error.diagnostics().front().message.empty());
            ++refused;
        }
    }

    // Damage must reach beyond the header often enough to try the bodies, and be found often enough to try
    // errors.
    EXPECT_GT(accepted, 2'000);
    EXPECT_GT(refused, 20'000);
}

TEST(PlyFuzz, EveryCutOfAFileGivesASoundMeshOrAnError) {
    for (const std::string& file : seeds())
        for (std::size_t size = 0; size < file.size(); ++size) {
            try {
                expect_sound(*parse(file.substr(0, size)).mesh);
            } catch (const Error& error) {
                EXPECT_EQ(error.kind(), ErrorKind::input);
            }
        }
}

} // namespace
} // namespace glint::formats
