// The public tracing interface gives the bits of brute force and rejects invalid input.

#include "traced.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <thread>

namespace glint::tracing {
namespace {

void expect_brute_force(const Mesh& mesh, const Soup& soup, const std::vector<Ray>& rays) {
    std::vector<Hit> hits(rays.size());
    std::vector<std::uint8_t> blocked(rays.size());
    std::size_t found = 0;
    for (const RayHint hint : hints) {
        mesh.closest(rays, hits, hint);
        mesh.occluded(rays, blocked, hint);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Hit wanted = brute_force(soup, rays[i]);
            EXPECT_TRUE(same_bits(hits[i], wanted)) << "ray " << i << " in a batch";
            EXPECT_TRUE(same_bits(mesh.closest(rays[i]), wanted)) << "ray " << i << " alone";
            EXPECT_EQ(blocked[i], wanted ? 1 : 0) << "ray " << i << " in a batch";
            EXPECT_EQ(mesh.occluded(rays[i]), bool(wanted)) << "ray " << i << " alone";
            found += wanted ? 1 : 0;
        }
    }
    EXPECT_GT(found, rays.size() / 10);
    EXPECT_LT(found, 2 * rays.size());
}

TEST(Tracing, MeshesGiveTheBitsOfBruteForce) {
    for (std::uint32_t seed = 1; seed <= 5; ++seed) {
        const Soup soup = make_soup(seed, 400);
        expect_brute_force(Mesh(soup.xyz, soup.corners), soup, make_rays(soup, seed, 1500));
    }
}

TEST(Tracing, EveryKernelAndTargetGivesTheBitsOfBruteForce) {
    const Soup soup = make_soup(6, 300);
    const Mesh mesh(soup.xyz, soup.corners);
    const std::vector<Ray> rays = make_rays(soup, 6, 1000);
    for (const Kernel kernel :
         {Kernel::automatic, Kernel::scalar, Kernel::single, Kernel::packets, Kernel::streams})
        for (const SimdTarget target :
             {SimdTarget::best, SimdTarget::plain, SimdTarget::sse4, SimdTarget::avx2, SimdTarget::avx512}) {
            const KernelChoice choice{kernel, target};
            std::vector<Hit> hits(rays.size());
            std::vector<std::uint8_t> blocked(rays.size());
            if (!is_available(target)) {
                EXPECT_THROW(mesh.closest(rays, hits, RayHint::incoherent, {Kernel::single, target}),
                             std::invalid_argument);
                continue;
            }
            mesh.closest(rays, hits, RayHint::incoherent, choice);
            mesh.occluded(rays, blocked, RayHint::incoherent, choice);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const Hit wanted = brute_force(soup, rays[i]);
                EXPECT_TRUE(same_bits(hits[i], wanted)) << "ray " << i;
                EXPECT_EQ(blocked[i], wanted ? 1 : 0) << "ray " << i;
            }
        }
}

TEST(Tracing, QualitiesDifferInNoBit) {
    const Soup soup = make_soup(8, 3000);
    const Mesh fast(soup.xyz, soup.corners, {.quality = BuildQuality::fast});
    const Mesh high(soup.xyz, soup.corners, {.quality = BuildQuality::high});
    EXPECT_EQ(fast.stats().quality, BuildQuality::fast);
    EXPECT_EQ(high.stats().quality, BuildQuality::high);
    for (const Ray& ray : make_rays(soup, 8, 2000))
        EXPECT_TRUE(same_bits(fast.closest(ray), high.closest(ray)));
}

TEST(Tracing, AMeshFollowsItsVertices) {
    const Soup before = make_soup(11, 300);
    Soup after = before;
    for (std::uint32_t i = 0; i < after.xyz.size(); ++i) after.xyz[i] += 0.4f * draw(12, i);
    Mesh mesh(before.xyz, before.corners);
    const Mesh copy = mesh;
    mesh.refit(after.xyz, after.corners);
    expect_brute_force(mesh, after, make_rays(after, 11, 1000));
    expect_brute_force(copy, before, make_rays(before, 11, 1000));
    mesh.refit(before.xyz, before.corners);
    expect_brute_force(mesh, before, make_rays(before, 11, 1000));
}

