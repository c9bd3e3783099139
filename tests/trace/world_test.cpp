// Queries of a World against closed forms.

#include "worlds.h"

#include "geometry/polyhedron.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <stdexcept>

namespace glint {

using geometry::make_cone;
using geometry::make_cylinder;
using geometry::make_sphere;
using trace::Hit;
using trace::PrimKind;
using trace::World;
using trace::WorldInput;
using trace::WorldStats;
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

TEST(World, WithoutAnythingIsMissed) {
    const World made;
    const World built = world_of({});
    for (const World* world : {&made, &built}) {
        const Ray ray;
        std::vector<Hit> hits{Hit{}};
        EXPECT_FALSE(world->closest(ray));
        EXPECT_FALSE(world->occluded(ray));
        EXPECT_FALSE(world->next(ray, {}));
        world->all_hits(ray, hits);
        EXPECT_TRUE(hits.empty());
        EXPECT_TRUE(world->bounds().empty());
        EXPECT_EQ(world->stats().triangles, 0u);
    }
}

TEST(World, FindsASingleTriangle) {
    WorldInput input;
    input.meshes = {square(4, 2.0f)};
    input.meshes[0].triangles.pop_back();
    const World world = world_of(input);
    const Hit hit = world.closest(ray_from({0.75f, 0.25f, 0}, {0, 0, 1}));
    ASSERT_EQ(hit.kind, PrimKind::triangle);
    EXPECT_EQ(hit.t, 2.0f);
    EXPECT_EQ(hit.u, 0.5f);
    EXPECT_EQ(hit.v, 0.25f);
    EXPECT_EQ(hit.object, 4u);
    EXPECT_EQ(hit.prim, 0u);
    EXPECT_FALSE(world.closest(ray_from({0.25f, 0.75f, 0}, {0, 0, 1})));
    EXPECT_EQ(world.bounds().lo, vec3(0, 0, 2));
    EXPECT_EQ(world.bounds().hi, vec3(1, 1, 2));
}

/// A plane, a sphere, a cylinder and a square behind one another on the z axis.
WorldInput one_of_each() {
    WorldInput input;
    input.meshes = {square(3, 9.0f)};
    input.quadrics.push_back({1, 5, make_sphere({0.25, 0.5, 3}, 1.0)});
    input.quadrics.push_back({2, 0, make_cylinder({0.25, 0.5, 5}, {0, 0, 1}, 2.0, 1.0)});
    input.planes.push_back({0, {0, 0, 4}, 4.0});
    return input;
}

TEST(World, KeepsTheOrderAlongTheRay) {
    const World world = world_of(one_of_each());
    std::vector<Hit> hits;
    world.all_hits(ray_from({0.25f, 0.5f, 0}, {0, 0, 1}), hits);
    ASSERT_EQ(hits.size(), 6u);
    const float t[] = {1, 2, 4, 5, 7, 9};
    const std::uint32_t object[] = {0, 1, 1, 2, 2, 3};
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(hits[i].t, t[i]);
        EXPECT_EQ(hits[i].object, object[i]);
    }
    EXPECT_EQ(hits[1].prim, 5u) << "a sphere has the number it was given";
    const WorldStats stats = world.stats();
    EXPECT_EQ(stats.triangles, 2u);
    EXPECT_EQ(stats.quadrics[quadric_sphere], 1u);
    EXPECT_EQ(stats.quadrics[quadric_cylinder], 1u);
    EXPECT_EQ(stats.planes, 1u);
    EXPECT_EQ(world.bounds().hi.z, 9.0f);
}

TEST(World, TakesBothBoundsOfARayAsExclusive) {
    const World world = world_of(one_of_each());
    Ray ray = ray_from({0.25f, 0.5f, 0}, {0, 0, 1});
    for (const float t : {1.0f, 2.0f, 4.0f, 5.0f, 7.0f, 9.0f}) {
        ray.tmin = std::nextafter(t, 0.0f);
        ray.tmax = std::nextafter(t, infinity);
        EXPECT_EQ(world.closest(ray).t, t);
        EXPECT_TRUE(world.occluded(ray));
        ray.tmin = t;
        EXPECT_FALSE(world.closest(ray)) << t;
        EXPECT_FALSE(world.occluded(ray)) << t;
        ray.tmin = std::nextafter(t, 0.0f);
        ray.tmax = t;
        EXPECT_FALSE(world.closest(ray)) << t;
        EXPECT_FALSE(world.occluded(ray)) << t;
    }
}

