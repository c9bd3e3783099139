// Surface points and normals of hits, and rays that start there.

#include "worlds.h"

#include "math/offset.shared.h"
#include "trace/world/data.h"

#include <gtest/gtest.h>

#include <functional>

namespace glint {

using geometry::make_sphere;
using trace::Affine;
using trace::Hit;
using trace::Quadric;
using trace::World;
using trace::WorldInput;
namespace {

TEST(Surface, OfATriangleIsInItsPlane) {
    WorldInput input;
    input.meshes = {square(3, 9.0f)};
    World world = world_of(input);
    const Ray ray = ray_from({0.3f, 0.6f, 0}, {0, 0, 1});
    SurfacePoint at = world.surface(ray, world.closest(ray));
    EXPECT_NEAR(at.p.x, 0.3f, at.p_error.x);
    EXPECT_NEAR(at.p.y, 0.6f, at.p_error.y);
    EXPECT_EQ(at.p.z, 9.0f);
    EXPECT_EQ(at.n, vec3(0, 0, 1)) << "by winding, not toward the ray";
    EXPECT_LT(at.p_error.x, 2e-6f);
    input.meshes[0].flip = true;
    world = world_of(input);
    at = world.surface(ray, world.closest(ray));
    EXPECT_EQ(at.n, vec3(0, 0, -1));
}

TEST(Surface, OfAWideTriangleHasTheErrorOfThePointNotOfTheTriangle) {
    WorldInput input;
    input.meshes = {square(3, 0)};
    input.meshes[0].wide = true;
    for (vec3& p : input.meshes[0].positions) {
        p = (p - vec3(0.5f, 0.25f, 0)) * 0x1p23f;
        p.z = p.x * 0.25f - p.y * 0.5f;
    }
    const World world = world_of(input);
    const dvec3 normal = glm::normalize(dvec3(-0.25, 0.5, 1));
    Numbers random(5);
    for (int i = 0; i < 1000; ++i) {
        const vec3 target = vec3(random.point());
        const Ray ray = ray_from(target + vec3(0, 0, 3), {0, 0, -1});
        const Hit hit = world.closest(ray);
        ASSERT_TRUE(hit);
        const SurfacePoint at = world.surface(ray, hit);
        EXPECT_NEAR(at.p.x, target.x, 1e-6f);
        EXPECT_LT(std::abs(glm::dot(dvec3(at.p), normal)), 2e-7);
        EXPECT_LT(at.p_error.x, 4e-7f);
        const vec3 up(random.direction() + normal * 1.1);
        EXPECT_FALSE(world.closest(ray_from(offset_ray_origin(at.p, at.p_error, at.n, up), up)));
        EXPECT_FALSE(world.occluded(ray_from(offset_ray_origin(at.p, at.p_error, at.n, up), up)));
    }
}

TEST(Surface, OfQuadricsHasOutwardNormals) {
    WorldInput input;
    input.quadrics.push_back({0, 7, make_sphere({1, 2, 3}, 2.0)});
    input.quadrics.push_back({1, 0, geometry::make_cylinder({10, 0, 0}, {1, 0, 0}, 4.0, 1.0)});
    input.planes.push_back({2, {0, 0, 5}, -20.0});
    const World world = world_of(input);

    const Ray through_sphere = ray_from({1, 2, -3}, {0, 0, 1});
    std::vector<Hit> hits;
    world.all_hits(through_sphere, hits);
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_EQ(world.surface(through_sphere, hits[0]).p, vec3(1, 2, 1));
    EXPECT_EQ(world.surface(through_sphere, hits[0]).n, vec3(0, 0, -1));
    EXPECT_EQ(world.surface(through_sphere, hits[1]).p, vec3(1, 2, 5));
    EXPECT_EQ(world.surface(through_sphere, hits[1]).n, vec3(0, 0, 1));

    const Ray along_cylinder = ray_from({5, 0.5f, 0}, {1, 0, 0});
    world.all_hits(along_cylinder, hits);
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_EQ(world.surface(along_cylinder, hits[0]).p, vec3(10, 0.5f, 0));
    EXPECT_EQ(world.surface(along_cylinder, hits[0]).n, vec3(-1, 0, 0));
    EXPECT_EQ(world.surface(along_cylinder, hits[1]).p, vec3(14, 0.5f, 0));
    EXPECT_EQ(world.surface(along_cylinder, hits[1]).n, vec3(1, 0, 0));

    const Ray to_side = ray_from({12, 5, 0}, {0, -1, 0});
    const SurfacePoint side = world.surface(to_side, world.closest(to_side));
    EXPECT_EQ(side.p, vec3(12, 1, 0));
    EXPECT_EQ(side.n, vec3(0, 1, 0));

    const Ray to_plane = ray_from({-9, 5, 0}, {0, 0, -1});
    const SurfacePoint plane = world.surface(to_plane, world.closest(to_plane));
    EXPECT_EQ(plane.p, vec3(-9, 5, -4));
    EXPECT_EQ(plane.n, vec3(0, 0, 1)) << "as given, of unit length";
}

TEST(Surface, OfAStretchedSphereIsAnEllipsoid) {
    // Half axes 2, 1, 1/2 about (5, 0, 0).
    WorldInput input;
    dmat4 m(1.0);
    m[0] = dvec4(2, 0, 0, 0);
    m[2] = dvec4(0, 0, 0.5, 0);
    m[3] = dvec4(5, 0, 0, 1);
    input.world_from_local = {m};
    input.quadrics.push_back({0, 0, make_sphere({0, 0, 0}, 1.0), 0});
    const World world = world_of(input);
    EXPECT_NEAR(world.bounds().lo.x, 3.0f, 1e-6f);
    EXPECT_NEAR(world.bounds().hi.z, 0.5f, 1e-6f);
    Numbers random(2);
    for (int i = 0; i < 10'000; ++i) {
        const dvec3 goal = dvec3(5, 0, 0) + random.point() * 0.3;
        const dvec3 from = dvec3(5, 0, 0) + random.direction() * 4.0;
        const Ray ray = ray_from(vec3(from), vec3(goal - from));
        const Hit hit = world.closest(ray);
        ASSERT_TRUE(hit);
        const SurfacePoint at = world.surface(ray, hit);
        const dvec3 p = dvec3(at.p) - dvec3(5, 0, 0);
        ASSERT_NEAR(p.x * p.x / 4 + p.y * p.y + p.z * p.z * 4, 1.0, 2e-6);
        const dvec3 n = glm::normalize(dvec3(p.x / 4, p.y, p.z * 4));
        ASSERT_LT(glm::length(n - dvec3(at.n)), 3e-6);
        const dvec3 on_ray = dvec3(ray.origin) + dvec3(ray.direction) * double(hit.t);
        ASSERT_LT(glm::length(on_ray - dvec3(at.p)), 3e-6);
    }
}

/// Rays from the first hit of a ray, to the given side of the surface at all angles.
class Spawning {
  public:
    Spawning(WorldInput input, std::uint64_t seed) : world_(world_of(std::move(input))), random_(seed) {}

