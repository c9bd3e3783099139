// Pictures that get better by and by: where they end, and what may happen on the way.

#include "glint/progressive.h"

#include "gallery.h"
#include "scene_kit.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

namespace glint::rendering {
namespace {

using namespace kit;

/// To the end, in slices of `slice` seconds.
void finish(Progressive& progressive, double slice = 10) {
    while (progressive.advance(slice)) {
    }
}

ProgressiveOptions from(int coarsest) {
    ProgressiveOptions options;
    options.coarsest = coarsest;
    return options;
}

ProgressiveOptions showing(Aov aov) {
    ProgressiveOptions options;
    options.show = aov;
    return options;
}

class Refining : public testing::TestWithParam<Exhibit> {};

INSTANTIATE_TEST_SUITE_P(Gallery, Refining, testing::ValuesIn(gallery()),
                         [](const auto& exhibit) { return exhibit.param.name; });

TEST_P(Refining, EndsWithThePictureOfRenderToTheBit) {
    for (const int spp : {1, 5, 18}) {
        SceneDescription description = GetParam().scene;
        description.render.spp = spp;
        description.render.filter = PixelFilter::mitchell; // has samples of negative weight
        const Scene scene = build_scene(description);
        const std::string expected = picture_hash(render(scene).image);
        for (const int threads : {1, 3}) {
            Progressive progressive(threads);
            progressive.start(scene, from(threads == 1 ? 8 : 1));
            finish(progressive, threads == 1 ? 10 : 0);
            EXPECT_EQ(picture_hash(progressive.image()), expected)
                << spp << " spp, " << threads << " threads";
            EXPECT_TRUE(progressive.reached().finished);
            EXPECT_EQ(progressive.reached().samples, spp == 1 ? 0 : spp);
            EXPECT_EQ(progressive.reached().fraction, 1);
        }
    }
}

SceneDescription exhibit(int spp = 4) {
    SceneDescription scene = gallery().front().scene;
    scene.render.spp = spp;
    return scene;
}

TEST(Progressive, MoreSamplesThanABatchHoldsAreStillTheSame) {
    SceneDescription description = exhibit(700);
    description.render.width = 5;
    description.render.height = 3;
    const Scene scene = build_scene(description);
    Progressive progressive(1);
    progressive.start(scene);
    finish(progressive);
    EXPECT_EQ(picture_hash(progressive.image()), picture_hash(render(scene).image));
}

TEST(Progressive, EveryAovEndsAsRenderShowsIt) {
    const Scene scene = build_scene(exhibit());
    for (int i = 0; i < aov_count; ++i) {
        const auto show = static_cast<Aov>(i);
        if (!has_aov(scene.render_settings().integrator, show)) continue;
        RenderOptions options;
        options.show = show;
        Progressive progressive(2);
        progressive.start(scene, showing(show));
        finish(progressive);
        EXPECT_EQ(picture_hash(progressive.image()), picture_hash(render(scene, options).image))
            << aov_name(show);
    }
}

TEST(Progressive, TheFirstPassShowsThePixelsThatItLookedAt) {
    SceneDescription description = exhibit();
    const Scene scene = build_scene(description);
    description.render.spp = 1;
    const Image centres = render(build_scene(description)).image;
    for (const int step : {2, 8, 64}) {
        Progressive progressive(2);
        progressive.start(scene, from(step));
        ASSERT_TRUE(progressive.advance(0));
        EXPECT_EQ(progressive.reached().step, step);
        const Image& image = progressive.image();
        ASSERT_EQ(image.width, centres.width);
        for (int y = 0; y < image.height; y += step)
            for (int x = 0; x < image.width; x += step)
                for (int c = 0; c < 3; ++c) EXPECT_EQ(image.at(x, y)[c], centres.at(x, y)[c]);
    }
}

TEST(Progressive, CancellingInTheMiddleOfAnythingLosesNothing) {
    const Scene scene = build_scene(exhibit(7));
    const std::string expected = picture_hash(render(scene).image);
    for (int delay = 0; delay < 12; ++delay) {
        CancelFlag cancel{false};
        Progressive progressive(2);
        ProgressiveOptions options;
        options.cancel = &cancel;
        progressive.start(scene, options);
        std::thread stopper([&] {
            std::this_thread::sleep_for(std::chrono::microseconds(700 * delay));
            cancel = true;
        });
        while (!cancel && progressive.advance(0)) {
        }
        stopper.join();
        cancel = false;
        finish(progressive);
        EXPECT_EQ(picture_hash(progressive.image()), expected) << "after " << delay;
    }
}

TEST(Progressive, AnotherSceneSizeOrCameraBeginsAnew) {
    Progressive progressive(2);
    for (const int size : {40, 17, 64}) {
        SceneDescription description = exhibit(3);
        description.render.width = size;
        const Scene scene = build_scene(description);
        progressive.start(scene);
        progressive.advance(0);
        EXPECT_EQ(progressive.image().width, size);
        CameraDescription camera = scene.camera();
        camera.eye.z += 0.25;
        const Scene moved = with_view(scene, camera, size, 36);
        progressive.start(moved);
        finish(progressive);
        EXPECT_EQ(picture_hash(progressive.image()), picture_hash(render(moved).image));
    }
}

TEST(Progressive, RefusesAStepThatIsNoPowerOfTwo) {
    const Scene scene = build_scene(exhibit());
    Progressive progressive(1);
    for (const int step : {0, -1, 3, 128}) EXPECT_THROW(progressive.start(scene, from(step)), Error);
    EXPECT_FALSE(progressive.advance(1)) << "nothing was started";
}

TEST(Progressive, TheWayIsToldFromNothingToTheEnd) {
    const Scene scene = build_scene(exhibit(8));
    Progressive progressive(1);
    progressive.start(scene);
    EXPECT_EQ(progressive.reached().step, 0);
    double before = -1;
    while (progressive.advance(0)) {
        EXPECT_GT(progressive.reached().fraction, before);
        EXPECT_LT(progressive.reached().fraction, 1);
        EXPECT_FALSE(progressive.reached().finished);
        before = progressive.reached().fraction;
    }
    EXPECT_EQ(progressive.reached().fraction, 1);
    EXPECT_GT(progressive.reached().rays, 0u);
}

} // namespace
} // namespace glint::rendering
