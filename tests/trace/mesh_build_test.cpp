// Trees over triangles: complete, conservative, compact, and independent of the number of threads.

#include "trace/mesh/scalar.h"

#include "bvh/tree.h"
#include "geometry/triangle.h"
#include "math/offset.shared.h"
#include "math/random.shared.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

namespace glint {

using trace::build_mesh_tree;
using trace::closest_scalar;
using trace::leaf_bit;
using trace::LeafCode;
using trace::MeshTree;
using trace::TriangleRecord;
using trace::wide_children;
using trace::WideNode;
namespace {

constexpr BuildQuality qualities[] = {BuildQuality::fast, BuildQuality::high};

float draw(uint key, uint index) { return unit_float(hash_with(key, index)); }

vec3 draw_point(uint key, uint index) {
    return vec3(draw(key, 3 * index), draw(key, 3 * index + 1), draw(key, 3 * index + 2));
}

struct Mesh {
    std::vector<vec3> positions;
    std::vector<uvec3> triangles;

    void add(const vec3& a, const vec3& b, const vec3& c) {
        const auto first = static_cast<std::uint32_t>(positions.size());
        positions.insert(positions.end(), {a, b, c});
        triangles.push_back(uvec3(first, first + 1, first + 2));
    }
};

/// Triangles of one size in the unit cube, without shared vertices.
Mesh scattered(uint count, float size) {
    Mesh mesh;
    for (uint i = 0; i < count; ++i) {
        const vec3 at = draw_point(1, 4 * i);
        mesh.add(at, at + (draw_point(1, 4 * i + 1) - 0.5f) * size,
                 at + (draw_point(1, 4 * i + 2) - 0.5f) * size);
    }
    return mesh;
}

/// A rough sheet whose triangles share their vertices.
Mesh sheet(uint side) {
    Mesh mesh;
    for (uint y = 0; y < side; ++y)
        for (uint x = 0; x < side; ++x)
            mesh.positions.push_back(vec3(float(x), float(y), 0.5f * draw(2, y * side + x)));
    for (uint y = 0; y + 1 < side; ++y)
        for (uint x = 0; x + 1 < side; ++x) {
            const uint at = y * side + x;
            mesh.triangles.push_back(uvec3(at, at + 1, at + side));
            mesh.triangles.push_back(uvec3(at + 1, at + side + 1, at + side));
        }
    return mesh;
}

/// Small triangles among long slanted ones, for which spatial splits pay.
Mesh thatched(uint side, uint beams) {
    Mesh mesh = sheet(side);
    const float width = static_cast<float>(side);
    for (uint i = 0; i < beams; ++i) {
        const vec3 from(width * draw(3, 3 * i), 0.0f, 0.4f * draw(3, 3 * i + 1));
        const vec3 to = from + vec3(0.5f * width, width, 0.1f);
        mesh.add(from, to, to + vec3(0.1f, 0.0f, draw(3, 3 * i + 2)));
    }
    return mesh;
}

/// Visits a whole tree, counts nodes and leaves, and checks the boxes.
class Inspector {
  public:
    Inspector(const MeshTree& tree, const Mesh& mesh) : tree_(tree), boxes_(mesh.triangles.size()) {
        if (!tree.nodes.empty()) visit(0, tree.bounds, 1);
        EXPECT_EQ(nodes_, tree.nodes.size()) << "nodes that nothing leads to";
        EXPECT_EQ(deepest_, tree.depth);
        EXPECT_LE(tree.depth, bvh::max_tree_depth);
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) check(mesh, i);
    }
    std::size_t references() const { return references_; }

  private:
    void visit(std::uint32_t at, const Bounds& around, int depth) {
        ++nodes_;
        deepest_ = std::max(deepest_, depth);
        const WideNode& node = tree_.nodes[at];
        for (std::size_t child = 0; child < wide_children; ++child) {
            if (node.child[child] == invalid_index) continue;
            const Bounds box{{node.lo[0][child], node.lo[1][child], node.lo[2][child]},
                             {node.hi[0][child], node.hi[1][child], node.hi[2][child]}};
            EXPECT_TRUE(glm::all(glm::lessThanEqual(around.lo, box.lo))) << "a child leaves its parent";
            EXPECT_TRUE(glm::all(glm::lessThanEqual(box.hi, around.hi))) << "a child leaves its parent";
            if ((node.child[child] & leaf_bit) == 0) {
                EXPECT_GT(node.child[child], at) << "refit goes from the last node to the first";
                visit(node.child[child], box, depth + 1);
            } else {
                leaf(LeafCode{node.child[child]}, box);
            }
        }
    }