TEST(Tracing, ArraysOfStructuresAreReadByTheirStride) {
    const Soup soup = make_soup(7, 200);
    struct Vertex {
        float x, y, z, weight, u, v;
    };
    struct Face {
        std::uint32_t corner[3], material;
    };
    std::vector<Vertex> vertices;
    for (std::size_t i = 0; i < soup.xyz.size(); i += 3)
        vertices.push_back({soup.xyz[i], soup.xyz[i + 1], soup.xyz[i + 2], 1, 2, 3});
    std::vector<Face> faces;
    for (std::size_t i = 0; i < soup.corners.size(); i += 3)
        faces.push_back({{soup.corners[i], soup.corners[i + 1], soup.corners[i + 2]}, 9});
    const Mesh mesh(Vertices(&vertices[0].x, vertices.size(), sizeof(Vertex)),
                    Triangles(faces[0].corner, faces.size(), sizeof(Face)));
    expect_brute_force(mesh, soup, make_rays(soup, 7, 1000));
}

TEST(Tracing, TheTreeDoesNotDependOnThreads) {
    const Soup soup = make_soup(3, 5000);
    const std::vector<Ray> rays = make_rays(soup, 3, 500);
    const Mesh one(soup.xyz, soup.corners, {.threads = 1});
    const Mesh three(soup.xyz, soup.corners, {.threads = 3});
    EXPECT_EQ(one.stats().bytes, three.stats().bytes);
    for (const Ray& ray : rays) EXPECT_TRUE(same_bits(one.closest(ray), three.closest(ray)));
}

TEST(Tracing, ManyThreadsMayAskAtOnce) {
    const Soup soup = make_soup(4, 400);
    const Mesh mesh(soup.xyz, soup.corners);
    const std::vector<Ray> rays = make_rays(soup, 4, 2000);
    std::vector<std::vector<Hit>> hits(4, std::vector<Hit>(rays.size()));
    std::vector<std::thread> threads;
    for (auto& mine : hits) threads.emplace_back([&] { mesh.closest(rays, mine, RayHint::incoherent); });
    for (std::thread& thread : threads) thread.join();
    for (const auto& mine : hits)
        for (std::size_t i = 0; i < rays.size(); ++i)
            EXPECT_TRUE(same_bits(mine[i], mesh.closest(rays[i]))) << i;
}

TEST(Tracing, AnEmptyMeshIsHitByNothing) {
    for (const Mesh& mesh : {Mesh(), Mesh(std::vector<float>{}, std::vector<std::uint32_t>{}),
                             Mesh(std::vector<float>{1, 2, 3}, std::vector<std::uint32_t>{})}) {
        const std::vector<Ray> rays(70);
        std::vector<Hit> hits(rays.size(), Hit{1, 1, 1, 1});
        std::vector<std::uint8_t> blocked(rays.size(), 1);
        mesh.closest(rays, hits, RayHint::coherent);
        mesh.occluded(rays, blocked, RayHint::coherent);
        EXPECT_TRUE(same_bits(hits[69], Hit{}));
        EXPECT_EQ(blocked[69], 0);
        EXPECT_FALSE(mesh.closest(Ray{}));
        EXPECT_FALSE(mesh.occluded(Ray{}));
        EXPECT_EQ(mesh.stats().triangles, 0u);
        EXPECT_GT(mesh.bounds().lo[0], mesh.bounds().hi[0]);
    }
}

TEST(Tracing, ASingleTriangleAndALineOfThemAreSound) {
    const std::vector<float> xyz{-1, -1, 1, 1, -1, 1, 0, 1, 1};
    const std::vector<Ray> rays(70); // along +z
    for (const BuildQuality quality : {BuildQuality::fast, BuildQuality::high}) {
        const Mesh one(xyz, std::vector<std::uint32_t>{0, 1, 2}, {.quality = quality});
        std::vector<std::uint32_t> flat; // without an area, each
        for (int i = 0; i < 5000; ++i) flat.insert(flat.end(), {0, 1, 1});
        const Mesh none_hit(xyz, flat, {.quality = quality});
        for (const RayHint hint : {RayHint::coherent, RayHint::incoherent}) {
            std::vector<Hit> hits(rays.size());
            one.closest(rays, hits, hint);
            for (const Hit& hit : hits) EXPECT_EQ(hit.triangle, 0u);
            none_hit.closest(rays, hits, hint);
            for (const Hit& hit : hits) EXPECT_FALSE(hit);
        }
        EXPECT_EQ(one.closest(Ray{}).t, 1.0f);
        EXPECT_FALSE(none_hit.occluded(Ray{}));
    }
}

