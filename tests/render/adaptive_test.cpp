// Adaptive samples: more where neighbours differ, as a function of the picture alone.

#include "render/contrast.h"
#include "render/cpu_executor.h"
#include "render/film.h"
#include "render/schedule_run.h"

#include "glint/explain.h"
#include "glint/progressive.h"

#include "gallery.h"
#include "scene_kit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace glint::rendering {
namespace {

using namespace kit;

constexpr int refined_samples = 9;

SceneDescription adaptive(SceneDescription scene, int spp) {
    scene.render.width = 37;
    scene.render.height = 29;
    scene.render.spp = spp;
    scene.render.max_spp = refined_samples;
    return scene;
}

SceneDescription fixed(SceneDescription scene, int spp) {
    scene.render.spp = spp;
    scene.render.max_spp = 0;
    return scene;
}

/// True if a channel of the pixel differs from a neighbour's by more than 1/24 on a scale of square roots.
bool has_contrast(const Image& image, int x, int y) {
    for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
        const int nx = x + dx, ny = y + dy;
        if (nx < 0 || ny < 0 || nx >= image.width || ny >= image.height) continue;
        for (int c = 0; c < 3; ++c)
            if (std::abs(std::sqrt(image.at(x, y)[c]) - std::sqrt(image.at(nx, ny)[c])) > 1.0f / 24)
                return true;
    }
    return false;
}

class Adaptive : public testing::TestWithParam<Exhibit> {};

INSTANTIATE_TEST_SUITE_P(Gallery, Adaptive, testing::ValuesIn(gallery()),
                         [](const auto& exhibit) { return exhibit.param.name; });

TEST_P(Adaptive, APixelHasTheMostSamplesIfItDiffersFromANeighbourElseTheFewest) {
    for (const int spp : {1, 3}) {
        const SceneDescription scene = adaptive(GetParam().scene, spp);
        const Image few = rendered(fixed(scene, spp)).image;
        const Image many = rendered(fixed(scene, refined_samples)).image;
        const Picture picture = rendered(scene);
        std::uint64_t samples = 0;
        for (int y = 0; y < few.height; ++y)
            for (int x = 0; x < few.width; ++x) {
                const bool refined = has_contrast(few, x, y);
                for (int c = 0; c < 3; ++c)
                    ASSERT_EQ(picture.image.at(x, y)[c], (refined ? many : few).at(x, y)[c])
                        << x << ", " << y << ", refined: " << refined;
                samples += static_cast<std::uint64_t>(spp + (refined ? refined_samples : 0));
            }
        EXPECT_EQ(picture.stats.primary_rays, samples);
    }
}

TEST_P(Adaptive, ThePictureDependsOnNeitherTilesNorThreadsNorCropsNorPasses) {
    const SceneDescription scene = adaptive(GetParam().scene, 2);
    const Image expected = rendered(scene).image;
    RenderOptions options;
    options.threads = 3;
    options.tile_size = 5;
    options.terms = true;
    options.coarse_first = true;
    EXPECT_EQ(rendered(scene, options).image.pixels, expected.pixels);
    options.crop = Rect{3, 0, 11, 20};
    const Picture part = rendered(scene, options);
    ASSERT_EQ(part.image.width, 11);
    ASSERT_EQ(part.image.height, 20);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 11; ++x)
            for (int c = 0; c < 3; ++c) {
                ASSERT_EQ(part.image.at(x, y)[c], expected.at(x + 3, y)[c]) << x << ", " << y;
                ASSERT_EQ(part.terms[0].pixels.size(), part.image.pixels.size());
            }
    Progressive progressive(2);
    progressive.start(build_scene(scene));
    while (progressive.advance(0)) {
    }
    EXPECT_EQ(progressive.image().pixels, expected.pixels);
}

TEST_P(Adaptive, AnExplanationHasTheBitsOfThePixel) {
    for (const int spp : {1, 2}) {
        const Scene scene = build_scene(adaptive(GetParam().scene, spp));
        const Image image = render(scene).image;
        for (const auto& [x, y] : {std::pair{0, 0}, {36, 28}, {18, 14}, {12, 14}, {9, 20}, {25, 7}}) {
            const Explanation explained = explain(scene, x, y);
            for (int c = 0; c < 3; ++c)
                EXPECT_EQ(explained.color[c], image.at(x, y)[c]) << x << ", " << y << ": " << explained.rule;
        }
    }
}