TEST(World, LooksBehindTheOriginWhereTminIsNegative) {
    const World world = world_of(one_of_each());
    Ray ray = ray_from({0.25f, 0.5f, 10}, {0, 0, 1});
    ray.tmin = -infinity;
    ray.tmax = 0.0f;
    EXPECT_EQ(world.closest(ray).t, -9.0f);
}

TEST(World, BreaksTiesByObjectThenPrimitive) {
    WorldInput input;
    input.meshes = {square(9, 2.0f), square(5, 2.0f)};
    input.planes.push_back({7, {0, 0, 1}, 2.0});
    const Ray ray = ray_from({0.75f, 0.25f, 0}, {0, 0, 1});
    EXPECT_EQ(world_of(input).closest(ray).object, 5u);
    input.planes[0].object = 2;
    EXPECT_EQ(world_of(input).closest(ray).object, 2u);
    input.planes[0].object = 6;
    input.quadrics.push_back({4, 8, make_sphere({0.75, 0.25, 3}, 1.0)});
    input.quadrics.push_back({4, 2, make_sphere({0.75, 0.25, 3}, 1.0)});
    const Hit hit = world_of(input).closest(ray);
    EXPECT_EQ(hit.object, 4u);
    EXPECT_EQ(hit.prim, 2u);
    // The diagonal belongs to both triangles of a square: the first one has it.
    EXPECT_EQ(world_of(input).closest(ray_from({0.5f, 0.5f, 1.5f}, {0, 0, 1})).prim, 0u);
}