    void leaf(LeafCode leaf, const Bounds& box) {
        const std::uint32_t* numbers = tree_.leaf_words.data() + leaf.word() + 4 + 3 * leaf.vertices();
        for (std::uint32_t i = 0; i < leaf.triangles(); ++i) {
            ++references_;
            boxes_.at(numbers[i]).push_back(box);
        }
    }

    /// Every point of a triangle is in the box of a leaf that holds the triangle.
    void check(const Mesh& mesh, std::uint32_t number) {
        const uvec3 corners = mesh.triangles[number];
        const dvec3 a(mesh.positions[corners.x]), b(mesh.positions[corners.y]), c(mesh.positions[corners.z]);
        for (uint i = 0; i < 16; ++i) {
            double u = i < 3 ? (i == 1) : draw(number, 2 * i);
            double v = i < 3 ? (i == 2) : draw(number, 2 * i + 1);
            if (u + v > 1.0) {
                u = 1.0 - u;
                v = 1.0 - v;
            }
            const dvec3 p = i < 3 ? (i == 0 ? a : i == 1 ? b : c) : a * (1.0 - u - v) + b * u + c * v;
            const bool held =
                std::any_of(boxes_[number].begin(), boxes_[number].end(), [&](const Bounds& box) {
                    return glm::all(glm::lessThanEqual(dvec3(box.lo), p)) &&
                           glm::all(glm::lessThanEqual(p, dvec3(box.hi)));
                });
            EXPECT_TRUE(held) << "triangle " << number << ", point " << i;
        }
    }

    const MeshTree& tree_;
    std::vector<std::vector<Bounds>> boxes_; ///< of the leaves that hold each triangle
    std::size_t nodes_ = 0;
    std::size_t references_ = 0;
    int deepest_ = 0;
};

MeshTree build(const Mesh& mesh, BuildQuality quality, int threads = 1) {
    parallel::TaskPool pool(threads);
    return build_mesh_tree(mesh.positions, mesh.triangles, pool, quality);
}

TriangleRecord brute_force(const Mesh& mesh, const Ray& ray) {
    const geometry::ShearedRay sheared(ray);
    TriangleRecord record;
    float limit = next_float(ray.tmax, -1.0f);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        geometry::TriangleVertices vertices;
        for (int k = 0; k < 3; ++k) {
            const vec3& p = mesh.positions[mesh.triangles[i][k]];
            vertices[static_cast<std::size_t>(k)] = {p.x, p.y, p.z};
        }
        TriangleHit hit;
        if (!geometry::intersect_triangle(sheared, vertices, ray.tmin, limit, hit)) continue;
        if (hit.t == limit && record.triangle < i) continue;
        limit = hit.t;
        record = {hit.t, hit.u, hit.v, i};
    }
    return record;
}

/// Rays from outside toward vertices, edges and interiors of triangles.
std::vector<Ray> rays_at(const Mesh& mesh, uint count) {
    std::vector<Ray> rays;
    for (uint i = 0; i < count; ++i) {
        const uvec3 corners = mesh.triangles[hash_with(4, i) % mesh.triangles.size()];
        const float u = i % 3 == 0 ? 0.0f : draw(5, 2 * i);
        const float v = i % 3 == 1 ? 0.0f : (1.0f - u) * draw(5, 2 * i + 1);
        const vec3 p = mesh.positions[corners.x] * (1.0f - u - v) + mesh.positions[corners.y] * u +
                       mesh.positions[corners.z] * v;
        Ray ray;
        ray.origin = p + (draw_point(6, i) - 0.5f) * (i % 2 == 0 ? 1.0f : 30.0f);
        ray.direction = p - ray.origin;
        rays.push_back(ray);
    }
    return rays;
}

void expect_hits_of_brute_force(const MeshTree& tree, const Mesh& mesh, uint rays) {
    const std::vector<Ray> all = rays_at(mesh, rays);
    std::vector<TriangleRecord> records(all.size());
    std::vector<std::uint8_t> blocked(all.size());
    closest(tree, all, records, RayHint::coherent);
    occluded(tree, all, blocked, RayHint::incoherent);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const TriangleRecord wanted = brute_force(mesh, all[i]);
        const TriangleRecord plain = closest_scalar(tree, all[i]);
        EXPECT_EQ(std::memcmp(&plain, &wanted, sizeof wanted), 0) << "ray " << i;
        EXPECT_EQ(std::memcmp(&records[i], &wanted, sizeof wanted), 0) << "ray " << i << " in a batch";
        EXPECT_EQ(blocked[i] != 0, wanted.triangle != invalid_index) << "ray " << i;
        hits += wanted.triangle != invalid_index ? 1 : 0;
    }
    EXPECT_GT(hits, all.size() / 2);
}

