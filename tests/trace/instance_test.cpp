// Instances give the bits of brute force over all of them; invalid transforms are rejected.

#include "trace/world/instance_tree.h"
#include "traced.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace glint::tracing {

using trace::InstanceTree;
using trace::MeshInstance;
using trace::MeshTree;
namespace {

/// In [-1, 1), a function of both.
float around_zero(std::uint32_t key, std::uint32_t index) { return 2 * draw(key, index) - 1; }

/// Rotated, sheared, mirrored, of sizes between 2^-spread and 1, within the cube [-reach, reach]^3.
Transform random_transform(std::uint32_t key, float reach, int spread) {
    Transform transform;
    const int smaller = static_cast<int>(draw(key, 20) * static_cast<float>(spread + 1));
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column)
            transform.m[row][column] =
                std::ldexp(around_zero(key, static_cast<std::uint32_t>(3 * row + column)), -smaller);
        // Never nearly singular.
        transform.m[row][row] += std::ldexp(draw(key, 21) < 0.5f ? 2.0f : -2.0f, -smaller);
        transform.m[row][3] = reach * around_zero(key, 10 + static_cast<std::uint32_t>(row));
    }
    return transform;
}

/// `count` instances of two meshes, the first few duplicated.
std::vector<Instance> random_instances(const std::vector<Mesh>& meshes, std::uint32_t seed,
                                       std::uint32_t count, float reach, int spread) {
    std::vector<Instance> instances;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t key = seed * 100000 + (i % 11 == 10 ? i - 10 : i);
        instances.push_back({meshes[key % meshes.size()], random_transform(key, reach, spread)});
    }
    return instances;
}

/// Rays from random origins, half of them to the centre of an instance.
std::vector<Ray> rays_at(const std::vector<Instance>& instances, std::uint32_t seed, std::uint32_t count,
                         float reach) {
    std::vector<Ray> rays;
    for (std::uint32_t i = 0; i < count; ++i) {
        Ray ray;
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            ray.origin[axis] = 2 * reach * around_zero(seed, 8 * i + axis);
            ray.direction[axis] = around_zero(seed, 8 * i + 3 + axis);
            if (i % 2 == 0) {
                const auto& row = instances[i * 7 % instances.size()].world_from_local.m[axis];
                ray.direction[axis] = (row[0] + row[1] + row[2]) * 0.5f + row[3] - ray.origin[axis];
            }
        }
        if (i % 16 == 3) ray.direction = {0, 0, draw(seed, i) < 0.5f ? -1.0f : 1.0f};
        if (i % 16 == 5) ray.tmax = reach;
        if (i % 16 == 7) ray.tmin = reach;
        if (i % 128 == 9) ray.direction[1] = std::numeric_limits<float>::quiet_NaN();
        if (i % 128 == 11) ray.origin[1] = std::numeric_limits<float>::infinity();
        if (i % 128 == 13) ray.direction = {0, 0, 0};
        rays.push_back(ray);
    }
    return rays;
}

glint::Ray inner(const Ray& ray) {
    return {vec3(ray.origin[0], ray.origin[1], ray.origin[2]), ray.tmin,
            vec3(ray.direction[0], ray.direction[1], ray.direction[2]), ray.tmax};
}

Ray outer(const glint::Ray& ray) {
    return {{ray.origin.x, ray.origin.y, ray.origin.z},
            ray.tmin,
            {ray.direction.x, ray.direction.y, ray.direction.z},
            ray.tmax};
}

/// Used only to transform rays to local space.
InstanceTree arithmetic_of(const std::vector<Instance>& instances) {
    static const MeshTree nothing;
    std::vector<MeshInstance> tree_instances;
    for (const Instance& instance : instances) {
        MeshInstance tree_instance;
        tree_instance.mesh = &nothing;
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                tree_instance.linear[column][row] =
                    instance.world_from_local
                        .m[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
            tree_instance.translation[row] = instance.world_from_local.m[static_cast<std::size_t>(row)][3];
        }
        tree_instances.push_back(tree_instance);
    }
    parallel::TaskPool pool(1);
    return {tree_instances, pool};
}

/// The least (t, instance, triangle) by testing every instance.
InstanceHit brute_force(const std::vector<Instance>& instances, const InstanceTree& arithmetic,
                        const Ray& ray) {
    InstanceHit best;
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        const Hit hit = instances[i].mesh.closest(outer(arithmetic.to_local(i, inner(ray))));
        if (hit && hit.t < best.t) best = {hit.t, hit.u, hit.v, hit.triangle, i};
    }
    return best;
}

bool same(const InstanceHit& a, const InstanceHit& b) {
    return same_bits(Hit{a.t, a.u, a.v, a.triangle}, Hit{b.t, b.u, b.v, b.triangle}) &&
           a.instance == b.instance;
}

