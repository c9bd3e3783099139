// Mirror and refracted rays: weights, directions, Fresnel, absorption, depth (docs/light-model.md).

#include "scene_kit.h"

#include "math/trig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glint::rendering {
namespace {

using namespace kit;

TEST(Reflection, AddsRhoTimesWhatTheMirrorDirectionSees) {
    SceneDescription scene = in_sky(Vec3(0.5, 1, 2));
    add(scene, PlaneShape{}, mirror(0.25));
    const Look seen = look(scene, Vec3(-3, 0, 4), Vec3(3, 0, -4));
    EXPECT_EQ(seen.light, vec3(0.125f, 0.25f, 0.5f));
    EXPECT_EQ(seen.terms[Term::reflection], seen.light);
    EXPECT_NEAR(angle_between(seen.node(1).direction, vec3(3, 0, 4)), 0, 1e-7);
    EXPECT_EQ(seen.counts.reflected, 1u);
    EXPECT_EQ(seen.counts.refracted, 0u);
}

TEST(Reflection, IsNotColouredByTheMaterial) {
    Material m = mirror(1);
    m.color = Vec3(1, 0, 0);
    SceneDescription scene = in_sky();
    add(scene, PlaneShape{}, m);
    EXPECT_EQ(look(scene, Vec3(0, 0, 1), Vec3(0, 0, -1)).light, vec3(1.0f));
}

TEST(Reflection, FallsBackToTheGeometricNormalWhereItWouldGoBelowTheSurface) {
    Mesh mesh;
    mesh.positions = {{0, -9, -9}, {0, 9, -9}, {0, 0, 9}};
    mesh.normals.assign(3, glm::normalize(glm::vec3(0.3f, -1, 0)));
    mesh.triangles = {{0, 1, 2}};
    SceneDescription scene = in_sky();
    add(scene, mesh_of(mesh), mirror());
    const Look seen = look(scene, Vec3(1, 2, 0), Vec3(-1, -2, 0));
    ASSERT_EQ(seen.tree.nodes.size(), 2u);
    EXPECT_NEAR(angle_between(seen.node(1).direction, vec3(1, -2, 0)), 0, 1e-6);
    EXPECT_EQ(seen.light, vec3(1.0f));
}

TEST(Transmission, APaneGoesStraightOnWithTauOnce) {
    Material m = glass(2.4, 0.75);
    m.absorption = Vec3(5);
    m.fresnel = true;
    Mesh open = box_mesh(Vec3(0, 0, 0), Vec3(2));
    open.triangles.resize(open.triangles.size() - 1);
    const TriangleShape triangle{{Vec3(-9, -9, 0), Vec3(9, -9, 0), Vec3(0, 9, 0)}};
    for (const Shape& shape : {Shape(PlaneShape{}), Shape(triangle)}) {
        SceneDescription scene = in_sky();
        add(scene, shape, m);
        const Look seen = look(scene, Vec3(-1, 0, 1), Vec3(1, 0, -1));
        EXPECT_EQ(seen.light, vec3(0.75f));
        EXPECT_EQ(seen.node(1).direction, seen.node(0).direction);
        EXPECT_EQ(seen.node(0).reflected_weight, 0);
    }
    SceneDescription scene = in_sky();
    add(scene, mesh_of(open), m);
    const Look seen = look(scene, Vec3(-3, 0.1, 0.2), Vec3(1, 0.1, 0));
    EXPECT_EQ(seen.light, vec3(0.75f * 0.75f));
    EXPECT_EQ(seen.tree.nodes.back().direction, seen.node(0).direction);
}

TEST(Transmission, BendsOnEntryAndExit) {
    SceneDescription scene = in_sky();
    add(scene, SphereShape{}, glass(1.5, 0.5));
    const Look seen = look(scene, Vec3(-3, 0.5, 0), Vec3(1, 0, 0));
    ASSERT_EQ(seen.tree.nodes.size(), 3u);
    EXPECT_EQ(seen.light, vec3(0.25f));
    const RayNode& in = seen.node(0);
    const RayNode& out = seen.node(1);
    EXPECT_TRUE(in.entering);
    EXPECT_FALSE(out.entering);
    EXPECT_EQ(in.index_before, 1);
    EXPECT_EQ(in.index_after, 1.5f);
    EXPECT_EQ(out.index_before, 1.5f);
    EXPECT_EQ(out.index_after, 1);
    for (const RayNode* node : {&in, &out}) {
        const vec3 next = node == &in ? seen.node(1).direction : seen.node(2).direction;
        const double before = std::sin(angle_between(node->direction, -node->geometric_normal));
        const double after = std::sin(angle_between(next, -node->geometric_normal));
        EXPECT_NEAR(node->index_before * before, node->index_after * after, 1e-6);
    }
}

TEST(Transmission, EqualIndicesGoStraightOn) {
    SceneDescription scene = in_sky();
    scene.whitted.index = 1.3;
    add(scene, SphereShape{}, glass(1.3));
    const Look seen = look(scene, Vec3(-3, 0.7, 0.2), Vec3(1, 0, 0));
    for (const RayNode& node : seen.tree.nodes) EXPECT_EQ(node.direction, vec3(1, 0, 0));
}

TEST(Transmission, TheSurroundingsHaveAnIndexToo) {
    // A bubble: less dense inside than around it.
    SceneDescription scene = in_sky();
    scene.whitted.index = 1.5;
    add(scene, SphereShape{}, glass(1));
    const Look seen = look(scene, Vec3(-3, 0.5, 0), Vec3(1, 0, 0));
    const double deviation = 2 * (std::asin(0.75) - std::asin(0.5));
    EXPECT_NEAR(angle_between(seen.tree.nodes.back().direction, vec3(1, 0, 0)), deviation, 1e-5);
    EXPECT_TRUE(look(scene, Vec3(-3, 0.7, 0), Vec3(1, 0, 0)).node(0).total_reflection);
}

TEST(TotalReflection, GoesOnInOneRayOfBothWeights) {
    Material m = glass(1.5, 0.5);
    m.reflectivity = 0.25;
    SceneDescription scene = empty_scene();
    scene.whitted.max_depth = 1;
    m.emission = Vec3(1);
    add(scene, PolyhedronShape{PolyhedronKind::box, Vec3(0), Vec3(2)}, m);
    const Look seen = look(scene, Vec3(0), Vec3(1, 0.1, 1.05));
    const RayNode& node = seen.node(0);
    EXPECT_TRUE(node.total_reflection);
    EXPECT_EQ(node.reflected_weight, 0.75f);
    EXPECT_EQ(node.refracted_weight, 0);
    EXPECT_EQ(node.refracted, -1);
    ASSERT_EQ(seen.tree.nodes.size(), 2u);
    EXPECT_EQ(seen.light, vec3(1.75f));
    EXPECT_EQ(node.local_weight, 0.5f);
}

TEST(TotalReflection, StaysWholeWithFresnel) {
    Material m = glass(1.5, 0.5);
    m.reflectivity = 0.25;
    m.fresnel = true;
    SceneDescription scene = empty_scene();
    scene.whitted.max_depth = 1;
    add(scene, PolyhedronShape{PolyhedronKind::box, Vec3(0), Vec3(2)}, m);
    EXPECT_EQ(look(scene, Vec3(0), Vec3(1, 0.1, 1.05)).node(0).reflected_weight, 0.75f);
}

double fresnel(double degrees, double n) {
    const double a = degrees * pi / 180;
    const double c1 = std::cos(a);
    const double c2 = std::sqrt(1 - std::sin(a) * std::sin(a) / (n * n));
    const double s = (c1 - n * c2) / (c1 + n * c2);
    const double p = (n * c1 - c2) / (n * c1 + c2);
    return (s * s + p * p) / 2;
}

TEST(Fresnel, SharesWhatTheSurfaceDoesNotKeep) {
    Material m = glass(1.5, 0.6);
    m.reflectivity = 0.2;
    m.fresnel = true;
    SceneDescription scene = in_sky();
    add(scene, SphereShape{}, m);
    for (const double degrees : {0.0, 30.0, 45.0, 60.0, 80.0, 89.0}) {
        const Look seen = look(scene, Vec3(-3, sin_degrees(degrees), 0), Vec3(1, 0, 0));
        const double share = fresnel(degrees, 1.5);
        EXPECT_NEAR(seen.node(0).reflected_weight, 0.8 * share, 2e-5) << degrees;
        EXPECT_NEAR(seen.node(0).refracted_weight, 0.8 * (1 - share), 2e-5) << degrees;
    }
}

TEST(Fresnel, IsIgnoredWhereNothingGoesThroughAndOnPanes) {
    Material m = mirror(0.4);
    m.fresnel = true;
    SceneDescription opaque = in_sky();
    add(opaque, SphereShape{}, m);
    EXPECT_EQ(look(opaque, Vec3(-3, 0.9, 0), Vec3(1, 0, 0)).node(0).reflected_weight, 0.4f);
    m.transparency = 0.5;
    SceneDescription pane = in_sky();
    add(pane, PlaneShape{}, m);
    const Look seen = look(pane, Vec3(-3, 0, 0.3), Vec3(3, 0, -0.3));
    EXPECT_EQ(seen.node(0).reflected_weight, 0.4f);
    EXPECT_EQ(seen.node(0).refracted_weight, 0.5f);
}

TEST(Fresnel, SumsToOneInAUniformSky) {
    Material m = glass(1.5);
    m.fresnel = true;
    SceneDescription scene = in_sky();
    scene.whitted.max_depth = 24;
    add(scene, SphereShape{}, m);
    for (const double b : {0.0, 0.3, 0.6, 0.9})
        EXPECT_NEAR(look(scene, Vec3(-3, b, 0), Vec3(1, 0, 0)).light.x, 1, 1e-5);
}

/// The share of a picture's pixels that are black.
double black_share(const SceneDescription& scene) {
    const Image image = rendered(scene).image;
    double black = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) black += image.pixels[i] == 0 ? 1 : 0;
    return black / static_cast<double>(image.pixels.size() / 3);
}