TEST(Tracing, NoRaysAreNoWork) {
    const Soup soup = make_soup(1, 10);
    const Mesh mesh(soup.xyz, soup.corners);
    mesh.closest({}, {}, RayHint::coherent);
    mesh.occluded({}, {}, RayHint::incoherent);
}

TEST(Tracing, TrianglesThatAreNotFiniteAreSkippedAndCounted) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const std::vector<float> xyz{-1, -1, 1, 1, -1, 1, 0, 1, 1, nan, 0, 1, 0, infinity, 1};
    const std::vector<std::uint32_t> corners{0, 1, 3, 0, 4, 2, 0, 1, 2};
    const Mesh mesh(xyz, corners);
    EXPECT_EQ(mesh.stats().triangles, 3u);
    EXPECT_EQ(mesh.stats().skipped, 2u);
    EXPECT_EQ(mesh.closest(Ray{}).triangle, 2u);
    EXPECT_EQ(mesh.bounds().hi, (std::array<float, 3>{1, 1, 1}));
}

TEST(Tracing, CopiesShareTheirTree) {
    const Soup soup = make_soup(2, 50);
    Mesh first(soup.xyz, soup.corners);
    const Mesh second = first;
    const std::vector<Ray> rays = make_rays(soup, 2, 200);
    first = Mesh();
    for (const Ray& ray : rays) {
        EXPECT_TRUE(same_bits(second.closest(ray), brute_force(soup, ray)));
        EXPECT_FALSE(first.closest(ray));
    }
}

/// The message of an invalid_argument; empty if nothing was thrown.
template <class Body>
std::string refusal(Body&& body) {
    try {
        body();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return {};
}

TEST(Tracing, WrongInputIsRefusedWithItsReason) {
    const std::vector<float> xyz(9, 0.5f);
    const std::vector<float> ragged(10, 0.5f);
    using Corners = std::vector<std::uint32_t>;
    const Corners good{0, 1, 2};
    EXPECT_EQ(refusal([&] {
                  Mesh(xyz, Corners{0, 1, 3});
              }),
              "a triangle names a vertex that its mesh does not have");
    EXPECT_EQ(refusal([&] {
                  Mesh(std::vector<float>{}, Corners{0, 0, 0});
              }),
              "a triangle names a vertex that its mesh does not have");
    EXPECT_EQ(refusal([&] { Mesh(xyz, Corners{0, 1}); }), "the triangles are not three numbers each");
    EXPECT_EQ(refusal([&] { Mesh(ragged, good); }), "the vertices are not three floats each");
    for (const std::size_t stride : {std::size_t{0}, std::size_t{8}, std::size_t{13}}) {
        EXPECT_EQ(refusal([&] { Mesh(Vertices(xyz.data(), 3, stride), Triangles(good.data(), 1, 12)); }),
                  "a stride is no multiple of 4 bytes or below 12");
        EXPECT_EQ(refusal([&] { Mesh(Vertices(xyz.data(), 3, 12), Triangles(good.data(), 1, stride)); }),
                  "a stride is no multiple of 4 bytes or below 12");
    }
}

TEST(Tracing, OtherTrianglesThanTheMeshHasAreRefused) {
    const Soup soup = make_soup(1, 20);
    Mesh mesh(soup.xyz, soup.corners);
    std::vector<std::uint32_t> corners = soup.corners;
    corners[3] = 1000;
    EXPECT_EQ(refusal([&] { mesh.refit(soup.xyz, corners); }),
              "a triangle names a vertex that its mesh does not have");
    corners = {soup.corners.begin(), soup.corners.begin() + 30};
    EXPECT_EQ(refusal([&] { mesh.refit(soup.xyz, corners); }),
              "the number of triangles is not that of the mesh");
    expect_brute_force(mesh, soup, make_rays(soup, 1, 500));
}

TEST(Tracing, BatchesOfDifferentLengthsAreRefused) {
    const Mesh mesh;
    const std::vector<Ray> rays(3);
    std::vector<Hit> hits(2);
    std::vector<std::uint8_t> blocked(4);
    EXPECT_EQ(refusal([&] { mesh.closest(rays, hits, RayHint::coherent); }),
              "rays and hits differ in number");
    EXPECT_EQ(refusal([&] { mesh.occluded(rays, blocked, RayHint::coherent); }),
              "rays and blocked differ in number");
}

} // namespace
} // namespace glint::tracing
