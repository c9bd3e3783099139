// Batches of similar rays past and through planes, spheres, cylinders and meshes: a primitive that is culled
// for a batch is hit by none of its rays.

#include "trace/world/packet_bounds.h"
#include "worlds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace glint {

using trace::Hit;
using trace::PacketBounds;
using trace::PlanePrim;
using trace::RayBoxes;
using trace::World;
using trace::WorldInput;
namespace {

constexpr float endless = std::numeric_limits<float>::infinity();

dvec3 snapped(Numbers& numbers, double size) {
    // Halves, so that planes pass exactly through points and boxes touch.
    return glm::round(numbers.point() * 4.0) * 0.5 * size;
}

WorldInput scattered_world(Numbers& numbers, double size, std::uint32_t spheres) {
    WorldInput input;
    std::uint32_t object = 0;
    for (int i = 0; i < 3; ++i) {
        const dvec3 normal = numbers.below(2) == 0 ? numbers.direction() : glm::round(numbers.direction());
        const dvec3 n = normal == dvec3(0.0) ? dvec3(0, 0, 1) : normal;
        input.planes.push_back({object++, n, glm::dot(n, snapped(numbers, size))});
    }
    for (std::uint32_t i = 0; i < spheres; ++i) {
        const dvec3 center = snapped(numbers, size);
        const double radius = (0.1 + std::abs(numbers())) * 0.3 * size;
        input.quadrics.push_back({object++, 0, geometry::make_sphere(center, radius)});
    }
    const dvec3 base = snapped(numbers, size);
    const dvec3 axis = numbers.direction();
    input.quadrics.push_back({object++, 0, geometry::make_cylinder(base, axis, size * 0.5, size * 0.25)});
    const dvec3 center = snapped(numbers, size);
    const dvec3 normal = numbers.direction();
    input.quadrics.push_back({object++, 0, geometry::make_disk(center, normal, size * 0.4)});
    input.quadrics.push_back({object++, 0, geometry::make_cone(center, -normal, size * 0.6, size * 0.3)});
    WorldInput::Triangles mesh = square(object, static_cast<float>(numbers()));
    const vec3 corner(snapped(numbers, size));
    for (vec3& p : mesh.positions) p = p * static_cast<float>(size) + corner;
    input.meshes.push_back(mesh);
    return input;
}

/// Rays between two small regions, with one random tmax for all.
std::vector<Ray> beam(Numbers& numbers, double size, std::size_t count) {
    const dvec3 from = snapped(numbers, size);
    const dvec3 to = snapped(numbers, size) + dvec3(0.01 * size, 0.0, 0.0);
    const double spread = numbers.below(4) == 0 ? 0.0 : 0.2 * std::abs(numbers()) * size;
    const double narrow = numbers.below(4) == 0 ? 0.0 : 0.2 * std::abs(numbers()) * size;
    const float tmax = numbers.below(2) == 0 ? 1.0f : (numbers.below(2) == 0 ? endless : 0.25f);
    const bool backward = numbers.below(8) == 0;
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        Ray ray;
        ray.origin = vec3(from + numbers.point() * spread);
        ray.direction = vec3(to + numbers.point() * narrow) - ray.origin;
        ray.tmax = tmax;
        if (backward) ray.tmin = -0.5f;
        if (numbers.below(32) == 0) ray.tmax = -1.0f;
        if (numbers.below(64) == 0) ray.tmax = endless;
        if (numbers.below(128) == 0) ray.origin.y = std::numeric_limits<float>::quiet_NaN();
        if (numbers.below(128) == 0) ray.direction.x = -endless;
        if (numbers.below(64) == 0) ray.direction = vec3(0.0f, 0.0f, ray.direction.z);
        rays.push_back(ray);
    }
    return rays;
}

bool same_hits(const Hit& a, const Hit& b) {
    return a.t == b.t && a.u == b.u && a.v == b.v && a.object == b.object && a.prim == b.prim &&
           a.kind == b.kind && a.on_edge == b.on_edge;
}

std::vector<SimdTarget> all_targets() {
    std::vector<SimdTarget> all;
    for (const SimdTarget target :
         {SimdTarget::plain, SimdTarget::sse4, SimdTarget::avx2, SimdTarget::avx512})
        if (is_available(target)) all.push_back(target);
    return all;
}

class BatchesOfRays : public testing::TestWithParam<double> {};

