// What is suspicious though valid: each kind said where it is so, and not where it is not.

#include "scene_kit.h"

#include "scene/hidden_solids.h"

#include <gtest/gtest.h>

namespace glint::scene {
namespace {

using namespace kit;

/// Nothing to complain of: a lit ball, seen from outside.
SceneDescription plain() {
    SceneDescription scene = empty_scene(Vec3(0, -9, 0));
    Material m = matte(0.8);
    m.name = "clay";
    add(scene, SphereShape{}, m);
    add_light(scene, Vec3(5, -5, 5));
    return scene;
}

std::vector<std::string> warned(const SceneDescription& scene) {
    std::vector<std::string> messages;
    for (const Diagnostic& d : warnings(build_scene(scene))) {
        EXPECT_EQ(d.severity, Severity::warning);
        EXPECT_FALSE(d.hint.empty());
        messages.push_back(d.message);
    }
    return messages;
}

using Messages = std::vector<std::string>;

TEST(Warnings, AreNoneForAPlainScene) { EXPECT_EQ(warned(plain()), Messages{}); }

TEST(Warnings, TellOfOpacityThatIsNotRead) {
    SceneDescription scene = plain();
    scene.materials[0].opacity = 0.5;
    EXPECT_EQ(warned(scene).size(), 1u);
    EXPECT_NE(warned(scene).at(0).find("reads no opacity"), std::string::npos);
    scene.render.integrator = Integrator::ambient_occlusion;
    EXPECT_EQ(warned(scene), Messages{});
}

TEST(Warnings, TellOfMissingLight) {
    SceneDescription scene = plain();
    scene.lights.clear();
    EXPECT_EQ(warned(scene), Messages{"the scene has no light: everything will be black"});
    scene.materials[0].emission = Vec3(1);
    EXPECT_EQ(warned(scene), Messages{});
    scene.materials[0].emission = Vec3(0);
    add_ambient(scene, Vec3(0.1));
    EXPECT_EQ(warned(scene), Messages{});
}

TEST(Warnings, OfPathTracingTellWhatItLeavesOutAndWhatItFindsByChance) {
    SceneDescription scene = plain();
    scene.render.integrator = Integrator::path;
    EXPECT_EQ(warned(scene), Messages{});
    add_ambient(scene, Vec3(0.1));
    EXPECT_EQ(warned(scene),
              Messages{"path tracing leaves ambient lights out: light from everywhere is indirect"});
    scene.lights.clear();
    EXPECT_EQ(warned(scene), Messages{"the scene has no light: everything will be black"});
    scene.render.background = Vec3(0.5);
    EXPECT_EQ(warned(scene), Messages{});
    add(scene, PlaneShape{Vec3(0, 0, 1), -5}, lamp(Vec3(1)));
    EXPECT_EQ(warned(scene),
              Messages{"plane.0 emits light and is infinite: paths find its light by chance alone"});
    scene.render.integrator = Integrator::whitted;
    EXPECT_EQ(warned(scene), Messages{});
}

TEST(Warnings, TellOfALightInsideSomething) {
    SceneDescription scene = plain();
    scene.objects[0].name = "lampshade";
    std::get<PointLight>(scene.lights[0].kind).position = Vec3(0.5, 0, 0);
    scene.lights[0].where.line = 4;
    EXPECT_EQ(warned(scene), Messages{"point light.0 is inside sphere \"lampshade\""});
    EXPECT_EQ(warnings(build_scene(scene)).at(0).location.line, 4);
    SpotLight spot;
    spot.position = Vec3(0, 0.5, 0);
    scene.lights[0].kind = spot;
    EXPECT_EQ(warned(scene), Messages{"spot light.0 is inside sphere \"lampshade\""});
    scene.objects[0].visible = false;
    EXPECT_EQ(warned(scene), Messages{});
}

TEST(Warnings, LetLampsOfGlassShine) {
    SceneDescription scene = plain();
    add(scene, SphereShape{Vec3(5, -5, 5), 1}, glass(1.5)).name = "bulb";
    EXPECT_EQ(warned(scene), Messages{});
    scene.whitted.shadows = Shadows::opaque;
    EXPECT_EQ(warned(scene), Messages{"point light.0 is inside sphere \"bulb\""});
}

TEST(Warnings, TellOfACameraAndALightBehindAWall) {
    SceneDescription scene = plain();
    add(scene, RectangleShape{Vec3(-50, -6, -50), Vec3(100, 0, 0), Vec3(0, 0, 100)}, "clay").name = "wall";
    EXPECT_EQ(warned(scene), (Messages{"the camera sees nothing but rectangle \"wall\"",
                                       "point light.0 lights nothing that the camera sees: "
                                       "rectangle \"wall\" is in between"}));
    scene.camera->eye.y = -5.9;
    EXPECT_EQ(warned(scene), Messages{});
    scene.camera->eye.y = -9;
    scene.objects.pop_back();
    PlaneShape plane;
    plane.normal = Vec3(1, 0, 0);
    plane.offset = 3;
    add(scene, plane, "clay");
    EXPECT_EQ(warned(scene),
              Messages{"point light.0 lights nothing that the camera sees: plane.0 is in between"});
    scene.objects.back().material = "";
    scene.objects.pop_back();
    add(scene, plane, glass(1.5));
    EXPECT_EQ(warned(scene), Messages{}) << "a window";
}

TEST(Warnings, TellOfACameraInsideSomething) {
    SceneDescription scene = plain();
    scene.camera->eye = Vec3(0, 0.5, 0);
    EXPECT_EQ(warned(scene), Messages{"the camera is inside sphere.0"});
    scene.camera->eye = Vec3(0, 1.5, 0);
    EXPECT_EQ(warned(scene), Messages{});
}

TEST(Warnings, TellWhereSinglePrecisionIsCoarserThanPixels) {
    SceneDescription scene = plain();
    const Vec3 far(5e6, 0, 0);
    scene.camera->eye = far - Vec3(0, 10, 0);
    scene.camera->direction = Vec3(0, 1, 0);
    add(scene, SphereShape{far, 1}, "clay");
    const Messages found = warned(scene);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NE(found[0].find("precision moves sphere.1 by up to 0.6, about "), std::string::npos) << found[0];
    scene.camera->eye = Vec3(0, -10, 0);
    EXPECT_EQ(warned(scene), Messages{}) << "from far away";
    scene.camera->eye = far - Vec3(0, 10, 0);
    scene.objects.erase(scene.objects.begin());
    EXPECT_EQ(warned(scene), Messages{}) << "all in one place";
}

TEST(Warnings, TellOfPointsThatAreNotFramed) {
    SceneDescription scene = plain();
    Mesh cloud;
    for (int i = 0; i < 100; ++i) cloud.positions.emplace_back(i % 5, 9 + i / 20, i / 5 % 4);
    cloud.positions.emplace_back(1e4f);
    add(scene, mesh_of(cloud), "clay").name = "cloud";
    EXPECT_EQ(warned(scene), Messages{});
    scene.camera.reset();
    EXPECT_EQ(warned(scene), Messages{"1 of the 101 points of mesh \"cloud\" lie far from the others and are "
                                      "not framed"});
}

TEST(Warnings, FindClosedMeshesAroundCameraAndLightWithAndWithoutGlass) {
    SceneDescription scene = plain();
    Mesh box = box_mesh(Vec3(9, 0, 0), Vec3(4));
    add(scene, mesh_of(box), "clay").name = "box";
    scene.camera->eye = Vec3(9, 0.1, 0.2);
    EXPECT_EQ(warned(scene), Messages{"the camera is inside mesh \"box\""});
    add(scene, SphereShape{Vec3(-9, 0, 0), 1}, glass(1.5));
    EXPECT_EQ(warned(scene), Messages{"the camera is inside mesh \"box\""});
    scene.objects.pop_back();
    std::get<PointLight>(scene.lights[0].kind).position = scene.camera->eye;
    EXPECT_EQ(warned(scene).size(), 2u);
    // An open box is a room with a window, not something to be inside of.
    box.triangles.pop_back();
    std::get<MeshShape>(scene.objects[1].shape) = mesh_of(box);
    EXPECT_EQ(warned(scene), Messages{});
}

TEST(Warnings, OfManyLightsInOneMeshLookAtItOnce) {
    constexpr std::size_t count = 4000;
    SceneDescription scene = plain();
    scene.objects.clear();
    add(scene, mesh_of(sphere_mesh(3, 100)), "clay");
    scene.lights.clear();
    for (std::size_t i = 0; i < count; ++i) add_light(scene, Vec3(2.0 * double(i) / count, 0, 0));
    EXPECT_EQ(warned(scene).size(), count);
}

TEST(Warnings, TellOfMaterialsThatGiveMoreThanTheyGet) {
    SceneDescription scene = plain();
    Material& m = scene.materials[0];
    m.where.line = 3;
    m.reflectivity = 0.3;
    EXPECT_EQ(warned(scene), Messages{"material \"clay\" gives 1.10 times the light that it gets"});
    EXPECT_EQ(warnings(build_scene(scene)).at(0).location.line, 3);
    scene.whitted.energy_chosen = true;
    EXPECT_EQ(warned(scene), Messages{}) << "it is meant";
    scene.whitted.energy_chosen = false;
    scene.whitted.energy = Energy::balanced;
    EXPECT_EQ(warned(scene), Messages{});
    scene.whitted.energy = Energy::report;
    m.reflectivity = 0.2;
    EXPECT_EQ(warned(scene), Messages{});
    m.diffuse = 0;
    m.reflectivity = 1.5;
    EXPECT_EQ(warned(scene), Messages{"material \"clay\" gives 1.50 times the light that it gets"});
    // What goes through is not kept: (1 − τ) · 0.8 + τ is below 1.
    m.diffuse = 0.8;
    m.reflectivity = 0;
    m.transparency = 0.5;
    EXPECT_EQ(warned(scene), Messages{});
}

TEST(Warnings, TellOfOpenMeshesMadeOfGlass) {
    SceneDescription scene = plain();
    Mesh box = box_mesh(Vec3(5, 0, 0), Vec3(1));
    add(scene, mesh_of(box), glass(1.5)).name = "vase";
    EXPECT_EQ(warned(scene), Messages{});
    box.triangles.pop_back();
    std::get<MeshShape>(scene.objects[1].shape) = mesh_of(box);
    EXPECT_EQ(warned(scene), Messages{"mesh \"vase\" is made of glass but is not closed"});
    scene.objects[1].material = "clay";
    EXPECT_EQ(warned(scene), Messages{});
}

TEST(Warnings, TellOfGlassMeshesWithAFaceTurned) {
    SceneDescription scene = plain();
    Mesh box = box_mesh(Vec3(5, 0, 0), Vec3(1));
    std::swap(box.triangles[0].x, box.triangles[0].y);
    add(scene, mesh_of(box), glass(1.5)).name = "vase";
    EXPECT_EQ(warned(scene),
              Messages{"mesh \"vase\" is made of glass, but not all its faces are wound alike"});
}

TEST(Warnings, AreNoneForGlassThatStandsOnSomething) {
    for (const double height : {-1.0, -0.999}) {
        SceneDescription scene = plain();
        PlaneShape floor;
        floor.offset = -1;
        add(scene, floor, "clay");
        add(scene, CylinderShape{Vec3(5, 0, height), Vec3(0, 0, 1), 2, 1}, glass(1.5));
        EXPECT_EQ(warned(scene), Messages{});
    }
}

TEST(Warnings, TellOfDepthsAtWhichRaysBranchAmongMirrors) {
    SceneDescription scene = empty_scene(Vec3(0, -3, 0));
    Material mirror = matte(0.1);
    mirror.name = "mirror";
    mirror.reflectivity = 0.9;
    PlaneShape wall;
    wall.offset = -5;
    add(scene, wall, mirror);
    wall.normal = Vec3(0, 0, -1);
    add(scene, wall, "mirror");
    Material m = glass(1.5);
    m.fresnel = true;
    add(scene, SphereShape{}, m).name = "ball";
    add_light(scene, Vec3(3, -3, 3));
    scene.whitted.max_depth = 16;
    EXPECT_EQ(warned(scene), Messages{});
    scene.whitted.max_depth = 50;
    EXPECT_EQ(warned(scene), Messages{}) << "their weight ends them";
    scene.whitted.min_weight = 0;
    EXPECT_EQ(warned(scene), Messages{"max_depth = 50 lets rays that branch at sphere \"ball\" among mirrors "
                                      "become up to 2^50 a sample"});
    scene.objects[1].visible = false;
    EXPECT_EQ(warned(scene), Messages{}) << "one mirror alone";
    scene.objects[1].visible = true;
    scene.materials.back().fresnel = false;
    scene.materials.back().reflectivity = 0;
    EXPECT_EQ(warned(scene), Messages{}) << "rays do not branch";
}

TEST(Warnings, TellOfGlassHiddenInsideGlassThatOwnsItsSpace) {
    SceneDescription scene = plain();
    scene.objects.clear();
    add(scene, SphereShape{}, glass(1.3)).name = "pearl";
    add(scene, SphereShape{Vec3(0), 2}, glass(1.5)).name = "shell";
    EXPECT_EQ(warned(scene),
              Messages{"sphere \"pearl\" is hidden inside sphere \"shell\", which owns the space"});
    scene.objects[0].priority = 1;
    EXPECT_EQ(warned(scene), Messages{});
    scene.objects[0].priority = 0;
    std::get<SphereShape>(scene.objects[0].shape).center.x = 1.5;
    EXPECT_EQ(warned(scene), Messages{}) << "a part of it shows";
    std::get<SphereShape>(scene.objects[0].shape).center.x = 0;
    scene.objects[0].material = "clay";
    EXPECT_EQ(warned(scene), Messages{}) << "opaque things are never hidden";
}

/// Concentric balls of glass; each owns the space of those before it, or of those behind it.
SceneDescription nested_balls(int count, bool inner_owns) {
    SceneDescription scene = plain();
    add(scene, SphereShape{}, glass(1));
    Object ball = scene.objects.back();
    scene.objects.clear();
    for (int i = 0; i < count; ++i) {
        ball.shape = SphereShape{Vec3(0), 1 + (inner_owns ? count - i : i) * 0.001};
        scene.objects.push_back(ball);
    }
    return scene;
}

TEST(Warnings, OfManyNestedSolidsTakeFewRays) {
    EXPECT_EQ(warned(nested_balls(1000, true)), Messages{});
    EXPECT_EQ(warned(nested_balls(300, false)).size(), max_hidden_solids);
}

TEST(Warnings, AreNoneForOpaqueThingsInWater) {
    SceneDescription scene = plain();
    scene.objects.clear();
    add(scene, CylinderShape{Vec3(0, 0, -3), Vec3(0, 0, 1), 4, 0.5}, "clay").name = "pole";
    add(scene, DiskShape{Vec3(3, 0, -1), Vec3(0, 0, 1), 1}, "clay").name = "leaf";
    add(scene, SphereShape{Vec3(6, 0, 2), 1}, "clay").name = "buoy";
    PlaneShape bed;
    bed.offset = -3.5;
    add(scene, bed, "clay").name = "bed";
    PlaneShape water;
    water.solid = true;
    add(scene, water, glass(1.33)).name = "water";
    scene.camera->eye = Vec3(0, -9, 3);
    EXPECT_EQ(warned(scene), Messages{});
    scene.objects[0].material = scene.objects.back().material;
    scene.objects[0].transform[3].z = -2;
    EXPECT_EQ(warned(scene),
              Messages{"cylinder \"pole\" is hidden inside plane \"water\", which owns the space"});
}

} // namespace
} // namespace glint::scene
