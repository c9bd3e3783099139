// The scenes that come with glint are sound.

#include "../kit/temporary_folder.h"

#include "glint/picture_files.h"
#include "glint/render.h"
#include "glint/scene_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace glint::rendering {
namespace {

namespace fs = std::filesystem;

const fs::path scenes = fs::path(GLINT_SOURCE_DIR) / "scenes";
const fs::path shared = fs::path(GLINT_SOURCE_DIR) / ".." / "shared";

std::vector<fs::path> scene_files(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

LoadedScene load_without_meshes(const fs::path& file) {
    LoadOptions options;
    options.load_meshes = false;
    return load_scene(file.string(), options);
}

TEST(Scenes, AreAtLeastTenAndAllFiguresOfTheReport) {
    EXPECT_GE(scene_files(scenes).size(), 10u);
    EXPECT_EQ(scene_files(scenes / "report").size(), 18u);
}

TEST(Scenes, LoadWithoutWarnings) {
    std::vector<fs::path> files = scene_files(scenes);
    for (const fs::path& file : scene_files(scenes / "report")) files.push_back(file);
    for (const fs::path& file : files) {
        const LoadedScene scene = load_without_meshes(file);
        EXPECT_TRUE(scene.warnings.empty()) << to_string(scene.warnings.front());
        EXPECT_TRUE(scene.description.camera.has_value()) << file;
        const bool needs_lights = scene.description.render.integrator == Integrator::whitted;
        EXPECT_TRUE(!needs_lights || !scene.description.lights.empty()) << file;
    }
}

TEST(Scenes, GiveNothingToWarnOf) {
    for (const fs::path& file : scene_files(scenes)) {
        const std::vector<Diagnostic> found = warnings(build_scene(load_scene(file.string()).description));
        EXPECT_TRUE(found.empty()) << to_string(found.front());
    }
}

TEST(Scenes, BeginWithASentence) {
    // The gallery takes it from there.
    for (const fs::path& file : scene_files(scenes)) {
        const std::string text = text_of(file);
        EXPECT_EQ(text.substr(0, 2), "# ") << file;
        EXPECT_EQ(text[text.find('\n') - 1], '.') << file;
    }
}

TEST(Scenes, TellHowToMakeAMeshThatIsMissing) {
    const std::string text =
        "version = 1\n[material.m]\n[[mesh]]\nfile = \"meshes/no.ply\" # missing? `scripts/gallery "
        "--meshes` makes it\nmaterial = \"m\"\n";
    try {
        parse_scene(text, (scenes / "unwritten.toml").string());
        FAIL() << "loaded a mesh that is not there";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
        EXPECT_NE(std::string(error.what()).find("`scripts/gallery --meshes` makes it"), std::string::npos)
            << error.what();
    }
}

// The figures against pictures of the original's own arithmetic (docs/light-model.md tells where they
// differ).
struct Figure {
    const char* name;
    double mae;   ///< of 255
    double share; ///< of the pixels may differ by more than 1
};

constexpr Figure figures[] = {
    {"diffuse", 0.02, 0.001},        {"specular", 0.02, 0.001},     {"high_5_0.5", 0.02, 0.001},
    {"high_5_0.75", 0.02, 0.001},    {"high_10_0.5", 0.02, 0.001},  {"high_100_0.5", 0.02, 0.001},
    {"high_100_0.75", 0.02, 0.001},  {"cylinder", 0.25, 0.015},     {"transparency", 0.25, 0.03},
    {"transparency2", 0.25, 0.03},   {"transparency3", 0.25, 0.03}, {"cat_plain", 0.02, 0.0011},
    {"cat_reflective", 0.02, 0.0011}};

TEST(Scenes, FiguresMatchThoseOfTheReport) {
    if (!fs::exists(shared / "reference")) GTEST_SKIP() << "no reference pictures in " << shared;
    const test::TemporaryFolder folder;
    for (const Figure& figure : figures) {
        LoadOptions options;
        options.allow_outside = true;
        if (std::string(figure.name).rfind("cat", 0) == 0) {
            options.overrides.push_back("mesh.cat.file=" + (shared / "models" / "cat-2.ply").string());
        }
        const fs::path file = scenes / "report" / (std::string(figure.name) + ".toml");
        const Picture picture = render(build_scene(load_scene(file.string(), options).description));
        const std::string copy = folder.at("figure.png");
        PictureOptions raw;
        raw.view = View::raw;
        write_picture(copy, picture.image, raw);
        const fs::path reference = shared / "reference" / (std::string(figure.name) + ".png");
        const PictureDifference d = diff_pictures(read_picture(copy), read_picture(reference.string()), 1);
        EXPECT_LT(d.comparison.mae, figure.mae) << figure.name;
        EXPECT_LT(d.comparison.share, figure.share) << figure.name;
    }
}

} // namespace
} // namespace glint::rendering
