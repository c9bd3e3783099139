// Instances of meshes in a World: stored once, with the results of baked copies.

#include "worlds.h"

#include "geometry/surface.shared.h"
#include "math/offset.shared.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace glint {

using trace::Hit;
using trace::World;
using trace::WorldInput;
using trace::WorldStats;
namespace {

WorldInput::SharedMesh shared(std::vector<vec3> positions, std::vector<uvec3> triangles) {
    return {std::make_shared<const std::vector<vec3>>(std::move(positions)),
            std::make_shared<const std::vector<uvec3>>(std::move(triangles))};
}

WorldInput::SharedMesh shared_square() {
    WorldInput::Triangles mesh = square(0, 0.0f);
    return shared(mesh.positions, mesh.triangles);
}

/// A convex closed mesh about the origin, outward: 2 rings (rings - 1) · 2 triangles.
WorldInput::SharedMesh shared_ball(std::uint32_t rings) {
    const std::uint32_t around = 2 * rings;
    std::vector<vec3> positions{{0, 0, 1}};
    for (std::uint32_t i = 1; i < rings; ++i)
        for (std::uint32_t j = 0; j < around; ++j) {
            const double theta = std::numbers::pi * i / rings;
            const double phi = 2 * std::numbers::pi * j / around;
            positions.emplace_back(
                dvec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)));
        }
    positions.emplace_back(0.0f, 0.0f, -1.0f);
    const auto last = static_cast<std::uint32_t>(positions.size()) - 1;
    std::vector<uvec3> triangles;
    for (std::uint32_t j = 0; j < around; ++j) {
        const std::uint32_t next = (j + 1) % around;
        triangles.emplace_back(0, 1 + j, 1 + next);
        triangles.emplace_back(last, last - around + next, last - around + j);
        for (std::uint32_t i = 0; i + 2 < rings; ++i) {
            const std::uint32_t a = 1 + i * around;
            triangles.emplace_back(a + j, a + around + j, a + next);
            triangles.emplace_back(a + next, a + around + j, a + around + next);
        }
    }
    return shared(std::move(positions), std::move(triangles));
}

/// Rotated, sheared, stretched by up to 8 : 1, mirrored half the time.
dmat4 any_transform(Numbers& random, const dvec3& at, double size) {
    dmat3 linear(1.0);
    for (int column = 0; column < 3; ++column) {
        linear[column] = random.point() * 0.5;
        linear[column][column] += (random() < 0 ? -1.0 : 1.0) * std::exp2(1.5 * random());
    }
    dmat4 m(linear * size);
    m[3] = dvec4(at, 1.0);
    return m;
}

dmat4 moved_by(const dvec3& by) {
    dmat4 m(1.0);
    m[3] = dvec4(by, 1.0);
    return m;
}

WorldInput::Triangles baked(const WorldInput::SharedMesh& mesh, const WorldInput::Instance& instance) {
    WorldInput::Triangles triangles;
    triangles.object = instance.object;
    for (const vec3& p : *mesh.positions)
        triangles.positions.push_back(vec3(dvec3(instance.world_from_mesh * dvec4(dvec3(p), 1.0))));
    triangles.triangles = *mesh.triangles;
    triangles.flip = instance.flip;
    return triangles;
}

TEST(WorldInstances, ThousandTakeTheMemoryOfOne) {
    WorldInput input;
    input.shared_meshes = {shared_ball(50)};
    input.instances.push_back({0, 0, dmat4(1.0), false});
    const WorldStats one = world_of(input).stats();
    EXPECT_EQ(one.triangles, 9800u);
    for (std::uint32_t i = 1; i < 1000; ++i)
        input.instances.push_back({i, 0, moved_by(dvec3(i, 0, 0)), false});
    const WorldStats thousand = world_of(input).stats();
    EXPECT_EQ(thousand.triangles, 9'800'000u);
    EXPECT_LT(thousand.bytes, 3 * one.bytes);
}