void expect_brute_force(const std::vector<Instance>& instances, const std::vector<Ray>& rays) {
    const Scene scene(instances, {.threads = 2});
    const InstanceTree arithmetic = arithmetic_of(instances);
    std::vector<InstanceHit> wanted;
    std::size_t found = 0;
    for (const Ray& ray : rays) {
        wanted.push_back(brute_force(instances, arithmetic, ray));
        found += wanted.back() ? 1 : 0;
    }
    EXPECT_GT(found, rays.size() / 10);
    EXPECT_LT(found, rays.size());
    std::vector<InstanceHit> hits(rays.size());
    std::vector<std::uint8_t> blocked(rays.size());
    for (const RayHint hint : hints) {
        scene.closest(rays, hits, hint);
        scene.occluded(rays, blocked, hint);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            EXPECT_TRUE(same(hits[i], wanted[i])) << "ray " << i << " in a batch";
            EXPECT_TRUE(same(scene.closest(rays[i]), wanted[i])) << "ray " << i << " alone";
            EXPECT_EQ(blocked[i], wanted[i] ? 1 : 0) << "ray " << i << " in a batch";
            EXPECT_EQ(scene.occluded(rays[i]), bool(wanted[i])) << "ray " << i << " alone";
        }
    }
}

std::vector<Mesh> two_meshes() {
    std::vector<Mesh> meshes;
    for (std::uint32_t seed = 1; seed <= 2; ++seed) {
        const Soup soup = make_soup(seed, 60 * seed);
        meshes.emplace_back(soup.xyz, soup.corners);
    }
    return meshes;
}

TEST(Instances, GiveTheBitsOfBruteForce) {
    const std::vector<Mesh> meshes = two_meshes();
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        const std::vector<Instance> instances = random_instances(meshes, seed, 40 * seed, 6, 3);
        expect_brute_force(instances, rays_at(instances, seed, 2000, 6));
    }
}

TEST(Instances, ThousandsOfThemGiveTheBitsOfBruteForce) {
    const std::vector<Mesh> meshes = two_meshes();
    const std::vector<Instance> instances = random_instances(meshes, 9, 4000, 100, 2);
    expect_brute_force(instances, rays_at(instances, 9, 600, 100));
}

TEST(Instances, FarAwayTheirBoxesStillHoldThem) {
    const std::vector<Mesh> meshes = two_meshes();
    const std::vector<Instance> instances = random_instances(meshes, 5, 60, 1e6f, 0);
    expect_brute_force(instances, rays_at(instances, 5, 2000, 1e6f));
}

TEST(Instances, SqueezedOnesAreHitAsBruteForceHitsThem) {
    const std::vector<Mesh> meshes = two_meshes();
    std::vector<Instance> instances = random_instances(meshes, 6, 40, 6, 0);
    for (std::size_t i = 0; i < instances.size(); ++i)
        for (float& entry : instances[i].world_from_local.m[i % 3]) entry *= i % 2 == 0 ? 1e-4f : 1.0f;
    expect_brute_force(instances, rays_at(instances, 6, 3000, 6));
}

TEST(Instances, BoxesLetThroughWhatRoundingBringsToTheirEdges) {
    // A cube, rotated and then squeezed along the world's z, which amplifies rounding in local space along
    // the world's x and y. One corner is extreme along x.
    constexpr float turn[3][3] = {
        {2.0f / 3, -1.0f / 3, 2.0f / 3}, {2.0f / 3, 2.0f / 3, -1.0f / 3}, {-1.0f / 3, 2.0f / 3, 2.0f / 3}};
    constexpr float squeeze[3] = {1, 1, 1e-5f};
    const std::vector<float> xyz{-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1,
                                 -1, -1, 1,  1, -1, 1,  1, 1, 1,  -1, 1, 1};
    const std::vector<std::uint32_t> corners{0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                             1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
    Instance cube{Mesh(xyz, corners), {}};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            cube.world_from_local.m[row][column] = squeeze[row] * turn[row][column];
    const std::array<float, 2> furthest{5.0f / 3, -1.0f / 3};
    // Another behind it, so that the tree has a node.
    Instance behind = cube;
    behind.world_from_local.m[2][3] = -50;
    std::vector<Ray> rays;
    for (std::uint32_t i = 0; i < 5000; ++i) {
        Ray ray;
        ray.origin = {3 * around_zero(1, 5 * i), 3 * around_zero(1, 5 * i + 1), 10};
        for (std::uint32_t axis = 0; axis < 2; ++axis)
            ray.direction[axis] = furthest[axis] + 0.1f * around_zero(1, 5 * i + 2 + axis) - ray.origin[axis];
        ray.direction[2] = -10;
        rays.push_back(ray);
    }
    expect_brute_force({cube, behind}, rays);
}

TEST(Instances, OfEqualOnesTheFirstIsHit) {
    const Soup soup = make_soup(3, 50);
    const std::vector<Instance> instances(500, Instance{Mesh(soup.xyz, soup.corners), {}});
    const Scene scene(instances);
    const std::vector<Ray> rays = make_rays(soup, 3, 300);
    for (const Ray& ray : rays) {
        const Hit wanted = brute_force(soup, ray);
        const InstanceHit hit = scene.closest(ray);
        EXPECT_TRUE(same_bits(Hit{hit.t, hit.u, hit.v, hit.triangle}, wanted));
        EXPECT_EQ(hit.instance, wanted ? 0u : none);
    }
    EXPECT_EQ(scene.stats().instances, 500u);
    EXPECT_EQ(scene.stats().meshes, 1u);
    EXPECT_LT(scene.stats().bytes, instances[0].mesh.stats().bytes + 500 * 300);
}

TEST(Instances, AMovedMeshIsHitWhereItWasMovedTo) {
    const std::vector<float> xyz{-1, -1, 0, 1, -1, 0, 0, 1, 0};
    const std::vector<std::uint32_t> corners{0, 1, 2};
    Instance instance{Mesh(xyz, corners), {}};
    // Scaled by 2, x to y, y to -x, then translated.
    instance.world_from_local.m = {{{0, -2, 0, 10}, {2, 0, 0, 20}, {0, 0, 2, 30}}};
    const Scene scene(std::span(&instance, 1));
    Ray ray;
    ray.origin = {10, 20, 0};
    ray.direction = {0, 0, 4};
    const InstanceHit hit = scene.closest(ray);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit.t, 7.5f);
    EXPECT_EQ(hit.instance, 0u);
    EXPECT_EQ(hit.u, 0.25f);
    EXPECT_EQ(hit.v, 0.5f);
    EXPECT_NEAR(scene.bounds().lo[0], 8, 1e-3);
    EXPECT_NEAR(scene.bounds().hi[1], 22, 1e-3);
}