TEST_P(BatchesOfRays, HitWhatEachRayHitsAlone) {
    const double size = GetParam();
    Numbers numbers(11);
    World::Scratch scratch;
    std::size_t hit = 0;
    for (int round = 0; round < 400; ++round) {
        const World world = world_of(scattered_world(numbers, size, round % 4 == 0 ? 12 : 3));
        const std::vector<Ray> rays = beam(numbers, size, 1 + numbers.below(150));
        std::vector<Hit> hits(rays.size());
        std::vector<std::uint8_t> blocked(rays.size());
        for (const SimdTarget target : all_targets()) {
            const KernelChoice choice{Kernel::automatic, target};
            world.closest(rays, hits, RayHint::coherent, scratch, choice);
            world.occluded(rays, blocked, RayHint::coherent, scratch, choice);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const Hit alone = world.closest_brute_force(rays[i]);
                ASSERT_TRUE(same_hits(hits[i], alone))
                    << "round " << round << ", ray " << i << ", target " << int(target);
                ASSERT_EQ(blocked[i] != 0, world.occluded_brute_force(rays[i]))
                    << "round " << round << ", ray " << i;
                hit += alone ? 1 : 0;
            }
        }
    }
    EXPECT_GT(hit, 10000u);
}

INSTANTIATE_TEST_SUITE_P(Sizes, BatchesOfRays, testing::Values(1e-6, 1.0, 1000.0, 1e12));

RayBoxes boxes_of(const std::vector<Ray>& rays) {
    RayBoxes boxes;
    for (const Ray& ray : rays) boxes.add(ray);
    return boxes;
}

/// A bundle from (0, 0, 1) along +x, a tenth wide at its start, twice that at x = 10 where it ends.
std::vector<Ray> bundle() {
    Numbers numbers(3);
    std::vector<Ray> rays;
    for (int i = 0; i < 64; ++i) {
        Ray ray;
        ray.origin = vec3(0.0f, numbers() * 0.05, 1.0 + numbers() * 0.05);
        ray.direction = vec3(10.0, numbers() * 0.05, numbers() * 0.05);
        ray.tmax = 1.0f;
        rays.push_back(ray);
    }
    return rays;
}

TEST(PacketBounds, LeavesOutPlanesBesideBehindAndBeyond) {
    const PacketBounds reach(boxes_of(bundle()));
    const auto misses = [&](const dvec3& normal, double offset) {
        PlanePrim plane;
        plane.plane = {normal, offset};
        return reach.misses(plane);
    };
    EXPECT_TRUE(misses({0, 0, 1}, 0.0)) << "beside";
    EXPECT_TRUE(misses({0, 0, -3}, 0.0)) << "turned over, longer";
    EXPECT_TRUE(misses({1, 0, 0}, -0.01)) << "behind";
    EXPECT_TRUE(misses({1, 0, 0}, 10.1)) << "beyond";
    EXPECT_TRUE(misses({1, 0, 1}, 12.0)) << "beyond, slanted";
    EXPECT_FALSE(misses({1, 0, 0}, 9.9)) << "before the end";
    EXPECT_FALSE(misses({0, 0, 1}, 1.0)) << "through the middle";
    EXPECT_FALSE(misses({0, 0, 1}, 1.06)) << "only some rays near the end";
    EXPECT_FALSE(misses({0, 0, 0}, 0.0)) << "no plane at all";
}

TEST(PacketBounds, LeavesOutBoxesBesideBehindAndBeyond) {
    std::vector<Ray> rays = bundle();
    const auto misses = [&](const vec3& lo, const vec3& hi) {
        return PacketBounds(boxes_of(rays)).misses(Bounds{lo, hi});
    };
    for (int pass = 0; pass < 2; ++pass) {
        EXPECT_TRUE(misses({4, -1, 0}, {5, 1, 0.8f})) << "below";
        EXPECT_TRUE(misses({4, 0.2f, 0}, {5, 1, 2})) << "beside";
        EXPECT_TRUE(misses({-2, -1, 0}, {-0.1f, 1, 2})) << "behind";
        EXPECT_EQ(misses({10.1f, -1, 0}, {11, 1, 2}), pass == 0) << "beyond the end, where there is one";
        EXPECT_FALSE(misses({4, -1, 0}, {5, 1, 2})) << "in the way";
        EXPECT_FALSE(misses({4, 0.02f, 1}, {5, 1, 2})) << "touched";
        EXPECT_FALSE(misses({-1, -1, 0}, {1, 1, 2})) << "around the start";
        // Without tmax, culling relies on the directions.
        for (Ray& ray : rays) ray.tmax = endless;
    }
}

TEST(PacketBounds, KnowsNothingOfRaysThatBeginBeforeTheirOrigins) {
    std::vector<Ray> rays = bundle();
    rays[5].tmin = -1.0f;
    const PacketBounds reach(boxes_of(rays));
    EXPECT_FALSE(reach.misses(Bounds{{-20, -1, 0}, {-19, 1, 2}}));
    PlanePrim behind;
    behind.plane = {{1, 0, 0}, -5.0};
    EXPECT_FALSE(reach.misses(behind));
    EXPECT_FALSE(reach.empty());
    EXPECT_TRUE(PacketBounds(RayBoxes{}).empty());
}

} // namespace
} // namespace glint
