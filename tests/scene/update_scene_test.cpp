// Scenes updated with other values, over the same trees.

#include "gallery.h"
#include "scene_kit.h"

#include "scene/bake.h"

#include <gtest/gtest.h>

#include <cstring>

namespace glint::scene {

using trace::World;
namespace {

using namespace kit;

BuildSceneOptions with_solids() {
    BuildSceneOptions options;
    options.find_solids = true;
    return options;
}

std::string picture_of(const Scene& scene) {
    RenderOptions options;
    options.threads = 1;
    return picture_hash(render(scene, options).image);
}

/// Do both trace the same trees? A World is nothing but a pointer to them.
bool share_trees(const Scene& a, const Scene& b) {
    return std::memcmp(&a.data().world, &b.data().world, sizeof(World)) == 0;
}

class UpdatingScenes : public testing::TestWithParam<Exhibit> {};

INSTANTIATE_TEST_SUITE_P(Gallery, UpdatingScenes, testing::ValuesIn(gallery()),
                         [](const auto& exhibit) { return exhibit.param.name; });

TEST_P(UpdatingScenes, FindingSolidsChangesNoPicture) {
    const SceneDescription& description = GetParam().scene;
    EXPECT_EQ(picture_of(build_scene(description, with_solids())), picture_of(build_scene(description)));
}

TEST_P(UpdatingScenes, OtherValuesGiveThePictureOfAFreshSceneOverTheSameTrees) {
    const Scene before = build_scene(GetParam().scene, with_solids());
    SceneDescription edited = before.description();
    for (Material& m : edited.materials) {
        m.color = m.color * 0.5 + Vec3(0.2, 0.1, 0);
        m.reflectivity = 0.25;
        m.transparency = m.transparency > 0 ? 0 : 0.5;
        m.index = 1.25;
    }
    for (Light& light : edited.lights)
        if (auto* point = std::get_if<PointLight>(&light.kind)) point->position.x += 0.1;
    edited.camera->eye += Vec3(0.05, -0.02, 0.01);
    edited.render.width += 7;
    edited.render.background = Vec3(0.1, 0.2, 0.3);
    edited.whitted.max_depth = 3;
    edited.whitted.index = 1.1;
    const Scene after = update_scene(before, edited);
    EXPECT_TRUE(share_trees(before, after));
    EXPECT_EQ(picture_of(after), picture_of(build_scene(edited)));
    EXPECT_EQ(picture_of(update_scene(after, before.description())), picture_of(before));
}

TEST_P(UpdatingScenes, AnotherViewGivesThePictureOfAFreshScene) {
    const Scene before = build_scene(GetParam().scene);
    SceneDescription moved = before.description();
    moved.camera->eye += Vec3(0.3, 0.2, 0.1);
    moved.camera->fov = 70;
    moved.render.width = 23;
    moved.render.height = 31;
    const Scene after = with_view(before, *moved.camera, 23, 31);
    EXPECT_TRUE(share_trees(before, after));
    EXPECT_EQ(picture_of(after), picture_of(build_scene(moved)));
}

SceneDescription box_in_the_light() {
    SceneDescription scene = empty_scene(Vec3(0, -4, 0), Vec3(0, 1, 0));
    add(scene, mesh_of(box_mesh(Vec3(0), Vec3(1))), matte());
    add(scene, PlaneShape{Vec3(0, 0, 1), -1}, matte());
    add_light(scene, Vec3(2, -3, 4), 20);
    return scene;
}

TEST(UpdateScene, AMeshBecomesGlassWithOrWithoutSolidsKnown) {
    const SceneDescription description = box_in_the_light();
    SceneDescription glassy = description;
    glassy.materials[0] = glass(1.5, 0.9);
    glassy.materials[0].name = description.materials[0].name;
    const std::string expected = picture_of(build_scene(glassy));
    const Scene known = build_scene(description, with_solids());
    const Scene unknown = build_scene(description);
    EXPECT_TRUE(share_trees(known, update_scene(known, glassy)));
    EXPECT_EQ(picture_of(update_scene(known, glassy)), expected);
    EXPECT_FALSE(share_trees(unknown, update_scene(unknown, glassy)));
    EXPECT_EQ(picture_of(update_scene(unknown, glassy)), expected);
}

TEST(UpdateScene, GlassElsewhereTurnsNoMeshThatIsLitAsStored) {
    // A box wound inside out shows its lit side by its winding, closed or not.
    SceneDescription description = box_in_the_light();
    auto mesh = std::make_shared<Mesh>(*std::get<MeshShape>(description.objects[0].shape).data);
    for (auto& t : mesh->triangles) std::swap(t.x, t.y);
    std::get<MeshShape>(description.objects[0].shape).data = mesh;
    std::get<MeshShape>(description.objects[0].shape).facing = Facing::stored;
    const std::string without = picture_of(build_scene(description));
    add(description, SphereShape{Vec3(0, 50, 0), 1}, glass(1.5));
    EXPECT_EQ(picture_of(build_scene(description)), without);
}

TEST(UpdateScene, OtherObjectsAreRebuilt) {
    const Scene before = build_scene(box_in_the_light());
    SceneDescription edited = before.description();
    edited.objects[0].transform[3][0] = 0.5;
    EXPECT_FALSE(share_trees(before, update_scene(before, edited)));
    EXPECT_EQ(picture_of(update_scene(before, edited)), picture_of(build_scene(edited)));
    edited = before.description();
    edited.objects[1].visible = false;
    EXPECT_EQ(picture_of(update_scene(before, edited)), picture_of(build_scene(edited)));
    edited.objects.pop_back();
    EXPECT_EQ(picture_of(update_scene(before, edited)), picture_of(build_scene(edited)));
}

TEST(UpdateScene, RefusesWhatBuildSceneRefuses) {
    const Scene before = build_scene(box_in_the_light());
    SceneDescription edited = before.description();
    edited.materials[0].shininess = -1;
    EXPECT_THROW(update_scene(before, edited), Error);
    edited = before.description();
    edited.objects[0].material = "nothing";
    EXPECT_THROW(update_scene(before, edited), Error);
    CameraDescription camera = before.camera();
    camera.fov = 200;
    EXPECT_THROW(with_view(before, camera, 10, 10), Error);
    EXPECT_THROW(with_view(before, before.camera(), 0, 10), Error);
}

// ── Cancelling ─────────────────────────────────────────────────────────────────────────────────────────────

ErrorKind kind_of_failure(const SceneDescription& scene, const BuildSceneOptions& options) {
    try {
        build_scene(scene, options);
    } catch (const Error& error) {
        return error.kind();
    }
    return ErrorKind::internal;
}

TEST(BuildSceneCancel, ACancelledBuildThrowsCancelled) {
    const CancelFlag cancel{true};
    BuildSceneOptions options;
    options.cancel = &cancel;
    EXPECT_EQ(kind_of_failure(box_in_the_light(), options), ErrorKind::cancelled);
}

TEST(BuildSceneCancel, AFlagSetByTheProgressEndsItAtEveryStep) {
    SceneDescription scene = box_in_the_light();
    std::get<MeshShape>(scene.objects[0].shape).data = std::make_shared<Mesh>(sphere_mesh(1, 60));
    BuildSceneOptions options;
    int steps = 0;
    options.progress = [&](const LoadProgress&) { ++steps; };
    build_scene(scene, options);
    ASSERT_GE(steps, 3);
    // What the last step tells of is done.
    for (int stop = 1; stop < steps; ++stop) {
        CancelFlag cancel{false};
        int told = 0;
        options.cancel = &cancel;
        options.progress = [&](const LoadProgress& progress) {
            EXPECT_GE(progress.fraction, 0);
            EXPECT_LE(progress.fraction, 1);
            if (++told == stop) cancel = true;
        };
        EXPECT_EQ(kind_of_failure(scene, options), ErrorKind::cancelled) << stop;
    }
}

TEST(BuildSceneCancel, BakingMayEndBeforeEveryObjectAndEveryPassOverAMesh) {
    SceneDescription scene = box_in_the_light();
    Object ball = scene.objects[0];
    std::get<MeshShape>(ball.shape).data = std::make_shared<Mesh>(sphere_mesh(1, 6));
    scene.objects = {ball, ball, ball};
    int asked = 0;
    bake(scene, true, [&] { ++asked; });
    // Once an object; moved, its normals, its edges, its volume.
    EXPECT_GE(asked, 3 * 4);
    struct Enough {};
    for (int last = 1; last <= asked; ++last) {
        int now = 0;
        EXPECT_THROW(bake(scene, true,
                          [&] {
                              if (++now == last) throw Enough();
                          }),
                     Enough);
        EXPECT_EQ(now, last);
    }
}

TEST(BuildSceneCancel, AFlagThatIsNotSetChangesNothing) {
    const CancelFlag cancel{false};
    BuildSceneOptions options;
    options.cancel = &cancel;
    EXPECT_EQ(picture_of(build_scene(box_in_the_light(), options)),
              picture_of(build_scene(box_in_the_light())));
}

} // namespace
} // namespace glint::scene
