// What a device cannot hold is refused by name and with the sizes, and nothing is left behind.

#include "gallery.h"
#include "gpu_kit.h"
#include "scene_kit.h"

#include "gpu/context.h"
#include "gpu/program.h"

#include <gtest/gtest.h>

namespace glint::gpu {
namespace {

/// A renderer whose buffers hold so many bytes.
std::unique_ptr<GpuRenderer> renderer_with(std::uint64_t bytes) {
    GpuLimits limits;
    limits.buffer = bytes;
    return std::make_unique<GpuRenderer>(-1, limits);
}

/// A scene in which a part takes much more than all before it, in the order in which they are laid out.
struct Large {
    std::string part;
    std::uint64_t bytes; ///< that it does not fit into
    SceneDescription scene;
};

SceneDescription many_lights(int count) {
    SceneDescription scene = kit::empty_scene();
    kit::add(scene, SphereShape{Vec3(0, 9, 0), 0.1}, kit::matte());
    for (int i = 0; i < count; ++i) kit::add_light(scene, Vec3(i % 40, 5, i / 40));
    return scene;
}

/// One object of so many spheres.
SceneDescription cloud(int count) {
    Mesh mesh;
    for (int i = 0; i < count; ++i)
        mesh.positions.emplace_back(0.3f * static_cast<float>(i % 40) - 6, 9.0f,
                                    0.3f * static_cast<float>(i / 40) - 6);
    MeshShape shape = kit::mesh_of(mesh);
    shape.point_radius = 0.1;
    SceneDescription scene = kit::empty_scene();
    kit::add(scene, shape, kit::matte());
    return scene;
}

SceneDescription one_mesh() {
    SceneDescription scene = kit::empty_scene();
    kit::add(scene, kit::mesh_of(kit::sphere_mesh(1, 40)), kit::matte());
    return scene;
}

SceneDescription planes(int count) {
    SceneDescription scene = kit::empty_scene();
    kit::add(scene, PlaneShape{Vec3(0, 0, 1), -1}, kit::matte());
    const std::string material = scene.materials.front().name;
    for (int i = 1; i < count; ++i) kit::add(scene, PlaneShape{Vec3(0, 0, 1), -1.0 - i}, material);
    return scene;
}

/// A mesh of many vertices with normals and colours, few of which its triangles use.
SceneDescription colored_mesh() {
    Mesh mesh = kit::sphere_mesh(1, 4);
    for (int i = 0; i < 5000; ++i) {
        mesh.positions.emplace_back(0.0f, 0.0f, 0.0f);
        mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
    }
    mesh.colors.assign(mesh.positions.size(), glm::vec3(0.5f));
    SceneDescription scene = kit::empty_scene();
    kit::add(scene, kit::mesh_of(mesh), kit::matte());
    return scene;
}

TEST(GpuLimits, EachPartOfASceneIsRefusedByNameWithItsSizes) {
    GLINT_NEEDS_GPU();
    const Large parts[] = {
        {"the tree's nodes", 1000, one_mesh()},
        {"the scene's triangles", 80000, one_mesh()},
        {"the scene's objects", 20000, planes(1000)},
        {"the meshes' normals and colours", 50000, colored_mesh()},
        {"the scene's lights", 50000, many_lights(1000)},
        {"the scene's planes and quadrics", 60000, cloud(1500)},
    };
    for (const Large& large : parts) {
        const auto renderer = renderer_with(large.bytes);
        const Scene scene = build_scene(large.scene);
        const std::string said = refusal([&] { renderer->prepare(scene); });
        EXPECT_NE(said.find(large.part + " take "), std::string::npos) << large.part << ": " << said;
        EXPECT_NE(said.find(" holds " + std::to_string(large.bytes)), std::string::npos) << said;
        EXPECT_NE(said.find("render on the CPU"), std::string::npos) << said;
        EXPECT_THROW(renderer->render(), Error) << "nothing is prepared";
    }
}

TEST(GpuLimits, MoreThanTheDeviceAllowsIsWhatItAllows) {
    GLINT_NEEDS_GPU();
    EXPECT_EQ(renderer_with(std::uint64_t{1} << 60)->device().max_buffer, gpu()->device().max_buffer);
    EXPECT_EQ(renderer_with(60000)->device().max_buffer, 60000u);
}

TEST(GpuLimits, ARefusedSceneLeavesRoomForTheNext) {
    GLINT_NEEDS_GPU();
    const auto renderer = renderer_with(60000);
    const Scene scene = build_scene(kit::gallery().front().scene);
    renderer->prepare(scene);
    const std::string hash = picture_hash(renderer->render().image);
    EXPECT_NE(refusal([&] { renderer->prepare(build_scene(one_mesh())); }), "nothing was refused");
    renderer->prepare(scene);
    EXPECT_EQ(picture_hash(renderer->render().image), hash);
}

TEST(GpuLimits, PicturesAreCutIntoTilesThatFit) {
    GLINT_NEEDS_GPU();
    SceneDescription description = kit::gallery().front().scene;
    description.render.width = 50;
    description.render.height = 43;
    const Scene scene = build_scene(description);
    gpu()->prepare(scene);
    RenderOptions options;
    options.terms = true;
    const std::string whole = picture_hash(gpu()->render(options).image);
    // Some rows of squares, some squares of a row, and one square at a time.
    for (const std::uint64_t bytes : {600000u, 200000u, 60000u}) {
        const auto renderer = renderer_with(bytes);
        renderer->prepare(scene);
        EXPECT_EQ(picture_hash(renderer->render(options).image), whole) << bytes;
    }
}

TEST(GpuLimits, SpentMemoryIsToldWithWhatItWasFor) {
    GLINT_NEEDS_GPU();
    constexpr std::size_t bytes = std::size_t{1} << 46; // more than any machine has
    GpuContext context(-1);
    context.set_max_buffer(bytes);
    const GpuScope scope(context);
    const std::string said = refusal([&] { const GpuBuffer buffer(context, "the pixels", nullptr, bytes); });
    EXPECT_NE(said.find("ran out of memory while taking 70368744177664 bytes for the pixels"),
              std::string::npos)
        << said;
    EXPECT_NE(said.find("render on the CPU"), std::string::npos) << said;
}

TEST(GpuLimits, ScenesOverTheSameTreeKeepIt) {
    GLINT_NEEDS_GPU();
    SceneDescription description = kit::gallery().front().scene;
    const Scene first = build_scene(description);
    description.materials.front().color = Vec3(0.1, 0.9, 0.4);
    description.whitted.max_depth += 1;
    const Scene second = update_scene(first, description);
    gpu()->prepare(build_scene(description));
    const std::string anew = picture_hash(gpu()->render().image);
    gpu()->prepare(first);
    const std::string before = picture_hash(gpu()->render().image);
    gpu()->prepare(second);
    EXPECT_EQ(picture_hash(gpu()->render().image), anew);
    EXPECT_NE(anew, before);
    gpu()->prepare(first);
    EXPECT_EQ(picture_hash(gpu()->render().image), before);
}

} // namespace
} // namespace glint::gpu