TEST(MeshBuild, HoldsEveryPointOfEveryTriangle) {
    const std::pair<std::string, Mesh> meshes[] = {
        {"one", scattered(1, 1.0f)},
        {"nine", scattered(9, 0.1f)},
        {"small", scattered(30'000, 0.01f)},
        {"large", scattered(5'000, 1.0f)},
        {"sheet", sheet(150)},
        {"thatched", thatched(120, 100)},
        {"of references in more than a large page", scattered(90'000, 0.01f)}};
    for (const auto& [name, mesh] : meshes)
        for (const BuildQuality quality : qualities) {
            SCOPED_TRACE(name);
            const Inspector inspector(build(mesh, quality), mesh);
            EXPECT_GE(inspector.references(), mesh.triangles.size());
        }
}

TEST(MeshBuild, CutsTrianglesWhereThatPaysWithinItsBudget) {
    const Mesh mesh = thatched(120, 100);
    const std::size_t count = mesh.triangles.size();
    EXPECT_EQ(Inspector(build(mesh, BuildQuality::fast), mesh).references(), count);
    const std::size_t references = Inspector(build(mesh, BuildQuality::high), mesh).references();
    EXPECT_GT(references, count + count / 200) << "nothing is cut";
    EXPECT_LE(references, count + count * 15 / 100);
    const Mesh fine = sheet(120);
    EXPECT_EQ(Inspector(build(fine, BuildQuality::high), fine).references(), fine.triangles.size());
}

TEST(MeshBuild, GivesTheHitsOfBruteForce) {
    for (const Mesh& mesh : {thatched(60, 50), scattered(3000, 0.3f)})
        for (const BuildQuality quality : qualities)
            expect_hits_of_brute_force(build(mesh, quality), mesh, 1000);
}

TEST(MeshBuild, GivesTheHitsOfBruteForceAfterRefitting) {
    Mesh mesh = thatched(60, 50);
    for (const BuildQuality quality : qualities) {
        MeshTree tree = build(mesh, quality);
        parallel::TaskPool pool(2);
        for (uint i = 0; i < mesh.positions.size(); ++i) mesh.positions[i] += draw_point(7, i) * 5.0f;
        refit(tree, mesh.positions, mesh.triangles, pool);
        const Inspector inspector(tree, mesh);
        expect_hits_of_brute_force(tree, mesh, 500);
    }
}

TEST(MeshBuild, TakesAnyInput) {
    Mesh equal;
    for (uint i = 0; i < 50'000; ++i) equal.add(vec3(0), vec3(1, 0, 0), vec3(0, 1, 0));
    Mesh concentric; // all centres one, all sizes different
    for (uint i = 0; i < 20'000; ++i) {
        const float s = std::ldexp(1.0f, static_cast<int>(i % 200) - 100);
        concentric.add(vec3(-s, -s, 0), vec3(s, -s, s), vec3(0, s, -s));
    }
    Mesh geometric; // each as far from the next as from the origin
    for (uint i = 0; i < 4000; ++i) {
        const float x = std::ldexp(1.0f, 100 - static_cast<int>(i % 220));
        geometric.add(vec3(x), vec3(x, x, 1.5f * x), vec3(x, 1.25f * x, x));
    }
    Mesh points;
    for (uint i = 0; i < 10'000; ++i) points.add(draw_point(8, i), draw_point(8, i), draw_point(8, i));
    Mesh needles; // a million times as long as wide
    for (uint i = 0; i < 10'000; ++i) {
        const vec3 a = draw_point(9, 2 * i) * 1000.0f;
        needles.add(a, draw_point(9, 2 * i + 1) * 1000.0f, a + 0.001f);
    }
    Mesh huge = scattered(5000, 0.5f);
    for (vec3& p : huge.positions) p = (p - 0.5f) * 3e38f;
    Mesh tiny = scattered(5000, 0.5f);
    for (vec3& p : tiny.positions) p *= 1e-40f;
    const std::pair<std::string, const Mesh*> meshes[] = {
        {"equal", &equal},   {"concentric", &concentric}, {"geometric", &geometric},
        {"points", &points}, {"needles", &needles},       {"huge", &huge},
        {"tiny", &tiny}};
    for (const auto& [name, mesh] : meshes)
        for (const BuildQuality quality : qualities) {
            SCOPED_TRACE(name);
            const Inspector inspector(build(*mesh, quality), *mesh);
            EXPECT_GE(inspector.references(), mesh->triangles.size());
        }
}

TEST(MeshBuild, LeavesOutWhatIsNotFinite) {
    Mesh mesh = scattered(70'000, 0.05f);
    for (uint i = 0; i < mesh.triangles.size(); i += 7)
        mesh.positions[mesh.triangles[i].y][i % 3] =
            i % 2 == 0 ? std::numeric_limits<float>::quiet_NaN() : std::numeric_limits<float>::infinity();
    for (const BuildQuality quality : qualities) {
        const MeshTree tree = build(mesh, quality);
        EXPECT_EQ(tree.left_out, (mesh.triangles.size() + 6) / 7);
        EXPECT_EQ(tree.triangles, mesh.triangles.size());
        for (uint i = 0; i < 200; ++i) {
            Ray ray;
            ray.origin = draw_point(10, 2 * i) * 3.0f - 1.0f;
            ray.direction = draw_point(10, 2 * i + 1) - ray.origin;
            const TriangleRecord found = closest_scalar(tree, ray);
            const TriangleRecord wanted = brute_force(mesh, ray);
            EXPECT_EQ(std::memcmp(&found, &wanted, sizeof wanted), 0);
        }
    }
}

TEST(MeshBuild, IsTheSameOnAnyNumberOfThreads) {
    for (const Mesh& mesh : {scattered(90'000, 0.02f), thatched(200, 300)})
        for (const BuildQuality quality : qualities) {
            const MeshTree one = build(mesh, quality, 1);
            for (const int threads : {2, 7}) {
                const MeshTree many = build(mesh, quality, threads);
                EXPECT_EQ(many.leaf_words, one.leaf_words);
                ASSERT_EQ(many.nodes.size(), one.nodes.size());
                EXPECT_EQ(
                    std::memcmp(many.nodes.data(), one.nodes.data(), one.nodes.size() * sizeof(WideNode)), 0);
                EXPECT_EQ(many.depth, one.depth);
            }
        }
}

/// A parallelogram of side × side × 2 triangles.
void add_grid(Mesh& mesh, const vec3& corner, const vec3& along, const vec3& up, uint side) {
    const float step = 1.0f / static_cast<float>(side);
    for (uint y = 0; y < side; ++y)
        for (uint x = 0; x < side; ++x) {
            const vec3 at =
                corner + along * (step * static_cast<float>(x)) + up * (step * static_cast<float>(y));
            mesh.add(at, at + along * step, at + up * step);
            mesh.add(at + along * step, at + up * step, at + (along + up) * step);
        }
}

TEST(MeshBuild, EstimatesHowOftenALineMeetsTheSurface) {
    // A line through a cube meets two of its sides.
    Mesh cube;
    const vec3 axes[] = {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)};
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {0.0f, 1.0f})
            add_grid(cube, axes[axis] * side, axes[(axis + 1) % 3], axes[(axis + 2) % 3], 20);
    // A diagonal rectangle of √2 in bounds of six sides: 2 · √2 / 6 times.
    Mesh diagonal;
    add_grid(diagonal, vec3(0.0f), vec3(1, 1, 0), vec3(0, 0, 1), 40);
    for (const BuildQuality quality : qualities) {
        EXPECT_NEAR(build(cube, quality).depth_complexity, 2.0, 1e-4);
        EXPECT_NEAR(build(diagonal, quality).depth_complexity, std::sqrt(2.0) / 3.0, 1e-4);
        // Half of a diagonal square, the whole mesh.
        Mesh one;
        one.add(vec3(0.0f), vec3(1, 1, 0), vec3(0, 0, 1));
        EXPECT_NEAR(build(one, quality).depth_complexity, std::sqrt(2.0) / 6.0, 1e-6);
    }
}

double bytes_a_triangle(const Mesh& mesh, BuildQuality quality) {
    return static_cast<double>(build(mesh, quality).bytes()) / static_cast<double>(mesh.triangles.size());
}

TEST(MeshBuild, HoldsAtMost48BytesATriangleWhereVerticesAreShared) {
    for (const BuildQuality quality : qualities) {
        EXPECT_LE(bytes_a_triangle(sheet(200), quality), 48.0);
        EXPECT_LE(bytes_a_triangle(thatched(200, 300), quality), 48.0);
    }
}

TEST(MeshBuild, HoldsAtMost72BytesATriangleWhereNoneIsShared) {
    for (const BuildQuality quality : qualities)
        for (const float size : {0.001f, 0.1f, 1.0f})
            EXPECT_LE(bytes_a_triangle(scattered(30'000, size), quality), 72.0) << size;
}

} // namespace
} // namespace glint
