// Enumerating hits: next() and all_hits().

#include "worlds.h"

#include "geometry/polyhedron.h"

#include <gtest/gtest.h>

namespace glint {

using trace::Hit;
using trace::PrimKind;
using trace::World;
using trace::WorldInput;
namespace {

/// closest(), then next() until there is none.
std::vector<Hit> walk(const World& world, const Ray& ray) {
    std::vector<Hit> hits;
    for (Hit hit = world.closest(ray); hit; hit = world.next(ray, hit)) hits.push_back(hit);
    return hits;
}

void expect_walk_is_crossings(const World& world, const Ray& ray) {
    std::vector<Hit> all;
    world.all_hits(ray, all);
    const std::vector<Hit> walked = walk(world, ray);
    ASSERT_EQ(walked.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(walked[i].t, all[i].t);
        EXPECT_EQ(walked[i].object, all[i].object);
        EXPECT_EQ(walked[i].prim, all[i].prim);
        EXPECT_EQ(walked[i].u, all[i].u);
    }
}

/// A stack of squares z = 1, 2, …
WorldInput pile(int count) {
    WorldInput input;
    for (int i = 1; i <= count; ++i) input.meshes.push_back(square(static_cast<std::uint32_t>(i), float(i)));
    return input;
}

TEST(Crossings, ComeInOrder) {
    const World world = world_of(pile(20));
    const Ray ray = ray_from({0.75f, 0.25f, 0}, {0, 0, 1});
    const std::vector<Hit> hits = walk(world, ray);
    ASSERT_EQ(hits.size(), 20u);
    for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(hits[i].t, static_cast<float>(i + 1));
    expect_walk_is_crossings(world, ray);
}

TEST(Crossings, EndAtTmax) {
    const World world = world_of(pile(20));
    Ray ray = ray_from({0.75f, 0.25f, 0}, {0, 0, 1});
    ray.tmin = 3.0f;
    ray.tmax = 7.0f;
    EXPECT_EQ(walk(world, ray).size(), 3u);
    expect_walk_is_crossings(world, ray);
}

TEST(Crossings, AreNotSoughtBehindOneThatEndsTheSearch) {
    const World world = world_of(pile(20));
    const Ray ray = ray_from({0.75f, 0.25f, 0}, {0, 0, 1});
    std::vector<Hit> hits;
    int asked = 0;
    const auto ends_at = [&](std::uint32_t object) {
        return [&asked, object](const Hit& hit) { return ++asked, hit.object == object; };
    };
    EXPECT_FALSE(world.all_hits(ray, hits, ends_at(7)));
    EXPECT_LE(asked, 20);
    asked = 0;
    EXPECT_TRUE(world.all_hits(ray, hits, ends_at(99)));
    EXPECT_EQ(asked, 20);
    EXPECT_EQ(hits.size(), 20u);
}

TEST(Crossings, OfASharedEdgeCountOnce) {
    const World world = world_of(pile(3));
    const Ray ray = ray_from({0.5f, 0.5f, 0}, {0, 0, 1});
    EXPECT_TRUE(world.closest(ray).on_edge);
    EXPECT_EQ(walk(world, ray).size(), 3u);
    expect_walk_is_crossings(world, ray);
}

TEST(Crossings, OfASharedVertexCountOnce) {
    // A fan of 17 triangles around (0, 0, 1).
    WorldInput input;
    input.meshes.resize(1);
    WorldInput::Triangles& fan = input.meshes[0];
    fan.positions.emplace_back(0, 0, 1);
    for (std::uint32_t i = 0; i < 17; ++i) {
        const double angle = 0.369599 * i;
        fan.positions.emplace_back(std::cos(angle), std::sin(angle), 1.25);
        fan.triangles.emplace_back(0, 1 + i, 1 + (i + 1) % 17);
    }
    const World world = world_of(input);
    for (const vec3& from : {vec3(0, 0, 0), vec3(0, 0, 2), vec3(0.125f, -0.25f, 0), vec3(1, 2, 9)}) {
        const Ray ray = ray_from(from, vec3(0, 0, 1) - from);
        EXPECT_EQ(walk(world, ray).size(), 1u);
        expect_walk_is_crossings(world, ray);
    }
}

TEST(Crossings, OfTwoMeshesAtOnePlaceCountForEach) {
    WorldInput input;
    input.meshes = {square(1, 2.0f), square(2, 2.0f)};
    const World world = world_of(input);
    const Ray ray = ray_from({0.5f, 0.5f, 0}, {0, 0, 1});
    const std::vector<Hit> hits = walk(world, ray);
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_EQ(hits[0].object, 1u);
    EXPECT_EQ(hits[1].object, 2u);
    expect_walk_is_crossings(world, ray);
}

TEST(Crossings, OfAThinWallCountBothFaces) {
    // A box thinner than the tolerance of t: its faces differ in facing, also at edges.
    WorldInput input;
    const geometry::Polyhedron box = geometry::make_box({0, 0, 1000}, {2, 2, 1e-3});
    input.meshes.resize(1);
    for (const dvec3& p : box.positions) input.meshes[0].positions.push_back(vec3(p));
    input.meshes[0].triangles = box.triangles;
    const World world = world_of(input);
    for (const vec3& target : {vec3(0, 0, 1000), vec3(0.5f, 0.25f, 1000), vec3(0.5f, 0.5f, 1000)}) {
        const Ray ray = ray_from({target.x, target.y, 0}, {0, 0, 1});
        EXPECT_EQ(walk(world, ray).size(), 2u);
        expect_walk_is_crossings(world, ray);
    }
}

TEST(Crossings, OfASphereSmallerThanTheSpacingOfTAreTwo) {
    // At t = 2^24 floats are 2 apart; the ray still enters and leaves.
    WorldInput input;
    input.quadrics.push_back({3, 0, geometry::make_sphere({0, 0, 16777216.0}, 0.25)});
    const World world = world_of(input);
    const Ray ray = ray_from({0, 0, 0}, {0, 0, 1});
    const std::vector<Hit> hits = walk(world, ray);
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_EQ(hits[0].t, hits[1].t);
    EXPECT_LT(world.surface(ray, hits[0]).n.z, 0.0f) << "first the way in";
    EXPECT_GT(world.surface(ray, hits[1]).n.z, 0.0f);
    expect_walk_is_crossings(world, ray);
}

TEST(Crossings, FromInsideAreOneForAConvexSolid) {
    WorldInput input;
    input.quadrics.push_back({0, 0, geometry::make_sphere({0, 0, 0}, 1.0)});
    input.quadrics.push_back({1, 0, geometry::make_cylinder({0, 0, -1}, {0, 0, 1}, 2.0, 1.0)});
    const World world = world_of(input);
    Numbers random(3);
    for (int i = 0; i < 10'000; ++i) {
        const Ray ray = ray_from(vec3(random.point() * 0.5), vec3(random.direction()));
        ASSERT_EQ(walk(world, ray).size(), 2u) << "one out of each";
        expect_walk_is_crossings(world, ray);
    }
}

TEST(Crossings, AreRealWherePlacesAreCrowded) {
    // Many overlapping meshes and quadrics, rays through shared vertices.
    Numbers random(4);
    WorldInput input;
    for (std::uint32_t k = 0; k < 6; ++k) {
        const geometry::Polyhedron shape =
            geometry::make_icosahedron(glm::round(random.point() * 2.0) * 0.25, 1.0);
        WorldInput::Triangles mesh;
        mesh.object = k;
        for (const dvec3& p : shape.positions) mesh.positions.push_back(vec3(p));
        mesh.triangles = shape.triangles;
        input.meshes.push_back(mesh);
        input.quadrics.push_back(
            {10 + k, k, geometry::make_sphere(glm::round(random.point() * 2.0) * 0.25, 0.75)});
    }
    const World world = world_of(input);
    for (int i = 0; i < 5000; ++i) {
        const auto& mesh = input.meshes[random.below(6)];
        const vec3 goal = mesh.positions[random.below(12)];
        const vec3 from = i % 2 == 0 ? vec3(goal.x, goal.y, -4) : vec3(random.point() * 3.0);
        expect_walk_is_crossings(world, ray_from(from, goal - from));
    }
}

TEST(Precedes, OrdersByDistanceObjectPrimitiveThenWayIn) {
    Hit a;
    a.t = 1;
    a.object = 2;
    a.prim = 3;
    a.kind = PrimKind::quadric;
    Hit b = a;
    EXPECT_FALSE(precedes(a, b));
    b.u = 1;
    EXPECT_TRUE(precedes(a, b));
    EXPECT_FALSE(precedes(b, a));
    b.prim = 2;
    EXPECT_TRUE(precedes(b, a));
    b.object = 3;
    EXPECT_TRUE(precedes(a, b));
    b.t = 0.5f;
    EXPECT_TRUE(precedes(b, a));
}

} // namespace
} // namespace glint
