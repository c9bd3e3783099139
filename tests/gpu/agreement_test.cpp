// The GPU's pictures against the CPU's: at least 99.9 % of the pixels within 1/255, and those within 1e-5 on
// average.

#include "gallery.h"
#include "gpu_kit.h"

#include "glint/formats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <tuple>

namespace glint {
namespace {

namespace fs = std::filesystem;

const fs::path scenes = fs::path(GLINT_SOURCE_DIR) / "scenes";
const fs::path models = fs::path(GLINT_SOURCE_DIR) / ".." / "shared" / "models";

std::vector<fs::path> scene_files(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// The scene at 160×120, or nothing where it shows a mesh that was not made.
std::optional<SceneDescription> small_scene(const fs::path& file, int most_samples) {
    LoadOptions options;
    options.allow_outside = true;
    if (file.stem().string().rfind("cat", 0) == 0) {
        if (!fs::exists(models / "cat-2.ply")) return std::nullopt;
        options.overrides.push_back("mesh.cat.file=" + (models / "cat-2.ply").string());
    }
    options.load_meshes = false;
    for (const Object& object : load_scene(file.string(), options).description.objects) {
        const auto* mesh = std::get_if<MeshShape>(&object.shape);
        if (mesh != nullptr && !fs::exists(file.parent_path() / mesh->file)) return std::nullopt;
    }
    options.load_meshes = true;
    SceneDescription scene = load_scene(file.string(), options).description;
    scene.render.width = 160;
    scene.render.height = 120;
    scene.render.spp = std::min(scene.render.spp, most_samples);
    return scene;
}

void expect_folder_agrees(const fs::path& folder, int most_samples) {
    std::size_t compared = 0;
    for (const fs::path& file : scene_files(folder)) {
        const std::optional<SceneDescription> scene = small_scene(file, most_samples);
        if (!scene) {
            std::printf("skipped: %s shows a mesh that is not there\n", file.filename().c_str());
            continue;
        }
        expect_agreement(*scene, file.filename().string());
        ++compared;
    }
    EXPECT_GE(compared, 10u);
}

TEST(GpuAgreement, ScenesOfTheReportLookAsOnTheCpu) {
    GLINT_NEEDS_GPU();
    expect_folder_agrees(scenes / "report", 1);
}

TEST(GpuAgreement, ScenesOfTheGalleryLookAsOnTheCpu) {
    GLINT_NEEDS_GPU();
    expect_folder_agrees(scenes, 1);
}

TEST(GpuAgreement, ScenesOfManySamplesLookAsOnTheCpu) {
    GLINT_NEEDS_GPU();
    // Most of the drink's pixels have hundreds of rays: fewer pixels will do.
    for (const auto& [name, width, height] :
         {std::tuple("drink.toml", 64, 48), std::tuple("mirrors.toml", 160, 120)}) {
        std::optional<SceneDescription> scene = small_scene(scenes / name, 4);
        ASSERT_TRUE(scene && scene->render.spp == 4) << name;
        scene->render.width = width;
        scene->render.height = height;
        expect_agreement(*scene, name);
    }
}

TEST(GpuAgreement, EveryKindOfObjectLightAndMaterialLooksAsOnTheCpu) {
    GLINT_NEEDS_GPU();
    for (kit::Exhibit exhibit : kit::gallery()) {
        exhibit.scene.render.width = 160;
        exhibit.scene.render.height = 120;
        expect_agreement(exhibit.scene, exhibit.name);
    }
}

TEST(GpuAgreement, EveryFilterLooksAsOnTheCpu) {
    GLINT_NEEDS_GPU();
    SceneDescription scene = kit::gallery().front().scene;
    for (const PixelFilter filter :
         {PixelFilter::box, PixelFilter::tent, PixelFilter::gaussian, PixelFilter::mitchell}) {
        for (const int samples : {2, 15, 19}) {
            scene.render.filter = filter;
            scene.render.spp = samples;
            scene.render.seed = 0x123456789abcdefULL;
            expect_agreement(scene, "filter " + std::to_string(static_cast<int>(filter)) + ", " +
                                        std::to_string(samples) + " samples");
        }
    }
}

} // namespace
} // namespace glint
