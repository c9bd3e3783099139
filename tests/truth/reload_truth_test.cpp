// G16: a mesh that went through a file is the same mesh, bit for bit.

#include "gallery.h"
#include "scene_kit.h"

#include "glint/image.h"
#include "glint/mesh_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace glint {
namespace {

using namespace kit;

/// The scene with each of its meshes written and read again.
SceneDescription reloaded(SceneDescription scene, PlyFormat format, const std::filesystem::path& file) {
    for (Object& object : scene.objects) {
        auto* shape = std::get_if<MeshShape>(&object.shape);
        if (shape == nullptr) continue;
        write_ply(file.string(), *shape->data, format);
        shape->data = load_mesh(file.string()).mesh;
    }
    return scene;
}

TEST(G16, AMeshReloadedFromPlyGivesTheSamePicture) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "glint_reload_truth.ply";
    int meshes = 0;
    for (const Exhibit& exhibit : gallery()) {
        const bool has_mesh =
            std::any_of(exhibit.scene.objects.begin(), exhibit.scene.objects.end(),
                        [](const Object& o) { return std::holds_alternative<MeshShape>(o.shape); });
        if (!has_mesh) continue;
        ++meshes;
        const std::string expected = picture_hash(rendered(exhibit.scene).image);
        for (const PlyFormat format :
             {PlyFormat::ascii, PlyFormat::binary_little_endian, PlyFormat::binary_big_endian})
            EXPECT_EQ(picture_hash(rendered(reloaded(exhibit.scene, format, file)).image), expected)
                << exhibit.name << ", format " << static_cast<int>(format);
    }
    std::filesystem::remove(file);
    EXPECT_GE(meshes, 4);
}

} // namespace
} // namespace glint