TEST(WorldInstances, AreHitWhereTheyStandInTheOrderOfObjects) {
    WorldInput input;
    input.shared_meshes = {shared_square()};
    input.meshes = {square(5, 2.0f)};
    input.instances = {{9, 0, moved_by({0, 0, 2}), false}, {3, 0, moved_by({0, 0, 2}), false}};
    const World world = world_of(input);
    const Ray ray = ray_from({0.75f, 0.25f, 0}, {0, 0, 1});
    std::vector<Hit> hits;
    world.all_hits(ray, hits);
    ASSERT_EQ(hits.size(), 3u);
    EXPECT_EQ(hits[0].object, 3u);
    EXPECT_EQ(hits[1].object, 5u);
    EXPECT_EQ(hits[2].object, 9u);
    EXPECT_EQ(world.closest(ray).object, 3u);
    EXPECT_EQ(world.closest(ray).t, 2.0f);
    EXPECT_EQ(world.next(ray, hits[0]).object, 5u);
    EXPECT_EQ(world.next(ray, hits[1]).object, 9u);
    EXPECT_FALSE(world.next(ray, hits[2]));
    input.instances[1].object = 6;
    EXPECT_EQ(world_of(input).closest(ray).object, 5u);
    EXPECT_EQ(world.stats().triangles, 6u);
}

TEST(WorldInstances, ASharedEdgeIsCrossedOnce) {
    dmat4 quarter(1.0);
    quarter[0] = {0, 2, 0, 0};
    quarter[1] = {-2, 0, 0, 0};
    quarter[3] = {3, 1, 4, 1};
    WorldInput input;
    input.shared_meshes = {shared_square()};
    input.instances = {{0, 0, moved_by({0, 0, 2}), false}, {1, 0, quarter, false}};
    const World world = world_of(input);
    std::vector<Hit> hits;
    world.all_hits(ray_from({0.5f, 0.5f, 0}, {0, 0, 1}), hits);
    ASSERT_EQ(hits.size(), 1u) << "the diagonal";
    EXPECT_TRUE(hits[0].on_edge);
    const Ray ray = ray_from({2, 2, 0}, {0, 0, 1});
    world.all_hits(ray, hits);
    ASSERT_EQ(hits.size(), 1u) << "the diagonal of what is turned";
    EXPECT_TRUE(world.closest(ray).on_edge);
    EXPECT_FALSE(world.next(ray, hits[0]));
}