TEST(Transmission, RaysExactlyThroughEdgesAndCornersFindTheirWayOut) {
    // Seen straight on, the corners' diagonals of a cube and the tip of an octahedron are hit exactly.
    PolyhedronShape cube{PolyhedronKind::box, Vec3(0), Vec3(2)};
    PolyhedronShape gem{PolyhedronKind::octahedron};
    gem.radius = 1.5;
    for (const PolyhedronShape& shape : {cube, gem})
        for (const double index : {1.0, 1.5}) {
            SceneDescription scene = empty_scene(Vec3(5, 0, 0), Vec3(-1, 0, 0), 401, 30);
            scene.render.background = Vec3(1);
            scene.whitted.max_depth = 40;
            add(scene, shape, glass(index));
            EXPECT_EQ(black_share(scene), 0) << index;
        }
}

TEST(Absorption, ActsOnMirrorRaysInsideAsWell) {
    Material m = glass(1.5);
    m.absorption = Vec3(0.5, 0.25, 0);
    SceneDescription scene = in_sky();
    scene.whitted.max_depth = 8;
    add(scene, PolyhedronShape{PolyhedronKind::box, Vec3(0), Vec3(20, 20, 2)}, m);
    // A lamp at the end of two total reflections, which light up to it must cross the box for.
    const double s = std::sqrt(0.5);
    add(scene, PolyhedronShape{PolyhedronKind::box, Vec3(6, 0, 0), Vec3(2, 2, 4)}, lamp(Vec3(1)));
    const Look seen = look(scene, Vec3(0), Vec3(s, 0, s));
    ASSERT_EQ(seen.node(0).total_reflection, true);
    const double way = 5 / s;
    EXPECT_NEAR(seen.light.x, std::exp(-0.5 * way), 1e-5);
    EXPECT_NEAR(seen.light.y, std::exp(-0.25 * way), 1e-5);
    EXPECT_NEAR(seen.light.z, 1, 1e-6);
}