TEST(Adaptive, ChangesNothingWhereNothingDiffers) {
    SceneDescription scene = adaptive(in_sky(), 1);
    const Picture picture = rendered(scene);
    EXPECT_EQ(picture.stats.primary_rays, 37u * 29u);
    EXPECT_EQ(explain(build_scene(scene), 5, 5).samples.size(), 1u);
}

TEST(Adaptive, SeesTheOutlineOfWhatIsBlackInItsCoverage) {
    SceneDescription scene = adaptive(empty_scene(Vec3(0, -3, 0)), 1);
    add(scene, SphereShape{}, black());
    RenderOptions options;
    options.coverage = true;
    const std::vector<float> coverage = rendered(scene, options).coverage;
    EXPECT_TRUE(std::any_of(coverage.begin(), coverage.end(), [](float c) { return c > 0 && c < 1; }));
}

TEST(Adaptive, CancelledSavedAndLoadedFilmsEndWithTheSameBits) {
    const Scene scene = build_scene(adaptive(gallery().front().scene, 2));
    RenderOptions options;
    options.tile_size = 8;
    options.terms = true;
    options.coverage = true;
    options.crop = Rect{2, 3, 21, 13};
    const Picture expected = render(scene, options);
    std::mt19937 random(5);
    parallel::TaskPool pool(1);
    for (int trial = 0; trial < 8; ++trial) {
        Film film(film_layout(scene.render_settings(), options));
        const std::vector<Pass> passes = trial % 2 == 0 ? picture_passes(film.layout().samples, options)
                                                        : refining_passes(2, film.layout().samples);
        while (!film.is_complete()) {
            CancelFlag cancel{false};
            int steps = 1 + static_cast<int>(random() % 60);
            CpuExecutor executor(scene.data(), film, pool, {}, &cancel);
            ScheduleRun run(executor, passes, &cancel, [&](const Progress&) { cancel = --steps < 0; });
            run.run(no_deadline);
            film = Film::load(film.save());
        }
        EXPECT_EQ(film.save(), Film::load(film.save()).save());
        Picture picture;
        film.move_to(picture);
        EXPECT_EQ(picture.image.pixels, expected.image.pixels) << trial;
        EXPECT_EQ(picture.coverage, expected.coverage) << trial;
        for (std::size_t t = 0; t < expected.terms.size(); ++t)
            EXPECT_EQ(picture.terms[t].pixels, expected.terms[t].pixels) << trial;
    }
}

TEST(Adaptive, APartOfAPictureCannotBeRefined) {
    const Scene scene = build_scene(adaptive(gallery().front().scene, 1));
    Film film(film_layout(scene.render_settings(), {}));
    parallel::TaskPool pool(1);
    CpuExecutor executor(scene.data(), film, pool, {}, nullptr, {0, 2});
    ScheduleRun run(executor, picture_passes(film.layout().samples, {}));
    EXPECT_THROW(run.run(no_deadline), Error);
}

TEST(Contrast, IsMeasuredOnAScaleOfSquareRoots) {
    const auto gray = [](double root) { return vec3(static_cast<float>(root * root)); };
    for (const double root : {0.0, 0.3, 1.0, 5.0}) {
        EXPECT_TRUE(differ(gray(root), gray(root + 0.0418)));
        EXPECT_TRUE(differ(gray(root + 0.0418), gray(root)));
        EXPECT_FALSE(differ(gray(root), gray(root + 0.0415)));
    }
    EXPECT_TRUE(differ(vec3(0, 0, 1), vec3(0, 0, 0.9)));
    EXPECT_FALSE(differ(vec3(-1), vec3(0)));
    const float infinite = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(differ(vec3(infinite), vec3(1)));
    EXPECT_FALSE(differ(vec3(infinite), vec3(infinite)));
}

} // namespace
} // namespace glint::rendering
