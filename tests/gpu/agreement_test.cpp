// The GPU's pictures against the CPU's: at least 99.9 % of the pixels within 1/255, and those within 1e-5 on
// average.

#include "closed_solids.h"
#include "gallery.h"
#include "gpu_kit.h"
#include "scene_kit.h"

#include "glint/scene_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <tuple>

namespace glint::gpu {
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

std::string word_of(const fs::path& file) {
    std::string name = file.stem().string();
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return name;
}

const fs::path cat = models / "cat-2.ply";

bool shows_the_cat(const fs::path& file) { return file.stem().string().rfind("cat", 0) == 0; }

/// The scene at 160×120; one whose mesh was not made is an error.
SceneDescription small_scene(const fs::path& file, int samples) {
    LoadOptions options;
    options.allow_outside = true;
    if (shows_the_cat(file)) options.overrides.push_back("mesh.cat.file=" + cat.string());
    SceneDescription scene = load_scene(file.string(), options).description;
    scene.render.width = 160;
    scene.render.height = 120;
    scene.render.spp = samples;
    return scene;
}

class GpuScenes : public testing::TestWithParam<fs::path> {};

TEST_P(GpuScenes, LookAsOnTheCpu) {
    GLINT_NEEDS_GPU();
    if (shows_the_cat(GetParam()) && !fs::exists(cat)) GTEST_SKIP() << "there is no " << cat;
    SceneDescription scene = small_scene(GetParam(), 1);
    scene.render.integrator = Integrator::whitted; // others have no shader
    expect_agreement(scene, GetParam().filename().string());
}

std::string name_of(const testing::TestParamInfo<fs::path>& file) { return word_of(file.param); }

INSTANTIATE_TEST_SUITE_P(Report, GpuScenes, testing::ValuesIn(scene_files(scenes / "report")), name_of);
INSTANTIATE_TEST_SUITE_P(Gallery, GpuScenes, testing::ValuesIn(scene_files(scenes)), name_of);

TEST(GpuAgreement, ScenesOfManySamplesLookAsOnTheCpu) {
    GLINT_NEEDS_GPU();
    // Most of the drink's pixels have hundreds of rays: fewer pixels will do.
    for (const auto& [name, width, height] :
         {std::tuple("drink.toml", 64, 48), std::tuple("mirrors.toml", 160, 120)}) {
        SceneDescription scene = small_scene(scenes / name, 4);
        scene.render.width = width;
        scene.render.height = height;
        expect_agreement(scene, name);
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

TEST(GpuAgreement, SurfacesInOnePlaceLookAsOnTheCpu) {
    GLINT_NEEDS_GPU();
    SceneDescription scene = kit::empty_scene(Vec3(0), Vec3(0, 1, 0), 96, 50);
    scene.render.background = Vec3(0.5, 0.6, 0.8);
    const auto paint = [](double red, double mirror) {
        Material m = kit::matte(0.6);
        m.color = Vec3(red, 1 - red, 0.5);
        m.reflectivity = mirror;
        return m;
    };
    Material clear = kit::glass(1.5, 0.8);
    clear.fresnel = true;
    const auto stands = [](double x, double y) {
        return PolyhedronShape{PolyhedronKind::box, Vec3(x, y, 0.5), Vec3(1)};
    };
    kit::add(scene, kit::mesh_of(kit::box_mesh(Vec3(0, 0, 0.5), Vec3(1))), clear).name = "cube";
    kit::add(scene, stands(1.5, 0), clear);
    kit::add(scene, PlaneShape{}, paint(0.3, 0.3));
    kit::add(scene, RectangleShape{Vec3(-1.5, -1.5, 0), Vec3(2, 0, 0), Vec3(0, 2, 0)}, paint(0.9, 0));
    kit::add(scene, stands(-1.5, 1.5), paint(0.6, 0));
    kit::add(scene, InstanceShape{"cube"}, kit::glass(1.3, 0.7)).transform[3] = dvec4(0.3, 0.2, 1, 1);
    kit::add(scene, SphereShape{Vec3(1.5, -1.5, 0.5), 0.5}, clear);
    kit::add_light(scene, Vec3(-3, -4, 6), 40);
    for (const Vec3& eye : {Vec3(2.3, -5, 3), Vec3(-4, 3, 1), Vec3(1, -3, -4)}) {
        scene.camera->eye = eye;
        scene.camera->direction = -eye;
        expect_agreement(scene, "from z = " + std::to_string(eye.z));
    }
}

TEST(GpuAgreement, ScenesFarFromZeroLookAsOnTheCpu) {
    GLINT_NEEDS_GPU();
    for (const kit::Exhibit& exhibit : kit::gallery())
        if (exhibit.name == "instances" || exhibit.name == "spots")
            expect_agreement(kit::moved(exhibit.scene, Vec3(5e5, 5.4e6, 312)), exhibit.name);
}

TEST(GpuAgreement, NoRayLeavesAClosedSolid) {
    GLINT_NEEDS_GPU();
    const auto expect_all = [](const std::vector<kit::Exhibit>& solids, float right) {
        for (kit::Exhibit solid : solids) {
            solid.scene.render.width = 32;
            solid.scene.render.height = 24;
            gpu()->prepare(build_scene(solid.scene));
            const Image image = gpu()->render().image;
            EXPECT_EQ(std::count(image.pixels.begin(), image.pixels.end(), right),
                      static_cast<std::ptrdiff_t>(image.pixels.size()))
                << solid.name;
        }
    };
    expect_all(kit::mirror_rooms(), 0);
    expect_all(kit::invisible_solids(), 1);
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
} // namespace glint::gpu
