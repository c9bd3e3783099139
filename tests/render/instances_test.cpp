// Instances show what the same meshes show when baked, and are solids as these are.

#include "scene_kit.h"

#include "scene/scene_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glint::rendering {

using scene::objects_around;

namespace {

using namespace kit;

/// Every instance as a mesh of its own.
SceneDescription with_instances_baked(SceneDescription scene) {
    for (Object& object : scene.objects) {
        const auto* instance = std::get_if<InstanceShape>(&object.shape);
        if (instance == nullptr) continue;
        const auto mesh = std::find_if(scene.objects.begin(), scene.objects.end(),
                                       [&](const Object& o) { return o.name == instance->mesh; });
        object.transform = object.transform * mesh->transform;
        if (object.material.empty()) object.material = mesh->material;
        object.shape = Shape(mesh->shape);
    }
    return scene;
}

SceneDescription studio() {
    SceneDescription scene = empty_scene(Vec3(0.31, -9.57, 4.71), Vec3(-0.031, 0.897, -0.449), 160, 38);
    scene.whitted.max_depth = 5;
    scene.render.background = Vec3(0.2, 0.3, 0.4);
    add_light(scene, Vec3(3.1, -4.7, 9.3), 70, Vec3(1, 0.9, 0.8));
    add_ambient(scene, Vec3(0.11, 0.12, 0.13));
    Material floor = matte(0.8);
    floor.reflectivity = 0.2;
    add(scene, PlaneShape{Vec3(0, 0, 1), -1.17}, floor);
    return scene;
}

Material paint() {
    Material m = matte(0.7);
    m.color = Vec3(0.9, 0.5, 0.3);
    m.highlight = 0.4;
    m.reflectivity = 0.1;
    return m;
}

/// A mesh and instances of it: turned, mirrored, stretched.
void add_with_instances(SceneDescription& scene, const MeshShape& shape, const Material& material) {
    Object& mesh = add(scene, shape, material);
    mesh.name = "mesh";
    mesh.transform = rotation(1);
    mesh.transform[3] = {-2.6, 0.3, 0.1, 1};
    for (unsigned i = 0; i < 6; ++i) {
        Mat4 m = rotation(20 + i);
        if (i % 2 == 0) m[0] *= -1.0;
        if (i % 3 == 1) m[1] *= 1.4;
        m[3] = {-1.9 + 1.31 * i, -1.4 + 0.9 * (i % 3), 0.3 + 0.2 * i, 1};
        add(scene, InstanceShape{"mesh"}, std::string()).transform = m;
    }
}

void expect_the_picture_of_baked_ones(const SceneDescription& scene) {
    const Picture instanced = rendered(scene);
    const Picture baked = rendered(with_instances_baked(scene));
    EXPECT_LE(compare(instanced.image, baked.image, 1.0 / 255.0, 1.0).share, 0.001);
    const std::vector<float>& pixels = baked.image.pixels;
    const auto drawn = std::count_if(pixels.begin(), pixels.end(),
                                     [](float x) { return x != 0.2f && x != 0.3f && x != 0.4f; });
    EXPECT_GT(static_cast<std::size_t>(drawn), pixels.size() / 4);
}

TEST(Instances, ShowWhatBakedOnesShow) {
    SceneDescription scene = studio();
    add_with_instances(scene, mesh_of(box_mesh(Vec3(0.1, 0.2, 0), Vec3(0.9, 0.7, 1.1))), paint());
    expect_the_picture_of_baked_ones(scene);
}

TEST(Instances, OfSmoothColouredMeshesShowWhatBakedOnesShow) {
    SceneDescription scene = studio();
    Mesh ball = sphere_mesh(0.7, 9);
    for (const glm::vec3& n : ball.normals) ball.colors.push_back(n * 0.4f + 0.5f);
    MeshShape shape = mesh_of(ball);
    shape.scale = Vec3(1, 0.6, 1.4);
    add_with_instances(scene, shape, paint());
    expect_the_picture_of_baked_ones(scene);
}

TEST(Instances, OfMeshesSmoothedHereShowWhatBakedOnesShow) {
    SceneDescription scene = studio();
    MeshShape shape = mesh_of(box_mesh(Vec3(0), Vec3(0.9, 0.7, 1.1)));
    shape.normals = NormalsMode::smooth;
    shape.scale = Vec3(1, 2, -0.5);
    Object& mesh = add(scene, shape, paint());
    mesh.name = "mesh";
    for (unsigned i = 0; i < 4; ++i) {
        Object& copy = add(scene, InstanceShape{"mesh"}, std::string());
        copy.transform = rotation(i);
        copy.transform[3] = {-2.1 + 1.31 * i, -1.4, 0.3, 1};
    }
    expect_the_picture_of_baked_ones(scene);
}

TEST(Instances, LitAsStoredShowWhatBakedOnesShow) {
    SceneDescription scene = studio();
    Mesh open = box_mesh(Vec3(0), Vec3(1.1));
    open.triangles.resize(8);
    MeshShape shape = mesh_of(open);
    shape.facing = Facing::stored;
    add_with_instances(scene, shape, paint());
    expect_the_picture_of_baked_ones(scene);
}

/// A mesh with smooth normals, squeezed and sheared, shown itself or by an instance.
SceneDescription sheared_box(bool by_instance) {
    SceneDescription scene = studio();
    MeshShape shape = mesh_of(box_mesh(Vec3(0), Vec3(0.9, 1.7, 1.1)));
    shape.normals = NormalsMode::smooth;
    shape.scale = Vec3(1.5, 0.6, 1);
    Object& mesh = add(scene, shape, paint());
    mesh.name = "mesh";
    mesh.visible = !by_instance;
    mesh.transform = rotation(3);
    mesh.transform[1][0] += 0.4;
    if (by_instance) add(scene, InstanceShape{"mesh"}, std::string());
    return scene;
}

TEST(Instances, ThatNobodySeesChangeNoBit) {
    for (const bool by_instance : {false, true}) {
        SceneDescription scene = sheared_box(by_instance);
        const Picture alone = rendered(scene);
        add(scene, InstanceShape{"mesh"}, std::string()).transform[3] = {0, -50, 30, 1};
        EXPECT_EQ(rendered(scene).image.pixels, alone.image.pixels) << by_instance;
    }
}

TEST(Instances, AndMeshesHaveTheSameSmoothNormals) {
    const Picture mesh = rendered(sheared_box(false));
    const Picture instance = rendered(sheared_box(true));
    EXPECT_LE(compare(instance.image, mesh.image, 1.0 / 255.0, 1.0).share, 0.001);
}

TEST(Instances, LitAsStoredAndMirroredAreLitAsTheirMirrorImages) {
    for (const bool by_instance : {false, true}) {
        SceneDescription scene = studio();
        MeshShape shape = mesh_of(box_mesh(Vec3(0), Vec3(1.1)));
        shape.facing = Facing::stored;
        Object& mesh = add(scene, shape, paint());
        mesh.name = "mesh";
        mesh.visible = !by_instance;
        if (by_instance) add(scene, InstanceShape{"mesh"}, std::string());
        const Picture plain = rendered(scene);
        scene.objects.back().transform[0] *= -1.0; // a box is its own mirror image
        EXPECT_LE(compare(rendered(scene).image, plain.image, 1.0 / 255.0, 1.0).share, 0.001) << by_instance;
    }
}

TEST(Instances, OfGlassShowWhatBakedOnesShow) {
    SceneDescription scene = studio();
    Material tinted = glass(1.3, 0.9);
    tinted.absorption = Vec3(0.3, 0.1, 0.6);
    tinted.fresnel = true;
    add_with_instances(scene, mesh_of(box_mesh(Vec3(0), Vec3(1.2, 0.9, 0.8))), tinted);
    expect_the_picture_of_baked_ones(scene);
}

TEST(Instances, FarFromTheOriginShowWhatBakedOnesShow) {
    SceneDescription scene = studio();
    add_with_instances(scene, mesh_of(sphere_mesh(0.7, 9)), paint());
    const Vec3 far(3000, -5000, 2000);
    scene.camera->eye += far;
    std::get<PointLight>(scene.lights[0].kind).position += far;
    std::get<PlaneShape>(scene.objects[0].shape).offset += far.z;
    for (std::size_t i = 1; i < scene.objects.size(); ++i) {
        Mat4 there(1.0), back(1.0);
        there[3] = glm::dvec4(far, 1);
        back[3] = glm::dvec4(-far, 1);
        Mat4& m = scene.objects[i].transform;
        m = i == 1 ? there * m : there * m * back;
    }
    expect_the_picture_of_baked_ones(scene);
}

/// Two glass boxes of one mesh that share a quarter of their space, mirrored and inside out.
SceneDescription two_boxes() {
    SceneDescription scene = empty_scene();
    scene.render.background = Vec3(1);
    Mesh box = box_mesh(Vec3(0), Vec3(2));
    for (glm::uvec3& t : box.triangles) std::swap(t.x, t.y);
    Object& mesh = add(scene, mesh_of(box), glass(1.5));
    mesh.name = "box";
    mesh.visible = false;
    for (const double x : {-0.5, 0.5}) {
        Material material = glass(x < 0 ? 1.5 : 1.2);
        material.absorption = x < 0 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
        Object& copy = add(scene, InstanceShape{"box"}, material);
        if (x > 0) copy.transform[1][1] = -1;
        copy.transform[3] = {x, 0, 0, 1};
    }
    return scene;
}

TEST(Instances, AreSolidsThatLightEntersAndLeaves) {
    const Look seen = look(two_boxes(), Vec3(-4, 0.31, 0.23), Vec3(1, 0, 0));
    ASSERT_EQ(seen.tree.nodes.size(), 4u);
    const float expected[][2] = {{1, 1.5f}, {1.5f, 1.2f}, {1.2f, 1}};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(seen.node(i).index_before, expected[i][0]) << i;
        EXPECT_EQ(seen.node(i).index_after, expected[i][1]) << i;
    }
    EXPECT_NEAR(seen.light.x, std::exp(-1.0), 1e-6);
    EXPECT_NEAR(seen.light.y, std::exp(-2.0), 1e-6);
}

