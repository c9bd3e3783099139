// What stands between a surface and a light (docs/light-model.md, "Shadows").

#include "scene_kit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glint::rendering {
namespace {

using namespace kit;

/// A matte floor at z = 0 with a light of intensity 16 four units above: it shows 1 where nothing is between.
SceneDescription lit_floor() {
    SceneDescription scene = empty_scene();
    add(scene, PlaneShape{}, matte());
    add_light(scene, Vec3(0, 0, 4), 16);
    return scene;
}

/// The share of the light that reaches the floor's origin.
float share(const SceneDescription& scene) {
    return look(scene, Vec3(0.1, 0, 0.2), Vec3(-0.1, 0, -0.2)).light.x;
}

TriangleShape pane_at(double z, double half = 2) {
    return TriangleShape{{Vec3(-half, -half, z), Vec3(half * 2, -half, z), Vec3(-half, half * 2, z)}};
}

TEST(Shadow, NothingBetweenLetsAllLightThrough) { EXPECT_FLOAT_EQ(share(lit_floor()), 1); }

TEST(Shadow, SomethingOpaqueBetweenBlocks) {
    for (const Shadows shadows : {Shadows::opaque, Shadows::transmissive}) {
        SceneDescription scene = lit_floor();
        scene.whitted.shadows = shadows;
        add(scene, SphereShape{Vec3(0, 0, 2), 0.5}, matte());
        EXPECT_EQ(share(scene), 0);
        add(scene, SphereShape{Vec3(0, 0, 3), 0.2}, glass(1.5));
        EXPECT_EQ(share(scene), 0);
    }
}

TEST(Shadow, WhatLiesBehindTheLightOrTheSurfaceDoesNotBlock) {
    SceneDescription scene = lit_floor();
    add(scene, SphereShape{Vec3(0, 0, 4.5), 0.49}, matte());
    add(scene, SphereShape{Vec3(0, 0, -1), 0.9}, matte());
    EXPECT_FLOAT_EQ(share(scene), 1);
}

TEST(Shadow, AnOpaqueRoomAroundTheLightBlocks) {
    SceneDescription scene = lit_floor();
    add(scene, SphereShape{Vec3(0, 0, 4), 0.5}, matte());
    EXPECT_EQ(share(scene), 0);
}

TEST(Shadow, InvisibleThingsCastNone) {
    SceneDescription scene = lit_floor();
    add(scene, SphereShape{Vec3(0, 0, 2), 0.5}, matte()).visible = false;
    EXPECT_FLOAT_EQ(share(scene), 1);
}

TEST(Shadow, AGlassBallLetsTauSquaredThrough) {
    SceneDescription scene = lit_floor();
    add(scene, SphereShape{Vec3(0, 0, 2), 0.5}, glass(1.5, 0.5));
    EXPECT_FLOAT_EQ(share(scene), 0.25f);
}

TEST(Shadow, APaneLetsTauThroughOnce) {
    SceneDescription scene = lit_floor();
    add(scene, pane_at(1), glass(1.5, 0.5));
    EXPECT_FLOAT_EQ(share(scene), 0.5f);
    add(scene, PlaneShape{Vec3(0, 0, 1), 2}, glass(1.5, 0.5));
    EXPECT_FLOAT_EQ(share(scene), 0.25f);
}

TEST(Shadow, EverySolidIsCrossedTwice) {
    const PolyhedronShape box{PolyhedronKind::box, Vec3(0.1, 0.2, 2), Vec3(1)};
    const CylinderShape cylinder{Vec3(0.1, 0.1, 1.5), Vec3(0, 0, 1), 1, 0.5};
    for (const Shape& shape :
         {Shape(box), Shape(cylinder), Shape(mesh_of(box_mesh(Vec3(0.1, 0.2, 2), Vec3(1))))}) {
        SceneDescription scene = lit_floor();
        add(scene, shape, glass(1.5, 0.5));
        EXPECT_FLOAT_EQ(share(scene), 0.25f) << "shape " << shape.index();
    }
}

TEST(Shadow, TwoHitsOfOneMeshOnASharedEdgeCountOnce) {
    // The diagonal of this square runs through the ray to the light.
    Mesh square;
    square.positions = {{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    SceneDescription scene = lit_floor();
    add(scene, mesh_of(square), glass(1.5, 0.5));
    EXPECT_FLOAT_EQ(share(scene), 0.5f);
    // The same vertex in four triangles, and the diagonals of both ends of a box.
    square.positions = {{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}, {0, 0, 2}};
    square.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    SceneDescription fan = lit_floor();
    add(fan, mesh_of(square), glass(1.5, 0.5));
    EXPECT_FLOAT_EQ(share(fan), 0.5f);
    SceneDescription box = lit_floor();
    add(box, mesh_of(box_mesh(Vec3(0, 0, 2), Vec3(1))), glass(1.5, 0.5));
    EXPECT_FLOAT_EQ(share(box), 0.25f);
}

TEST(Shadow, TwoCoincidentPanesOfDifferentObjectsCountTwice) {
    SceneDescription scene = lit_floor();
    add(scene, pane_at(1), glass(1.5, 0.5));
    add(scene, pane_at(1), glass(1.5, 0.5));
    EXPECT_FLOAT_EQ(share(scene), 0.25f);
}

TEST(Shadow, SharesMultiplyInOrderOfDistanceWhateverTheOrderOfTheFile) {
    const double taus[] = {0.1, 0.3, 0.7, 0.9};
    const float a = 0.1f, b = 0.3f, c = 0.7f, d = 0.9f;
    const float expected = ((a * b) * c) * d;
    ASSERT_NE(expected, ((d * c) * b) * a) << "numbers for which the order cannot be seen";
    for (const bool reversed : {false, true}) {
        SceneDescription scene = empty_scene();
        scene.objects.clear();
        add(scene, PlaneShape{}, matte());
        add_light(scene, Vec3(0, 0, 4), 16);
        for (int i = 0; i < 4; ++i) {
            const int k = reversed ? 3 - i : i;
            add(scene, pane_at(1 + 0.5 * k), glass(1.5, taus[k]));
        }
        const Look seen = look(scene, Vec3(0.1, 0, 0.2), Vec3(-0.1, 0, -0.2));
        EXPECT_EQ(seen.node(0).lights.at(0).shadow, expected);
    }
}

TEST(Shadow, OpaqueModeBlocksAtGlass) {
    SceneDescription scene = lit_floor();
    scene.whitted.shadows = Shadows::opaque;
    add(scene, pane_at(1), glass(1.5, 0.99));
    EXPECT_EQ(share(scene), 0);
}

TEST(Shadow, KnowsTauOnly) {
    // No bending, no absorption, no Fresnel, no ρ: the ball is off the ray's axis, and nothing but τ tells.
    Material m = glass(2.4, 0.5);
    m.absorption = Vec3(100);
    m.fresnel = true;
    m.reflectivity = 0.4;
    SceneDescription scene = lit_floor();
    add(scene, SphereShape{Vec3(0.3, 0, 2), 0.5}, m);
    EXPECT_FLOAT_EQ(share(scene), 0.25f);
}

TEST(Shadow, CrossingsAreNotCountedAsDepth) {
    SceneDescription scene = lit_floor();
    scene.whitted.max_depth = 0;
    for (int i = 0; i < 5; ++i) add(scene, pane_at(1 + 0.5 * i), glass(1.5, 1));
    EXPECT_FLOAT_EQ(share(scene), 1);
}

TEST(Shadow, DirectionalLightIsBlockedFromAnyDistance) {
    SceneDescription scene = lit_floor();
    scene.lights.clear();
    DirectionalLight sun;
    scene.lights.push_back({sun, {}});
    EXPECT_FLOAT_EQ(share(scene), 1);
    add(scene, SphereShape{Vec3(0, 0, 1e6), 1e5}, glass(1.5, 0.5));
    EXPECT_FLOAT_EQ(share(scene), 0.25f);
    add(scene, SphereShape{Vec3(0, 0, 1e9), 1e8}, matte());
    EXPECT_EQ(share(scene), 0);
}

TEST(Shadow, HighlightIsShadowedToo) {
    Material m = black();
    m.highlight = 1;
    m.shininess = 0;
    SceneDescription scene = lit_floor();
    scene.materials[0] = m;
    scene.materials[0].name = scene.objects[0].material;
    EXPECT_FLOAT_EQ(share(scene), 1);
    add(scene, pane_at(1), glass(1.5, 0.5));
    EXPECT_FLOAT_EQ(share(scene), 0.5f);
}

/// A matte point on the inner side of a glass ball of radius 1, lit from `light`.
float inner_light(Shadows shadows, const Vec3& light) {
    Material m = glass(1.5, 0.5);
    m.color = Vec3(1);
    m.diffuse = 1;
    SceneDescription scene = empty_scene();
    scene.whitted.shadows = shadows;
    scene.whitted.max_depth = 0;
    add(scene, SphereShape{}, m);
    add_light(scene, light);
    return look(scene, Vec3(0), Vec3(0, 0, -1)).light.x;
}

TEST(Shadow, OpaqueModeBlocksOutsideLightsFromTheInnerSideOfGlass) {
    EXPECT_EQ(inner_light(Shadows::opaque, Vec3(0, 0, 2)), 0);
    EXPECT_FLOAT_EQ(inner_light(Shadows::transmissive, Vec3(0, 0, 2)), 0.5f / 9);
}

TEST(Shadow, ALightInsideTheSameGlassIsNotBlocked) {
    EXPECT_FLOAT_EQ(inner_light(Shadows::opaque, Vec3(0, 0, 0.5)), 1 / 2.25f);
    EXPECT_FLOAT_EQ(inner_light(Shadows::transmissive, Vec3(0, 0, 0.5)), 1 / 2.25f);
}

TEST(Shadow, NoSurfaceShadowsItself) {
    // Every lit pixel of convex things must get its light whole: no acne at any angle, size or distance.
    for (const double size : {1e-6, 1.0, 1e6}) {
        SceneDescription scene = empty_scene(Vec3(0, -6, 1) * size, Vec3(0, 6, -1), 64, 30);
        const SphereShape ball{Vec3(0, 0, 0), size};
        add(scene, ball, matte());
        const CylinderShape can{Vec3(-2, 0, -1) * size, Vec3(0.3, 0.1, 1), size, size * 0.6};
        add(scene, can, matte());
        add(scene, ConeShape{Vec3(0.4, -2, -1.2) * size, Vec3(-0.2, 0.1, 1), size * 0.8, size * 0.5},
            matte());
        PolyhedronShape gem{PolyhedronKind::icosahedron};
        gem.center = Vec3(2, 0, 0) * size;
        gem.radius = 0.8 * size;
        add(scene, gem, matte());
        add_light(scene, Vec3(0.3, -9, 2) * size, size * size);
        const Scene scene_data = build_scene(scene);
        Whitted tracer(scene_data.data());
        int lit = 0;
        for (int i = 0; i < 4000; ++i) {
            const Vec3 d = Vec3(0.9 * std::sin(1.7 * i), 6, -1 + 0.5 * std::sin(2.9 * i));
            RayTree tree;
            tracer.trace(camera_ray(vec3(scene.camera->eye), vec3(glm::normalize(d))), &tree);
            const RayNode& node = tree.nodes.at(0);
            if (!node.hit || node.lights.at(0).arriving.x <= 0) continue;
            EXPECT_EQ(node.lights.at(0).shadow, 1) << size << " " << i;
            ++lit;
        }
        EXPECT_GT(lit, 1000);
    }
}

} // namespace
} // namespace glint::rendering
