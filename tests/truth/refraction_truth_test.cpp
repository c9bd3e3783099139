// Light through glass: Snell's law in slabs and balls, total reflection, the rainbow, absorption.

#include "scene_kit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glint {
namespace {

using namespace kit;

constexpr double degree = pi / 180;

/// One unit thick, its upper side at z = 0. No wider than needed: origins of rays keep a distance from
/// triangles in proportion to their size.
SceneDescription slab(double index) {
    SceneDescription scene = empty_scene();
    add(scene, PolyhedronShape{PolyhedronKind::box, Vec3(0, 0, -0.5), Vec3(2.5, 2.5, 1)}, glass(index));
    return scene;
}

/// Distance of a point from the line through `origin` along the unit vector `d`.
double distance_from_line(const vec3& point, const Vec3& origin, const Vec3& d) {
    const Vec3 v = Vec3(point) - origin;
    return glm::length(v - d * glm::dot(v, d));
}

TEST(G3, ASlabBendsBySnellsLawAndShiftsTheRayAside) {
    const double degrees[] = {30, 45, 60, 80};
    const double refracted[] = {19.471221, 28.125506, 35.264390, 41.036411};
    const double shift[] = {0.1938138, 0.3291423, 0.5124720, 0.8336639};
    for (int i = 0; i < 4; ++i) {
        const double a = degrees[i] * degree;
        const Vec3 in(std::sin(a), 0, -std::cos(a));
        // Beside the diagonal of the slab's face: points exactly on edges are moved a little.
        const Vec3 eye = Vec3(0, 0.1, 0) - in;
        const Look seen = look(slab(1.5), eye, in);
        ASSERT_EQ(seen.tree.nodes.size(), 3u);
        const double inside = angle_between(seen.node(1).direction, vec3(0, 0, -1));
        EXPECT_NEAR(inside, std::asin(std::sin(a) / 1.5), 1e-6);
        EXPECT_NEAR(inside / degree, refracted[i], 1e-4);
        EXPECT_NEAR(angle_between(seen.node(2).direction, vec3(in)), 0, 1e-6);
        EXPECT_NEAR(distance_from_line(seen.node(2).origin, eye, in), shift[i], shift[i] * 1e-5);
    }
}

TEST(G3, RefractedRaysStayInThePlaneOfIncidence) {
    for (unsigned i = 0; i < 20; ++i) {
        const dvec3 d(rotation(i)[0]);
        if (d.z > -0.5) continue;
        const Look seen = look(slab(1.5), -d, d);
        ASSERT_EQ(seen.tree.nodes.size(), 3u);
        const vec3 across = normalize(cross(vec3(d), vec3(0, 0, 1)));
        EXPECT_NEAR(dot(across, seen.node(1).direction), 0, 1e-6);
    }
}

TEST(G3b, ReflectionIsTotalBeyondTheCriticalAngle) {
    const double indices[] = {1.1, 1.33, 1.5, 2.4};
    const double critical[] = {65.380023, 48.753467, 41.810315, 24.624318};
    for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(std::asin(1 / indices[i]) / degree, critical[i], 1e-6);
        for (const double side : {-1e-4, 1e-4}) {
            const double a = std::asin(1 / indices[i]) + side;
            SceneDescription scene = slab(indices[i]);
            scene.render.background = Vec3(1);
            scene.whitted.max_depth = 1;
            const Look seen = look(scene, Vec3(0, 0, -0.5), Vec3(std::sin(a), 0, std::cos(a)));
            const rendering::RayNode& node = seen.node(0);
            EXPECT_EQ(node.total_reflection, side > 0) << indices[i] << " " << side;
            EXPECT_EQ(node.refracted_weight, side > 0 ? 0.0f : 1.0f);
            EXPECT_EQ(node.reflected_weight, side > 0 ? 1.0f : 0.0f);
            // What leaves meets the background; what stays ends at the depth limit inside, in the dark.
            EXPECT_EQ(seen.light, vec3(side > 0 ? 0.0f : 1.0f));
        }
    }
}

TEST(G5, ABallTurnsRaysByItsImpact) {
    const double impact[] = {0, .25, .5, .9};
    const double degrees[] = {0, 9.766888, 21.057559, 54.576339};
    SceneDescription scene = empty_scene();
    add(scene, SphereShape{}, glass(1.5));
    for (int i = 0; i < 4; ++i) {
        const double b = impact[i];
        const double exact = 2 * (std::asin(b) - std::asin(b / 1.5));
        EXPECT_NEAR(exact / degree, degrees[i], 1e-6);
        const Look seen = look(scene, Vec3(-3, b, 0), Vec3(1, 0, 0));
        ASSERT_EQ(seen.tree.nodes.size(), 3u);
        EXPECT_NEAR(angle_between(seen.node(2).direction, vec3(1, 0, 0)), exact, 1e-5) << b;
    }
}

/// The deviation in radians of light that enters a drop, is reflected once inside, and leaves.
double rainbow_deviation(const SceneDescription& scene, double degrees) {
    const double b = std::sin(degrees * degree);
    const Look seen = look(scene, Vec3(-3, b, 0), Vec3(1, 0, 0));
    const int inner = seen.node(static_cast<std::size_t>(seen.node(0).refracted)).reflected;
    const int out = seen.node(static_cast<std::size_t>(inner)).refracted;
    return angle_between(seen.node(static_cast<std::size_t>(out)).direction, vec3(1, 0, 0));
}

TEST(G5b, TheRainbowStandsWhereOneInnerReflectionDeviatesLeast) {
    SceneDescription scene = empty_scene();
    scene.whitted.max_depth = 3;
    Material water = glass(4.0 / 3);
    water.fresnel = true;
    add(scene, SphereShape{}, water);
    double least = 10, at = 0;
    for (double degrees = 55; degrees < 64; degrees += 0.05) {
        const double deviation = rainbow_deviation(scene, degrees);
        const double i = degrees * degree;
        EXPECT_NEAR(deviation, pi + 2 * i - 4 * std::asin(std::sin(i) * 0.75), 1e-5);
        if (deviation < least) {
            least = deviation;
            at = degrees;
        }
    }
    EXPECT_NEAR(least, 137.970341 * degree, 1e-3);
    EXPECT_NEAR(rainbow_deviation(scene, 59.391102), 137.970341 * degree, 1e-5);
    EXPECT_NEAR(at, 59.391102, 0.5);
}

/// What a ball of index `index` with σ = .5 leaves of the background along a ray of impact b.
double through_ball(double index, double impact) {
    SceneDescription scene = empty_scene();
    scene.render.background = Vec3(1);
    Material m = glass(index);
    m.absorption = Vec3(0.5);
    add(scene, SphereShape{}, m);
    return look(scene, Vec3(-3, impact, 0), Vec3(1, 0, 0)).light.y;
}

TEST(G12, LightDecaysExponentiallyOnItsWayThroughABall) {
    EXPECT_NEAR(through_ball(1, 0), 0.3678794, 0.3678794e-6);
    EXPECT_NEAR(through_ball(1, 0), std::exp(-1.0), std::exp(-1.0) * 1e-6);
    EXPECT_NEAR(through_ball(1, 0.5), std::exp(-std::sqrt(0.75)), 0.4206200e-6);
    EXPECT_NEAR(through_ball(1.5, 0.5), std::exp(-std::sqrt(8.0) / 3), 0.3895321e-6);
}

} // namespace
} // namespace glint