TEST(World, TellsAHundredThousandEqualTrianglesApart) {
    WorldInput input;
    input.meshes = {square(0, 2.0f)};
    input.meshes[0].triangles.assign(100'000, uvec3(0, 1, 2));
    const World world = world_of(input);
    const Ray ray = ray_from({0.75f, 0.25f, 0}, {0, 0, 1});
    EXPECT_EQ(world.closest(ray).prim, 0u);
    EXPECT_TRUE(world.occluded(ray));
    const Hit second = world.next(ray, world.closest(ray));
    EXPECT_EQ(second.prim, 1u);
    std::vector<Hit> hits;
    world.all_hits(ray, hits);
    EXPECT_EQ(hits.size(), 100'000u);
}

TEST(World, IsNotHitByRaysThatAreNone) {
    const World world = world_of(one_of_each());
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<Hit> hits;
    for (const float bad : {nan, infinity, -infinity})
        for (int i = 0; i < 6; ++i) {
            Ray ray = ray_from({0.25f, 0.5f, 0}, {0, 0, 1});
            (i < 3 ? ray.origin : ray.direction)[i % 3] = bad;
            EXPECT_FALSE(world.closest(ray)) << bad << " " << i;
            EXPECT_FALSE(world.closest_brute_force(ray)) << bad << " " << i;
            EXPECT_FALSE(world.occluded(ray)) << bad << " " << i;
            world.all_hits(ray, hits);
            EXPECT_TRUE(hits.empty()) << bad << " " << i;
        }
    Ray ray = ray_from({0.25f, 0.5f, 0}, {0, 0, 0});
    EXPECT_FALSE(world.closest(ray)) << "without a direction";
    ray.direction.z = 1.0f;
    ray.tmin = nan;
    EXPECT_FALSE(world.closest(ray));
    ray.tmin = 0.0f;
    ray.tmax = nan;
    EXPECT_FALSE(world.closest(ray));
    EXPECT_FALSE(world.occluded(ray));
    ray.tmax = -1.0f;
    EXPECT_FALSE(world.closest(ray)) << "tmax below tmin";
}

TEST(World, LeavesOutTrianglesThatAreNotFinite) {
    WorldInput input;
    input.meshes = {square(0, 2.0f)};
    input.meshes[0].positions[1].x = infinity;
    const World world = world_of(input);
    EXPECT_FALSE(world.closest(ray_from({0.75f, 0.25f, 0}, {0, 0, 1})));
    EXPECT_EQ(world.closest(ray_from({0.25f, 0.75f, 0}, {0, 0, 1})).prim, 1u)
        << "numbers stay those of the file";
}

TEST(World, RefusesAnIndexOutOfRange) {
    WorldInput input;
    input.meshes = {square(0, 2.0f)};
    input.meshes[0].triangles[1].z = 4;
    try {
        world_of(input);
        FAIL() << "it was taken";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "a triangle names a vertex that its mesh does not have");
    }
}

TEST(World, BuildsTheSameOnAnyNumberOfThreads) {
    Numbers random(5);
    WorldInput input;
    input.meshes.resize(2);
    for (std::uint32_t i = 0; i < 40'000; ++i) {
        WorldInput::Triangles& mesh = input.meshes[i % 2];
        mesh.object = i % 2;
        const dvec3 p = random.point();
        const std::uint32_t first = static_cast<std::uint32_t>(mesh.positions.size());
        for (int k = 0; k < 3; ++k) mesh.positions.push_back(vec3(p + random.point() * 0.05));
        mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
    const World one = world_of(input, 1);
    const World seven = world_of(input, 7);
    EXPECT_EQ(one.stats().nodes, seven.stats().nodes);
    EXPECT_EQ(one.stats().depth, seven.stats().depth);
    for (int i = 0; i < 20'000; ++i) {
        const Ray ray = ray_from(vec3(random.point() * 2.0), vec3(random.point()));
        const Hit a = one.closest(ray);
        const Hit b = seven.closest(ray);
        ASSERT_EQ(std::bit_cast<std::uint32_t>(a.t), std::bit_cast<std::uint32_t>(b.t));
        ASSERT_EQ(a.object, b.object);
        ASSERT_EQ(a.prim, b.prim);
    }
}

TEST(World, HasTheSameBitsAtAnyPowerOfTwo) {
    Numbers random(6);
    int found = 0;
    for (int round = 0; round < 2000; ++round) {
        const dvec3 axis = random.direction();
        const dvec3 center = random.point();
        const dvec3 normal = random.point();
        const dvec3 local = random.point() * 0.2;
        const Ray ray = ray_from(vec3(random.point() * 3.0), vec3(random.point()));
        const auto build = [&](double scale) {
            WorldInput input;
            dmat4 m(1.0);
            m[0] = dvec4(dvec3(1, 0.2, 0.1) * scale, 0);
            m[1] = dvec4(dvec3(-0.3, 0.7, 0.2) * scale, 0);
            m[2] = dvec4(dvec3(0.1, 0.2, 1.3) * scale, 0);
            m[3] = dvec4(center * -0.7 * scale, 1);
            input.world_from_local = {m};
            input.quadrics.push_back({0, 0, make_sphere(center * scale, 0.5 * scale)});
            input.quadrics.push_back({1, 0, make_sphere(local, 0.4), 0});
            input.quadrics.push_back(
                {2, 0, make_cylinder(center * 0.5 * scale, axis, 1.1 * scale, 0.3 * scale)});
            input.quadrics.push_back({4, 0, geometry::make_disk(center * 0.8 * scale, axis, 0.6 * scale)});
            input.quadrics.push_back(
                {5, 0, make_cone(center * -0.4 * scale, axis, 0.9 * scale, 0.5 * scale)});
            input.quadrics.push_back({6, 0, make_cone(local, axis, 0.6, 0.3), 0});
            input.planes.push_back({3, normal, 0.3 * scale});
            return world_of(input);
        };
        std::vector<Hit> hits;
        build(1.0).all_hits(ray, hits);
        for (const int k : {-30, 30}) {
            const float scale = std::ldexp(1.0f, k);
            const World world = build(scale);
            const Ray scaled = ray_from(ray.origin * scale, ray.direction);
            std::vector<Hit> others;
            world.all_hits(scaled, others);
            ASSERT_EQ(others.size(), hits.size());
            const World unit = build(1.0);
            for (std::size_t i = 0; i < hits.size(); ++i) {
                ++found;
                ASSERT_EQ(others[i].t, hits[i].t * scale);
                const SurfacePoint a = unit.surface(ray, hits[i]);
                const SurfacePoint b = world.surface(scaled, others[i]);
                ASSERT_EQ(b.p, a.p * scale);
                ASSERT_EQ(b.p_error, a.p_error * scale);
                ASSERT_EQ(b.n, a.n);
            }
        }
    }
    EXPECT_GT(found, 2000);
}

TEST(World, HasTheSameBitsInAMirrorAndWithAxesExchanged) {
    Numbers random(8);
    int found = 0;
    const auto mirrored = [](const auto& v) { return std::decay_t<decltype(v)>(-v.x, v.y, v.z); };
    const auto exchanged = [](const auto& v) { return std::decay_t<decltype(v)>(v.y, v.x, v.z); };
    const auto compare = [&](const auto& turn) {
        for (int round = 0; round < 2000; ++round) {
            WorldInput input;
            WorldInput turned;
            input.meshes.resize(1);
            for (std::uint32_t i = 0; i < 12; ++i) {
                input.meshes[0].positions.push_back(vec3(random.point()));
                if (i % 3 == 0) input.meshes[0].triangles.emplace_back(i, i + 1, i + 2);
            }
            const dvec3 center = random.point();
            const dvec3 axis = random.direction();
            turned.meshes = input.meshes;
            for (vec3& p : turned.meshes[0].positions) p = turn(p);
            input.quadrics.push_back({1, 0, make_sphere(center, 0.5)});
            turned.quadrics.push_back({1, 0, make_sphere(turn(center), 0.5)});
            input.quadrics.push_back({2, 0, make_cylinder(-center, axis, 0.9, 0.3)});
            turned.quadrics.push_back({2, 0, make_cylinder(turn(-center), turn(axis), 0.9, 0.3)});
            const dvec3 across = random.direction();
            input.quadrics.push_back({4, 0, geometry::make_disk(center * 0.5, across, 0.4)});
            turned.quadrics.push_back({4, 0, geometry::make_disk(turn(center * 0.5), turn(across), 0.4)});
            input.quadrics.push_back({5, 0, make_cone(center * -0.3, across, 0.8, 0.5)});
            turned.quadrics.push_back({5, 0, make_cone(turn(center * -0.3), turn(across), 0.8, 0.5)});
            input.planes.push_back({3, axis, 0.2});
            turned.planes.push_back({3, turn(axis), 0.2});
            const Ray ray = ray_from(vec3(random.point() * 3.0), vec3(random.point()));
            const Ray turned_ray = ray_from(turn(ray.origin), turn(ray.direction));
            const World a = world_of(input);
            const World b = world_of(turned);
            std::vector<Hit> hits;
            std::vector<Hit> others;
            a.all_hits(ray, hits);
            b.all_hits(turned_ray, others);
            ASSERT_EQ(hits.size(), others.size());
            for (std::size_t i = 0; i < hits.size(); ++i) {
                ++found;
                ASSERT_EQ(hits[i].t, others[i].t);
                ASSERT_EQ(hits[i].u, others[i].u);
                ASSERT_EQ(hits[i].object, others[i].object);
                const SurfacePoint p = a.surface(ray, hits[i]);
                const SurfacePoint q = b.surface(turned_ray, others[i]);
                ASSERT_EQ(q.p, turn(p.p));
                ASSERT_EQ(q.p_error, glm::abs(turn(p.p_error)));
                // Mirroring reverses the winding, and with it the normals of triangles.
                ASSERT_EQ(q.n, turn(p.n) * (hits[i].kind == PrimKind::triangle ? -1.0f : 1.0f));
            }
        }
    };
    compare(mirrored);
    compare(exchanged);
    EXPECT_GT(found, 2000);
}

} // namespace
} // namespace glint
