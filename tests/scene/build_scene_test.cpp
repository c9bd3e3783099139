// From descriptions to what is traced: numbers, transforms, ranks, bounds.

#include "scene_kit.h"

#include "scene/bake.h"
#include "scene/scene_data.h"

#include <gtest/gtest.h>

#include <limits>

namespace glint::scene {
namespace {

using namespace kit;

TEST(BuildScene, KeepsTheDescriptionAndFramesASceneWithoutACamera) {
    SceneDescription scene;
    add(scene, SphereShape{}, matte());
    const Scene scene_data = build_scene(scene);
    EXPECT_EQ(scene_data.render_settings().width, 640);
    EXPECT_GT(glm::length(scene_data.camera().eye), 1);
    EXPECT_EQ(scene_data.data().description.objects.size(), 1u);
    scene = empty_scene(Vec3(1, 2, 3));
    EXPECT_EQ(build_scene(scene).camera().eye, Vec3(1, 2, 3));
}

TEST(BuildScene, CountsWhatThereIs) {
    SceneDescription scene = empty_scene();
    add(scene, SphereShape{Vec3(1, 2, 3), 0.5}, matte());
    add(scene, CylinderShape{}, matte());
    add(scene, PlaneShape{}, matte());
    add(scene, PolyhedronShape{}, matte());
    add(scene, TriangleShape{{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)}}, matte()).visible = false;
    add_light(scene, Vec3(0));
    add_ambient(scene, Vec3(0.1));
    const SceneStats stats = build_scene(scene).stats();
    EXPECT_EQ(stats.objects, 5u);
    ASSERT_GE(stats.quadrics.size(), 2u);
    EXPECT_EQ(stats.quadrics[0].kind, "spheres");
    EXPECT_EQ(stats.quadrics[1].kind, "cylinders");
    EXPECT_EQ(stats.quadrics[0].count, 1u);
    EXPECT_EQ(stats.quadrics[1].count, 1u);
    EXPECT_EQ(stats.planes, 1u);
    EXPECT_EQ(stats.triangles, 12u);
    EXPECT_EQ(stats.lights, 2u);
    EXPECT_GT(stats.bytes, 0u);
    EXPECT_NEAR(stats.bounds_max.y, 2.5, 1e-6);
    EXPECT_NEAR(stats.bounds_max.z, 3.5, 1e-6);
}

TEST(BuildScene, LightsStandInTheOrderOfTheFileWithoutAmbient) {
    SceneDescription scene = empty_scene();
    add_light(scene, Vec3(1, 0, 0), 2, Vec3(0.5, 1, 2));
    add_ambient(scene, Vec3(0.1, 0.2, 0.3));
    DirectionalLight sun;
    sun.direction = Vec3(0, 0, -5);
    scene.lights.push_back({sun, {}});
    SpotLight spot;
    spot.angle = 60;
    spot.blend = 0.5;
    scene.lights.push_back({spot, {}});
    const Scene scene_built = build_scene(scene);
    const SceneData& scene_data = scene_built.data();
    ASSERT_EQ(scene_data.lights.size(), 3u);
    EXPECT_EQ(scene_data.ambient, vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(scene_data.lights[0].strength, vec3(1, 2, 4));
    EXPECT_EQ(scene_data.lights[1].direction, vec3(0, 0, -1));
    EXPECT_EQ(scene_data.lights[2].cos_outer, 0.5f);
    EXPECT_FLOAT_EQ(scene_data.lights[2].cos_inner, 0.8660254f);
}

TEST(BuildScene, RanksGoByPriorityThenByPlace) {
    SceneDescription scene = empty_scene();
    for (const int priority : {0, 2, 0, -1, 2}) add(scene, SphereShape{}, matte()).priority = priority;
    const Scene scene_data = build_scene(scene);
    std::vector<std::uint32_t> ranks;
    for (const ObjectData& o : scene_data.data().objects) ranks.push_back(o.rank);
    EXPECT_EQ(ranks, (std::vector<std::uint32_t>{1, 3, 2, 0, 4}));
}

TEST(BuildScene, AnInvisibleThingIsGoneForAllRays) {
    SceneDescription scene = empty_scene(Vec3(0), Vec3(1, 0, 0));
    add(scene, SphereShape{Vec3(3, 0, 0), 1}, lamp(Vec3(1))).visible = false;
    EXPECT_EQ(look(scene, Vec3(0), Vec3(1, 0, 0)).light, vec3(0.0f));
}

TEST(BuildScene, AnInstanceOfAnInvisibleMeshIsVisible) {
    SceneDescription scene = empty_scene();
    Object& mesh = add(scene, mesh_of(box_mesh(Vec3(0), Vec3(2))), lamp(Vec3(1)));
    mesh.name = "box";
    mesh.visible = false;
    add(scene, InstanceShape{"box"}, std::string()).transform[3] = {5, 0, 0, 1};
    EXPECT_EQ(look(scene, Vec3(0), Vec3(1, 0, 0)).light, vec3(1.0f));
    EXPECT_EQ(look(scene, Vec3(0), Vec3(-1, 0, 0)).light, vec3(0.0f));
}

TEST(BuildScene, FindsMaterialsAndMeshesAmongVeryMany) {
    constexpr std::uint32_t count = 30000;
    SceneDescription scene = empty_scene();
    const MeshShape box = mesh_of(box_mesh(Vec3(0), Vec3(2)));
    for (std::uint32_t i = 0; i < count; ++i) {
        Material material = matte();
        material.name = "paint " + std::to_string(i);
        scene.materials.push_back(material);
        Object mesh;
        mesh.name = "box " + std::to_string(i);
        mesh.shape = box;
        mesh.material = material.name;
        mesh.visible = false;
        scene.objects.push_back(mesh);
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        Object instance;
        instance.shape = InstanceShape{"box " + std::to_string(i)};
        instance.visible = false;
        scene.objects.push_back(instance);
    }
    const Scene scene_data = build_scene(scene);
    for (std::uint32_t i = 0; i < 2 * count; ++i) ASSERT_EQ(scene_data.data().objects[i].material, i % count);
}

TEST(BuildScene, AnInstanceComposesTheMeshsTransformWithItsOwn) {
    SceneDescription scene = empty_scene();
    MeshShape shape = mesh_of(box_mesh(Vec3(0), Vec3(2)));
    shape.scale = Vec3(1, 2, 3);
    Object& mesh = add(scene, shape, matte());
    mesh.name = "box";
    mesh.transform[3] = {10, 0, 0, 1};
    Mat4 quarter(1.0);
    quarter[0] = {0, 1, 0, 0};
    quarter[1] = {-1, 0, 0, 0};
    Object& copy = add(scene, InstanceShape{"box"}, std::string());
    copy.transform = quarter;
    const Scene scene_data = build_scene(scene);
    const Bounds& bounds = scene_data.data().objects[1].bounds;
    EXPECT_EQ(bounds.lo, vec3(-2, 9, -3));
    EXPECT_EQ(bounds.hi, vec3(2, 11, 3));
    EXPECT_EQ(scene_data.data().objects[1].material, scene_data.data().objects[0].material);
}

TEST(BuildScene, APlanesTransformMovesItsPoints) {
    SceneDescription scene = empty_scene();
    Object& plane = add(scene, PlaneShape{Vec3(0, 0, 2), 2}, lamp(Vec3(1)));
    plane.transform = rotation(3);
    plane.transform[0] *= 2;
    plane.transform[3] = {1, 2, 3, 1};
    // Points of the plane z = 1, carried along, and a step off it either way.
    for (unsigned i = 0; i < 8; ++i) {
        const Vec3 on = Vec3(plane.transform * glm::dvec4(rotation(i)[0].x, rotation(i)[0].y, 1, 1));
        const Vec3 eye = Vec3(plane.transform * glm::dvec4(0.3, 0.1, 3, 1));
        const Look seen = look(scene, eye, on - eye);
        EXPECT_NEAR(glm::length(Vec3(seen.node(0).position) - on), 0, 2e-6);
    }
}

TEST(BuildScene, SpheresUnderUnequalScalesAreEllipsoids) {
    SceneDescription scene = empty_scene();
    add(scene, SphereShape{Vec3(0), 1}, lamp(Vec3(1))).transform[0] *= 3;
    const Look wide = look(scene, Vec3(9, 0, 0), Vec3(-1, 0, 0));
    EXPECT_NEAR(wide.node(0).position.x, 3, 1e-6);
    EXPECT_EQ(wide.node(0).geometric_normal, vec3(1, 0, 0));
    EXPECT_NEAR(look(scene, Vec3(0, 9, 0), Vec3(0, -1, 0)).node(0).position.y, 1, 1e-6);
    const Look slanted = look(scene, Vec3(1.5, 9, 0), Vec3(0, -1, 0));
    const vec3 normal = normalize(vec3(1.5f / 9, std::sqrt(0.75f), 0));
    EXPECT_NEAR(angle_between(slanted.node(0).geometric_normal, normal), 0, 1e-6);
}

TEST(BuildScene, RadiiOfPointsFollowTheLargestStretch) {
    Mesh cloud;
    cloud.positions = {{0, 0, 0}};
    MeshShape shape = mesh_of(cloud);
    shape.point_radius = 0.5;
    shape.scale = Vec3(1, 4, 1);
    SceneDescription scene = empty_scene();
    add(scene, shape, lamp(Vec3(1)));
    EXPECT_NEAR(look(scene, Vec3(9, 0, 0), Vec3(-1, 0, 0)).node(0).position.x, 2, 1e-6);
}

TEST(BuildScene, VerticesThatNoFaceUsesDoNotMatter) {
    Mesh mesh = box_mesh(Vec3(0), Vec3(2));
    mesh.positions.emplace_back(std::numeric_limits<float>::infinity());
    mesh.positions.emplace_back(std::numeric_limits<float>::quiet_NaN());
    SceneDescription scene = empty_scene();
    add(scene, mesh_of(mesh), matte());
    const Scene scene_data = build_scene(scene);
    EXPECT_EQ(scene_data.data().objects[0].bounds.hi, vec3(1.0f));
    EXPECT_EQ(scene_data.stats().bounds_max, Vec3(1));
}

TEST(BuildScene, RefusesWhatATransformTakesBeyondTheLimit) {
    SceneDescription scene = empty_scene();
    Object& ball = add(scene, SphereShape{Vec3(1), 1}, matte());
    ball.transform[0] *= 1e13;
    ball.where = Location{"a.toml", 7, 1, {}};
    try {
        build_scene(scene);
        ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
        EXPECT_EQ(error.diagnostics().at(0).location.line, 7);
        EXPECT_EQ(error.diagnostics().at(0).message,
                  "the object reaches beyond coordinates of 1e12 after its transform");
    }
}

TEST(ObjectsAround, FindsEverySolidThatContainsThePoint) {
    SceneDescription scene = empty_scene();
    add(scene, SphereShape{Vec3(0), 2}, glass(1.5));
    add(scene, PolyhedronShape{PolyhedronKind::box, Vec3(0), Vec3(2)}, matte());
    add(scene, CylinderShape{Vec3(0, 0, -1), Vec3(0, 0, 1), 2, 0.5}, glass(1.5));
    add(scene, PlaneShape{Vec3(0, 0, 1), 0.5, true}, glass(1.5));
    add(scene, PlaneShape{Vec3(0, 0, 1), 0.5, false}, glass(1.5));
    add(scene, mesh_of(box_mesh(Vec3(3, 0, 0), Vec3(2))), matte());
    const Scene scene_data = build_scene(scene);
    using Ids = std::vector<std::uint32_t>;
    EXPECT_EQ(objects_around(scene_data.data(), vec3(0.0f)), (Ids{0, 1, 2, 3}));
    EXPECT_EQ(objects_around(scene_data.data(), vec3(0.7f, 0.7f, 0.7f)), (Ids{0, 1}));
    EXPECT_EQ(objects_around(scene_data.data(), vec3(3, 0, 0)), (Ids{5, 3}));
    EXPECT_EQ(objects_around(scene_data.data(), vec3(9, 9, 9)), Ids{});
}

TEST(ObjectsAround, IsRightWhereRaysMeetEdges) {
    // The first direction tried runs exactly through a corner of this mesh.
    Mesh mesh = box_mesh(Vec3(0), Vec3(2));
    const glm::vec3 first(0.5377f, 0.2917f, 0.7825f);
    glm::vec3* corner = &mesh.positions[0];
    for (glm::vec3& p : mesh.positions)
        if (p.x > 0 && p.y > 0 && p.z > 0) corner = &p;
    *corner = first * 2.0f;
    SceneDescription scene = empty_scene();
    add(scene, mesh_of(mesh), glass(1.5));
    EXPECT_EQ(objects_around(build_scene(scene).data(), vec3(0.0f)), std::vector<std::uint32_t>{0});
    EXPECT_TRUE(objects_around(build_scene(scene).data(), vec3(first * -2.0f)).empty());
}

} // namespace
} // namespace glint::scene