TEST(Absorption, ARayThatNeverLeavesBringsNothing) {
    SceneDescription scene = in_sky();
    add(scene, PlaneShape{Vec3(0, 0, 1), 0, true}, glass(1.5));
    const Look seen = look(scene, Vec3(0, 0, 1), Vec3(0, 0.3, -1));
    EXPECT_EQ(seen.light, vec3(0.0f));
    EXPECT_EQ(seen.node(1).end, RayEnd::absorbed);
    // The same plane as a pane lets the background through.
    std::get<PlaneShape>(scene.objects[0].shape).solid = false;
    EXPECT_EQ(look(scene, Vec3(0, 0, 1), Vec3(0, 0.3, -1)).light, vec3(1.0f));
}

TEST(Absorption, DoesNotActOnPanesOrOutside) {
    Material m = glass(1.5);
    m.absorption = Vec3(7);
    SceneDescription scene = in_sky();
    add(scene, PlaneShape{}, m);
    EXPECT_EQ(look(scene, Vec3(0, 0, 1), Vec3(0, 0, -1)).light, vec3(1.0f));
}

TEST(Depth, ZeroShowsTheFirstHitAlone) {
    SceneDescription scene = in_sky();
    scene.whitted.max_depth = 0;
    add(scene, PlaneShape{}, mirror());
    const Look seen = look(scene, Vec3(0, 0, 1), Vec3(0, 0, -1));
    EXPECT_EQ(seen.light, vec3(0.0f));
    EXPECT_EQ(seen.counts.reflected, 0u);
}

TEST(Depth, CountsBouncesAfterTheFirstHit) {
    SceneDescription scene = in_sky();
    add(scene, PlaneShape{Vec3(0, 0, 1), -1}, mirror(0.5));
    add(scene, PlaneShape{Vec3(0, 0, 1), 1}, mirror(0.5));
    for (const int depth : {0, 1, 2, 7}) {
        scene.whitted.max_depth = depth;
        const Look seen = look(scene, Vec3(0), Vec3(1, 0, 1));
        EXPECT_EQ(seen.tree.nodes.size(), static_cast<std::size_t>(depth) + 1);
        EXPECT_EQ(seen.tree.nodes.back().end, RayEnd::depth_limit);
    }
}

TEST(Depth, AThousandBouncesAreNoTrouble) {
    SceneDescription scene = in_sky();
    scene.whitted.max_depth = 1000;
    add(scene, PlaneShape{Vec3(0, 0, 1), -1}, mirror(1));
    add(scene, PlaneShape{Vec3(0, 0, 1), 1}, mirror(1));
    const Look seen = look(scene, Vec3(0), Vec3(0.01, 0, 1));
    EXPECT_EQ(seen.tree.nodes.size(), 1001u);
    scene.render.width = 8;
    scene.render.height = 8;
    scene.camera = CameraDescription{};
    RenderOptions two;
    two.threads = 2;
    EXPECT_EQ(rendered(scene, two).stats.reflected_rays, 8u * 8 * 1000);
}

} // namespace
} // namespace glint::rendering