TEST(Instances, AreAroundThePointsWithinThem) {
    const Scene scene = build_scene(two_boxes());
    using Ids = std::vector<std::uint32_t>;
    EXPECT_EQ(objects_around(scene.data(), vec3(-1, 0, 0)), Ids{1});
    EXPECT_EQ(objects_around(scene.data(), vec3(0, 0, 0)), (Ids{1, 2}));
    EXPECT_EQ(objects_around(scene.data(), vec3(1, 0, 0)), Ids{2});
    EXPECT_TRUE(objects_around(scene.data(), vec3(2, 0, 0)).empty());
}

TEST(Instances, TakeTheMemoryOfTheirMeshOnce) {
    SceneDescription scene = empty_scene();
    add(scene, mesh_of(sphere_mesh(1, 50)), matte()).name = "ball";
    const std::uint64_t one = build_scene(scene).stats().bytes;
    for (int i = 0; i < 1000; ++i)
        add(scene, InstanceShape{"ball"}, std::string()).transform[3] = {3.0 * i, 0, 0, 1};
    const SceneStats stats = build_scene(scene).stats();
    EXPECT_LT(stats.bytes, 3 * one);
    EXPECT_EQ(stats.triangles, 1001u * 9800u);
}

} // namespace
} // namespace glint::rendering
