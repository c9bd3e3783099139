// Every kernel gives the bits of the scalar one.

#include "trace/mesh/scalar.h"

#include "math/random.shared.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace glint {

using trace::build_mesh_tree;
using trace::closest_scalar;
using trace::MeshTree;
using trace::TriangleRecord;
namespace {

float draw(uint key, uint index) { return unit_float(hash_with(key, index)); }

vec3 draw_point(uint key, uint index) {
    return vec3(draw(key, 3 * index), draw(key, 3 * index + 1), draw(key, 3 * index + 2));
}

struct Soup {
    std::vector<vec3> positions;
    std::vector<uvec3> triangles;
};

/// Small triangles scattered in a cube of side 1 · scale, some duplicated, some degenerate.
Soup soup(uint seed, std::size_t count, float scale) {
    Soup s;
    for (uint i = 0; i < count; ++i) {
        const vec3 at = draw_point(seed, 4 * i);
        for (uint k = 1; k < 4; ++k)
            s.positions.push_back((at + (draw_point(seed, 4 * i + k) - 0.5f) * 0.2f) * scale);
        const uint first = 3 * (i % 16 == 15 ? i - 1 : i);
        s.triangles.push_back(uvec3(first, first + 1, i % 32 == 7 ? first : first + 2));
    }
    return s;
}

/// Parallel, axis-parallel and scattered rays, short and long, with NaN or infinity, and without direction.
std::vector<Ray> rays_for(uint seed, std::size_t count, float scale) {
    std::vector<Ray> rays;
    for (uint i = 0; i < count; ++i) {
        Ray ray;
        ray.origin = (draw_point(seed, 2 * i) * 3.0f - 1.0f) * scale;
        ray.direction = draw_point(seed, 2 * i + 1) - 0.5f;
        if (i % 3 == 0) ray.direction = vec3(0.1f, 0.2f, 1.0f);
        if (i % 16 == 1) ray.direction = vec3(0.0f, i % 32 == 1 ? -0.0f : 0.0f, i % 64 == 1 ? -1e-12f : 2.0f);
        if (i % 8 == 2) ray.tmax = 0.4f * scale;
        if (i % 8 == 3) ray.tmin = 0.5f * scale;
        if (i % 128 == 5) ray.direction.x = std::numeric_limits<float>::quiet_NaN();
        if (i % 128 == 6) ray.origin.y = std::numeric_limits<float>::infinity();
        if (i % 128 == 7) ray.direction = vec3(0.0f);
        rays.push_back(ray);
    }
    return rays;
}

bool same_bits(const TriangleRecord& a, const TriangleRecord& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

void expect_agreement(const MeshTree& tree, const std::vector<Ray>& rays) {
    std::vector<TriangleRecord> records(rays.size());
    std::vector<std::uint8_t> blocked(rays.size());
    for (const RayHint hint : {RayHint::coherent, RayHint::incoherent}) {
        closest(tree, rays, records, hint);
        occluded(tree, rays, blocked, hint);
        int hits = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const TriangleRecord wanted = closest_scalar(tree, rays[i]);
            EXPECT_TRUE(same_bits(records[i], wanted)) << "ray " << i << " in a batch";
            EXPECT_TRUE(same_bits(closest(tree, rays[i]), wanted)) << "ray " << i << " alone";
            EXPECT_EQ(blocked[i] != 0, wanted.triangle != invalid_index) << "ray " << i << " in a batch";
            EXPECT_EQ(occluded(tree, rays[i]), wanted.triangle != invalid_index) << "ray " << i << " alone";
            if (wanted.triangle != invalid_index) ++hits;
        }
        EXPECT_GT(hits, static_cast<int>(rays.size() / 20));
    }
}

class MeshTreeAtScale : public testing::TestWithParam<float> {};

TEST_P(MeshTreeAtScale, KernelsGiveTheBitsOfThePlainWalk) {
    parallel::TaskPool pool(2);
    for (uint seed = 1; seed <= 4; ++seed) {
        const Soup s = soup(seed, 3000, GetParam());
        expect_agreement(build_mesh_tree(s.positions, s.triangles, pool), rays_for(seed, 5000, GetParam()));
    }
}

INSTANTIATE_TEST_SUITE_P(Scales, MeshTreeAtScale, testing::Values(1e-12f, 1.0f, 1e12f));

TEST(MeshTree, EveryQualityGivesTheSameHits) {
    parallel::TaskPool pool(2);
    const Soup s = soup(5, 3000, 1.0f);
    const MeshTree fast = build_mesh_tree(s.positions, s.triangles, pool, BuildQuality::fast);
    const MeshTree high = build_mesh_tree(s.positions, s.triangles, pool, BuildQuality::high);
    EXPECT_EQ(fast.quality, BuildQuality::fast);
    EXPECT_EQ(high.quality, BuildQuality::high);
    expect_agreement(fast, rays_for(5, 2000, 1.0f));
    for (const Ray& ray : rays_for(6, 5000, 1.0f))
        EXPECT_TRUE(same_bits(closest_scalar(fast, ray), closest_scalar(high, ray)));
}

/// The vertices of a soup, each moved independently, so that equal positions become different.
std::vector<vec3> moved(const Soup& s, uint seed, float by) {
    std::vector<vec3> positions = s.positions;
    for (uint i = 0; i < positions.size(); ++i) positions[i] += (draw_point(seed, i) - 0.5f) * by;
    return positions;
}

TEST(MeshTree, RefitGivesTheHitsOfANewTree) {
    parallel::TaskPool pool(2);
    Soup s = soup(7, 3000, 1.0f);
    // Every second pair of triangles shares positions, but not vertices.
    for (std::size_t i = 0; i + 6 <= s.positions.size(); i += 12) {
        s.positions[i + 3] = s.positions[i + 1];
        s.positions[i + 4] = s.positions[i + 2];
    }
    for (const BuildQuality quality : {BuildQuality::fast, BuildQuality::high}) {
        MeshTree tree = build_mesh_tree(s.positions, s.triangles, pool, quality);
        for (const float by : {0.0f, 0.01f, 3.0f}) {
            const std::vector<vec3> positions = moved(s, 8, by);
            refit(tree, positions, s.triangles, pool);
            const MeshTree anew = build_mesh_tree(positions, s.triangles, pool, quality);
            EXPECT_EQ(tree.bounds.lo, anew.bounds.lo);
            EXPECT_EQ(tree.bounds.hi, anew.bounds.hi);
            const std::vector<Ray> rays = rays_for(9, 3000, 1.0f);
            expect_agreement(tree, rays);
            for (const Ray& ray : rays)
                EXPECT_TRUE(same_bits(closest_scalar(tree, ray), closest_scalar(anew, ray)));
        }
    }
}

TEST(MeshTree, RefitTakesVerticesThatBecomeOrWereNotFinite) {
    parallel::TaskPool pool(1);
    const Soup s = soup(11, 500, 1.0f);
    std::vector<vec3> positions = s.positions;
    positions[0].y = std::numeric_limits<float>::quiet_NaN();
    MeshTree tree = build_mesh_tree(s.positions, s.triangles, pool);
    const MeshTree whole = tree;
    refit(tree, positions, s.triangles, pool);
    EXPECT_GT(tree.left_out, 0u);
    for (const Ray& ray : rays_for(12, 1000, 1.0f)) EXPECT_NE(closest_scalar(tree, ray).triangle, 0u);
    refit(tree, s.positions, s.triangles, pool);
    EXPECT_EQ(tree.left_out, 0u);
    for (const Ray& ray : rays_for(12, 1000, 1.0f))
        EXPECT_TRUE(same_bits(closest_scalar(tree, ray), closest_scalar(whole, ray)));
    EXPECT_THROW(refit(tree, s.positions, std::span(s.triangles).first(10), pool), std::invalid_argument);
}

TEST(MeshTree, HoldsNothingAndHitsNothing) {
    parallel::TaskPool pool(1);
    const MeshTree tree = build_mesh_tree({}, {}, pool);
    const std::vector<Ray> rays(100);
    std::vector<TriangleRecord> records(rays.size());
    std::vector<std::uint8_t> blocked(rays.size(), 1);
    closest(tree, rays, records, RayHint::coherent);
    occluded(tree, rays, blocked, RayHint::coherent);
    EXPECT_EQ(records[99].triangle, invalid_index);
    EXPECT_EQ(blocked[99], 0);
    EXPECT_EQ(closest(tree, Ray{}).triangle, invalid_index);
    EXPECT_FALSE(occluded(tree, Ray{}));
}

TEST(MeshTree, OfEqualTrianglesTheFirstIsHit) {
    parallel::TaskPool pool(2);
    const std::vector<vec3> positions{vec3(-1, -1, 0), vec3(1, -1, 0), vec3(0, 1, 0)};
    const std::vector<uvec3> triangles(20000, uvec3(0, 1, 2));
    const MeshTree tree = build_mesh_tree(positions, triangles, pool);
    Ray ray;
    ray.origin = vec3(0, 0, -1);
    const std::vector<Ray> rays(64, ray);
    std::vector<TriangleRecord> records(rays.size());
    for (const RayHint hint : {RayHint::coherent, RayHint::incoherent}) {
        closest(tree, rays, records, hint);
        for (const TriangleRecord& record : records) EXPECT_EQ(record.triangle, 0u);
    }
    EXPECT_EQ(closest(tree, ray).triangle, 0u);
}

} // namespace
} // namespace glint