    const World& world() const { return world_; }

    /// A ray from the surface that was met, or tmax = 0 if there was none. side: 1 outward, -1 inward.
    Ray next(const dvec3& about, double reach, double side) {
        const dvec3 from = about + random_.direction() * reach * 3.0;
        const dvec3 goal = about + random_.point() * reach;
        Ray ray = ray_from(vec3(from), vec3(goal - from));
        const Hit hit = world_.closest(ray);
        if (!hit) {
            ray.tmax = 0.0f;
            return ray;
        }
        const SurfacePoint at = world_.surface(ray, hit);
        const dvec3 n(at.n);
        const dvec3 d = random_.direction();
        // Heights above the surface from a right angle down to 10^-6: below, the side is lost in the rounding
        // of n.
        const double height = std::pow(10.0, -0.001 * random_.below(6001));
        const vec3 w(d - n * glm::dot(d, n) + n * (side * height));
        return ray_from(offset_ray_origin(at.p, at.p_error, at.n, w), w);
    }

    double number() { return random_(); }
    dvec3 point() { return random_.point(); }
    dvec3 direction() { return random_.direction(); }

  private:
    World world_;
    Numbers random_;
};

constexpr int worlds = 200;
constexpr int rays = 1000;

/// Whether p is at the rim or the apex of a cone, where within its error it may be inside of one part of the
/// surface and outside of the next.
bool at_sharp_edge(const World& world, const vec3& p) {
    const Quadric& quadric = world.data().quadrics.front();
    const QuadricShape& cone = quadric.shape;
    if (cone.kind != quadric_cone) return false;
    const bool local = quadric.affine >= 0;
    const Affine affine = local ? world.data().affines.front() : Affine{};
    const dvec3 v = affine.inverse * (dvec3(p) - affine.translation) - cone.base;
    const double h = glm::dot(cone.axis, v);
    const double radial = glm::length(v - cone.axis * h);
    const double to_rim = glm::length(dvec2(h, radial - cone.radius));
    const double to_apex = glm::length(dvec2(cone.height - h, radial));
    // The world's float coordinates in the cone's local space.
    double rounding = 1e-4 * cone.radius;
    for (int column = 0; local && column < 3; ++column)
        rounding += 1e-5 * glm::length(affine.inverse[column]);
    return std::min(to_rim, to_apex) < rounding;
}

/// Counts rays that hit their own surface again: outward never, inward at most once (on the way out).
void expect_spawned_rays_leave(const std::function<WorldInput(Numbers&, dvec3&, double&)>& make, double side,
                               std::size_t expected) {
    Numbers random(17);
    int failures = 0;
    int spawned = 0;
    for (int i = 0; i < worlds; ++i) {
        dvec3 about;
        double reach;
        Spawning spawning(make(random, about, reach), static_cast<std::uint64_t>(i));
        std::vector<Hit> hits;
        for (int k = 0; k < rays; ++k) {
            const Ray ray = spawning.next(about, reach, side);
            if (ray.tmax == 0.0f) continue;
            if (side < 0 && expected > 0 && at_sharp_edge(spawning.world(), ray.origin)) continue;
            ++spawned;
            spawning.world().all_hits(ray, hits);
            if (hits.size() != expected && failures++ == 0)
                ADD_FAILURE() << "world " << i << " ray " << k << " has " << hits.size() << " hits";
        }
    }
    EXPECT_EQ(failures, 0) << "of " << spawned;
    EXPECT_GT(spawned, worlds * rays / 4);
}

WorldInput some_sphere(Numbers& random, dvec3& about, double& reach) {
    const double size = std::pow(10.0, 6.0 * random());
    about = random.point() * size * std::pow(10.0, 3.0 * random());
    reach = size;
    WorldInput input;
    input.quadrics.push_back({0, 0, make_sphere(about, size)});
    return input;
}

WorldInput some_ellipsoid(Numbers& random, dvec3& about, double& reach) {
    WorldInput input;
    dmat4 m(1.0);
    for (int column = 0; column < 3; ++column) m[column] = dvec4(random.point(), 0.0);
    about = random.point() * 30.0;
    m[3] = dvec4(about, 1.0);
    reach = 1.0;
    input.world_from_local = {m};
    input.quadrics.push_back({0, 0, make_sphere({0, 0, 0}, 1.0), 0});
    return input;
}

WorldInput some_cylinder(Numbers& random, dvec3& about, double& reach) {
    const double size = std::pow(10.0, 6.0 * random());
    const dvec3 base = random.point() * size * std::pow(10.0, 2.0 * random());
    const dvec3 axis = random.direction();
    WorldInput input;
    input.quadrics.push_back({0, 0, geometry::make_cylinder(base, axis, size * 2.0, size * 0.7)});
    about = base + axis * size;
    reach = size;
    return input;
}

WorldInput some_disk(Numbers& random, dvec3& about, double& reach) {
    const double size = std::pow(10.0, 6.0 * random());
    about = random.point() * size * std::pow(10.0, 3.0 * random());
    reach = size;
    WorldInput input;
    input.quadrics.push_back({0, 0, geometry::make_disk(about, random.direction(), size)});
    return input;
}

WorldInput some_cone(Numbers& random, dvec3& about, double& reach) {
    const double size = std::pow(10.0, 6.0 * random());
    const dvec3 base = random.point() * size * std::pow(10.0, 2.0 * random());
    const dvec3 axis = random.direction();
    WorldInput input;
    input.quadrics.push_back({0, 0, geometry::make_cone(base, axis, size * 2.0, size * 0.7)});
    about = base + axis * size * 0.6;
    reach = size;
    return input;
}

/// A disk and a cone in local space.
WorldInput some_squeezed(const QuadricShape& shape, Numbers& random, dvec3& about, double& reach) {
    WorldInput input = some_ellipsoid(random, about, reach);
    input.quadrics.front().shape = shape;
    return input;
}

WorldInput some_plane(Numbers& random, dvec3& about, double& reach) {
    const double size = std::pow(10.0, 6.0 * random());
    about = random.point() * size * std::pow(10.0, 3.0 * random());
    reach = size;
    const dvec3 normal = random.point();
    WorldInput input;
    input.planes.push_back({0, normal, glm::dot(normal, about)});
    return input;
}

TEST(Sphere, SpawnedRayNeverReintersects) {
    expect_spawned_rays_leave(some_sphere, 1.0, 0);
    expect_spawned_rays_leave(some_ellipsoid, 1.0, 0);
}

TEST(Sphere, RayIntoItLeavesOnce) {
    expect_spawned_rays_leave(some_sphere, -1.0, 1);
    expect_spawned_rays_leave(some_ellipsoid, -1.0, 1);
}

TEST(Cylinder, SpawnedRayNeverReintersects) { expect_spawned_rays_leave(some_cylinder, 1.0, 0); }

TEST(Cylinder, RayIntoItLeavesOnce) { expect_spawned_rays_leave(some_cylinder, -1.0, 1); }

TEST(Disk, SpawnedRayNeverReintersects) {
    const auto squeezed = [](Numbers& random, dvec3& about, double& reach) {
        return some_squeezed(geometry::make_disk({0, 0, 0}, {0, 0, 1}, 1.0), random, about, reach);
    };
    for (const double side : {1.0, -1.0}) {
        expect_spawned_rays_leave(some_disk, side, 0);
        expect_spawned_rays_leave(squeezed, side, 0);
    }
}

WorldInput some_squeezed_cone(Numbers& random, dvec3& about, double& reach) {
    return some_squeezed(geometry::make_cone({0, 0, -0.5}, {0, 0, 1}, 1.5, 0.9), random, about, reach);
}

TEST(Cone, SpawnedRayNeverReintersects) {
    expect_spawned_rays_leave(some_cone, 1.0, 0);
    expect_spawned_rays_leave(some_squeezed_cone, 1.0, 0);
}

TEST(Cone, RayIntoItLeavesOnce) {
    expect_spawned_rays_leave(some_cone, -1.0, 1);
    expect_spawned_rays_leave(some_squeezed_cone, -1.0, 1);
}

TEST(Plane, SpawnedRayNeverReintersects) {
    expect_spawned_rays_leave(some_plane, 1.0, 0);
    expect_spawned_rays_leave(some_plane, -1.0, 0);
}

} // namespace
} // namespace glint