TEST(WorldInstances, HaveTheSurfacesOfBakedOnes) {
    Numbers random(3);
    std::size_t found = 0;
    std::size_t inner = 0;
    for (std::uint32_t i = 0; i < 200; ++i) {
        WorldInput placed;
        placed.shared_meshes = {shared_ball(6)};
        const double size = std::exp2(10 * random());
        const dvec3 at = random.point() * size * 4.0;
        placed.instances = {{0, 0, any_transform(random, at, size), i % 3 == 0}};
        WorldInput world_space;
        world_space.meshes = {baked(placed.shared_meshes[0], placed.instances[0])};
        const World instance = world_of(placed);
        const World mesh = world_of(world_space);
        for (int k = 0; k < 100; ++k) {
            const dvec3 from = at + random.direction() * size * 6.0;
            const Ray ray = ray_from(vec3(from), vec3(at + random.point() * size - from));
            const Hit hit = instance.closest(ray);
            const Hit same = mesh.closest(ray);
            if (!hit || hit.prim != same.prim) continue;
            ++found;
            const SurfacePoint a = instance.surface(ray, hit);
            const SurfacePoint b = mesh.surface(ray, same);
            EXPECT_LT(glm::length(dvec3(a.n) - dvec3(b.n)), 1e-4) << "world " << i;
            EXPECT_NEAR(glm::length(dvec3(a.n)), 1.0, 1e-6);
            // Near an edge each keeps off it by its own error, so the two may differ there.
            const bool is_inner = std::min({hit.u, hit.v, 1 - hit.u - hit.v}) > max_edge_weight + 1e-6;
            inner += is_inner ? 1 : 0;
            EXPECT_LT(glm::length(dvec3(a.p) - dvec3(b.p)), (is_inner ? 2e-5 : 2e-3) * size);
            EXPECT_LT(glm::length(dvec3(a.p_error)), 1e-4 * size);
        }
    }
    EXPECT_GT(found, 10'000u);
    EXPECT_GT(inner, found / 2);
}

/// Rays that leave the ball on the given side must cross it `expected` times more.
void expect_leave(double side, std::size_t expected, double far, int max_condition) {
    Numbers random(17);
    std::size_t spawned = 0, failures = 0;
    for (int i = 0; i < 150; ++i) {
        const double size = std::exp2(16 * random());
        const dvec3 at = random.point() * size * std::exp2(far * (1 + random()) / 2);
        WorldInput input;
        input.shared_meshes = {shared_ball(5 + random.below(12))};
        dmat4 m = any_transform(random, at, size);
        m[i % 3] *= std::exp2(-static_cast<int>(random.below(static_cast<std::uint32_t>(max_condition) + 1)));
        input.instances = {{0, 0, m, false}};
        const World world = world_of(input);
        std::vector<Hit> hits;
        for (int k = 0; k < 600; ++k) {
            const dvec3 from = at + random.direction() * size * 6.0;
            const dvec3 goal = dvec3(m * dvec4(random.point() * 0.9, 1.0));
            const Ray ray = ray_from(vec3(from), vec3(goal - from));
            const Hit hit = world.closest(ray);
            if (!hit) continue;
            const SurfacePoint p = world.surface(ray, hit);
            const dvec3 n = glm::dot(dvec3(p.n), dvec3(ray.direction)) < 0 ? dvec3(p.n) : -dvec3(p.n);
            const dvec3 d = random.direction();
            const double height = std::pow(10.0, -0.001 * random.below(4001));
            const vec3 w(d - n * glm::dot(d, n) + n * (side * height));
            world.all_hits(ray_from(offset_ray_origin(p.p, p.p_error, p.n, w), w), hits);
            ++spawned;
            if (hits.size() != expected && failures++ == 0)
                ADD_FAILURE() << "world " << i << " ray " << k << " has " << hits.size() << " hits";
        }
    }
    EXPECT_EQ(failures, 0u) << "of " << spawned;
    EXPECT_GT(spawned, 30'000u);
}

TEST(WorldInstances, SpawnedRaysNeverMeetTheirSurfaceAgain) {
    expect_leave(1.0, 0, 0, 0);
    expect_leave(1.0, 0, 12, 0);
    expect_leave(1.0, 0, 6, 6);
}

TEST(WorldInstances, RaysIntoThemLeaveOnce) {
    expect_leave(-1.0, 1, 0, 0);
    expect_leave(-1.0, 1, 6, 3);
}

TEST(WorldInstances, TooSqueezedToBePlacedAreBaked) {
    dmat4 flat(1.0);
    flat[2][2] = 1e-9;
    flat[3] = {0, 0, 2, 1};
    WorldInput input;
    input.shared_meshes = {shared_ball(8)};
    input.instances = {{4, 0, moved_by({0, 0, 9}), false}, {7, 0, flat, true}};
    const World world = world_of(input);
    const Ray ray = ray_from({0.1f, 0.2f, 0}, {0, 0, 1});
    const Hit hit = world.closest(ray);
    EXPECT_EQ(hit.object, 7u);
    EXPECT_EQ(hit.t, 2.0f);
    EXPECT_GT(std::abs(world.surface(ray, hit).n.z), 0.99f);
    std::vector<Hit> hits;
    world.all_hits(ray_from({0.1f, 0.2f, 5}, {0, 0, 1}), hits);
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_EQ(hits[0].object, 4u);
}

TEST(WorldInstances, OfDenormalSizeAreHit) {
    for (const double size : {1e-20, 1e-30, 1e-39, 1e-42}) {
        WorldInput input;
        input.shared_meshes = {shared_ball(6)};
        dmat4 m(size);
        m[3] = dvec4(0, 0, 0, 1);
        input.instances = {{0, 0, m, false}};
        const World world = world_of(input);
        EXPECT_TRUE(world.closest(ray_from({0, 0, 1}, {0, 0, -1}))) << size;
        EXPECT_TRUE(world.occluded(ray_from(vec3(0, 0, static_cast<float>(5 * size)), {0, 0, -1}))) << size;
    }
}

TEST(WorldInstances, FillTheBounds) {
    WorldInput input;
    input.shared_meshes = {shared_square()};
    input.instances = {{0, 0, moved_by({1, 2, 3}), false}, {1, 0, moved_by({-4, 0, 0}), false}};
    const Bounds bounds = world_of(input).bounds();
    EXPECT_LT(glm::length(bounds.lo - vec3(-4, 0, 0)), 1e-4f);
    EXPECT_LT(glm::length(bounds.hi - vec3(2, 3, 3)), 1e-4f);
}

TEST(WorldInstances, OfWhatThereIsNotAreRefused) {
    WorldInput input;
    input.shared_meshes = {shared_square()};
    input.instances = {{0, 1, dmat4(1.0), false}};
    EXPECT_THROW(world_of(input), std::invalid_argument);
    input.instances[0].mesh = 0;
    input.shared_meshes[0] = shared({vec3(0.0f)}, {uvec3(0, 0, 1)});
    EXPECT_THROW(world_of(input), std::invalid_argument);
    input.shared_meshes[0] = {};
    EXPECT_THROW(world_of(input), std::invalid_argument);
}

} // namespace
} // namespace glint