TEST(Instances, NoneOrEmptyOnesAreHitByNothing) {
    for (const Scene& scene : {Scene(), Scene(std::vector<Instance>{}), Scene(std::vector<Instance>(3))}) {
        const std::vector<Ray> rays(70);
        std::vector<InstanceHit> hits(rays.size(), InstanceHit{1, 1, 1, 1, 1});
        std::vector<std::uint8_t> blocked(rays.size(), 1);
        scene.closest(rays, hits, RayHint::coherent);
        scene.occluded(rays, blocked, RayHint::coherent);
        EXPECT_TRUE(same(hits[69], InstanceHit{}));
        EXPECT_EQ(blocked[69], 0);
        EXPECT_FALSE(scene.closest(Ray{}));
        EXPECT_FALSE(scene.occluded(Ray{}));
        EXPECT_GT(scene.bounds().lo[0], scene.bounds().hi[0]);
    }
}

TEST(Instances, KeepTheirMeshesAlive) {
    const Soup soup = make_soup(4, 50);
    Scene scene;
    {
        const Mesh mesh(soup.xyz, soup.corners);
        scene = Scene(std::vector<Instance>{{mesh, {}}});
    }
    for (const Ray& ray : make_rays(soup, 4, 200))
        EXPECT_EQ(scene.closest(ray).triangle, brute_force(soup, ray).triangle);
}

TEST(Instances, PlacesThatAreNoneAreRefused) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const Soup soup = make_soup(1, 10);
    const Mesh mesh(soup.xyz, soup.corners);
    const Transform good;
    Transform flat = good, doubled = good, squeezed = good, far = good, nowhere = good, undefined = good;
    flat.m[2][2] = 0;
    doubled.m[2] = doubled.m[1];
    squeezed.m[0][0] = 1e-7f;
    far.m[0][3] = infinity;
    nowhere.m[1][1] = nan;
    undefined.m[1][3] = nan;
    const Transform all_bad[] = {flat, doubled, squeezed, far, nowhere, undefined};
    for (std::size_t i = 0; i < std::size(all_bad); ++i) {
        const std::vector<Instance> instances{{mesh, good}, {mesh, all_bad[i]}};
        EXPECT_THROW(Scene{instances}, std::invalid_argument) << i;
    }
    Transform huge = good;
    for (std::size_t axis = 0; axis < 3; ++axis) huge.m[axis][axis] = 3e38f;
    const std::vector<float> large{0, 0, 0, 9, 0, 0, 0, 9, 0};
    const std::vector<Instance> beyond{{Mesh(large, std::vector<std::uint32_t>{0, 1, 2}), huge}};
    EXPECT_THROW(Scene{beyond}, std::invalid_argument);
}

TEST(Instances, BatchesOfDifferentLengthsAreRefused) {
    const Scene scene;
    const std::vector<Ray> rays(3);
    std::vector<InstanceHit> hits(2);
    std::vector<std::uint8_t> blocked(4);
    EXPECT_THROW(scene.closest(rays, hits, RayHint::coherent), std::invalid_argument);
    EXPECT_THROW(scene.occluded(rays, blocked, RayHint::coherent), std::invalid_argument);
}

} // namespace
} // namespace glint::tracing
