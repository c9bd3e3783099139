// Stopping a rendering, and being told how far it is.

#include "scene_kit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>

namespace glint::rendering {
namespace {

using namespace kit;

SceneDescription glowing(int size) {
    SceneDescription scene = empty_scene(Vec3(0), Vec3(0, 1, 0), size);
    scene.render.background = Vec3(1);
    return scene;
}

bool is_black(const Picture& picture) {
    return std::all_of(picture.image.pixels.begin(), picture.image.pixels.end(),
                       [](float v) { return v == 0; });
}

TEST(Cancel, BeforeTheStartLeavesNothing) {
    const CancelFlag cancel{true};
    RenderOptions options;
    options.cancel = &cancel;
    options.coverage = true;
    options.terms = true;
    for (const bool coarse_first : {false, true}) {
        options.coarse_first = coarse_first;
        const Picture picture = rendered(glowing(64), options);
        EXPECT_FALSE(picture.complete);
        EXPECT_EQ(picture.image.pixels.size(), 3u * 64 * 64);
        EXPECT_EQ(picture.coverage.size(), 64u * 64);
        EXPECT_TRUE(is_black(picture));
        EXPECT_EQ(picture.stats.primary_rays, 0u);
        EXPECT_EQ(picture.stats.threads, 0);
    }
}

TEST(Cancel, KeepsFinishedTilesWholeAndTheOthersBlack) {
    for (const int threads : {1, 4}) {
        CancelFlag cancel{false};
        RenderOptions options;
        options.threads = threads;
        options.tile_size = 8;
        options.cancel = &cancel;
        options.terms = true;
        std::uint64_t done = 0;
        options.progress = [&](const Progress& progress) {
            done = progress.tiles_done;
            if (done == 5) cancel = true;
        };
        const Picture picture = rendered(glowing(64), options);
        EXPECT_FALSE(picture.complete);
        EXPECT_GE(done, 5u);
        EXPECT_LT(done, 64u);
        std::uint64_t bright = 0;
        for (int tile = 0; tile < 64; ++tile) {
            int pixels = 0;
            for (int i = 0; i < 64; ++i) {
                const int x = tile % 8 * 8 + i % 8, y = tile / 8 * 8 + i / 8;
                const bool lit = picture.image.at(x, y)[1] == 1;
                const float emission = picture.terms[static_cast<std::size_t>(Term::emission)].at(x, y)[1];
                EXPECT_EQ(emission, lit ? 1.0f : 0.0f);
                pixels += lit ? 1 : 0;
            }
            EXPECT_TRUE(pixels == 0 || pixels == 64) << "tile " << tile << " is half drawn";
            bright += pixels == 64 ? 1 : 0;
        }
        EXPECT_EQ(bright, done);
    }
}

/// A picture in tiles of 8 pixels, cancelled after some tiles of its last pass.
Picture cancelled_after(std::uint64_t tiles, const SceneDescription& scene, RenderOptions options) {
    CancelFlag cancel{false};
    options.threads = 1;
    options.tile_size = 8;
    options.coarse_first = true;
    options.cancel = &cancel;
    double fraction = 0;
    options.progress = [&](const Progress& progress) {
        EXPECT_GE(progress.fraction, fraction);
        fraction = progress.fraction;
        // The last pass begins when the tiles of the previews are done.
        if (progress.fraction > 1.0 / 17 && tiles-- == 0) cancel = true;
    };
    return rendered(scene, options);
}

TEST(Cancel, LeavesACoarsePictureWhereOneWasMadeFirst) {
    for (const int samples : {1, 4, 16}) {
        SceneDescription scene = glowing(64);
        scene.render.spp = samples;
        RenderOptions options;
        options.terms = true;
        options.coverage = true;
        for (const bool covered : {false, true}) {
            if (covered) add(scene, SphereShape{Vec3(0), 1000}, lamp(Vec3(1)));
            const Picture picture = cancelled_after(5, scene, options);
            EXPECT_FALSE(picture.complete);
            for (std::size_t i = 0; i < picture.image.pixels.size(); ++i) {
                EXPECT_EQ(picture.image.pixels[i], covered ? 1.0f : 0.0f);
                EXPECT_EQ(picture.terms[static_cast<std::size_t>(Term::emission)].pixels[i],
                          picture.image.pixels[i]);
            }
            for (const float share : picture.coverage) EXPECT_EQ(share, covered ? 1.0f : 0.0f);
        }
    }
}

TEST(Cancel, ACoarsePictureFirstChangesNoFinishedPicture) {
    SceneDescription scene = glowing(45);
    add(scene, SphereShape{Vec3(0), 1}, matte(0.5));
    add_light(scene, Vec3(3, -4, 5), 40);
    RenderOptions options;
    options.terms = true;
    options.coverage = true;
    const Picture expected = rendered(scene, options);
    options.coarse_first = true;
    const Picture picture = rendered(scene, options);
    EXPECT_EQ(picture.image.pixels, expected.image.pixels);
    EXPECT_EQ(picture.coverage, expected.coverage);
    for (std::size_t t = 0; t < expected.terms.size(); ++t)
        EXPECT_EQ(picture.terms[t].pixels, expected.terms[t].pixels);
}

TEST(Cancel, ReachesIntoARayTreeThatWouldNeverEnd) {
    // Facing half mirrors of glass: each bounce has two branches, 2^1000 rays in all, and none of
    // them is dropped for its small weight.
    Material m = glass(1, 0.5);
    m.reflectivity = 0.5;
    SceneDescription scene = empty_scene(Vec3(0, 0.5, 0), Vec3(0, 1, 0), 2);
    scene.whitted.max_depth = 1000;
    scene.whitted.min_weight = 0;
    for (int i = 0; i < 40; ++i) add(scene, PlaneShape{Vec3(0, 1, 0), i * 1.0}, m);
    CancelFlag cancel{false};
    std::atomic<bool> started{false};
    RenderOptions options;
    options.cancel = &cancel;
    options.progress = [&](const Progress&) { started = true; };
    std::thread stopper([&] {
        while (!started) std::this_thread::yield();
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        cancel = true;
    });
    const Picture picture = rendered(scene, options);
    stopper.join();
    EXPECT_FALSE(picture.complete);
    EXPECT_TRUE(is_black(picture));
    EXPECT_GT(picture.stats.rays(), 1000u);
}

TEST(Cancel, NotAskedForChangesNothing) {
    const CancelFlag cancel{false};
    RenderOptions options;
    options.cancel = &cancel;
    const Picture picture = rendered(glowing(32), options);
    EXPECT_TRUE(picture.complete);
    EXPECT_EQ(picture_hash(picture.image), picture_hash(rendered(glowing(32)).image));
}

TEST(Progress, IsMonotoneAndEndsWithEverything) {
    for (const int threads : {1, 5}) {
        std::vector<Progress> told;
        RenderOptions options;
        options.threads = threads;
        options.tile_size = 8;
        options.progress = [&](const Progress& progress) { told.push_back(progress); };
        const Picture picture = rendered(glowing(64), options);
        ASSERT_EQ(told.size(), 65u);
        for (std::size_t i = 0; i < told.size(); ++i) {
            EXPECT_EQ(told[i].tiles, 64u);
            EXPECT_EQ(told[i].tiles_done, i);
            EXPECT_DOUBLE_EQ(told[i].fraction, static_cast<double>(i) / 64);
            if (i == 0) continue;
            EXPECT_GT(told[i].rays, told[i - 1].rays);
            EXPECT_GE(told[i].seconds, told[i - 1].seconds);
        }
        EXPECT_EQ(told.back().rays, picture.stats.rays());
    }
}

TEST(Progress, AnExceptionInItEndsTheRendering) {
    RenderOptions options;
    options.threads = 2;
    options.progress = [](const Progress&) { throw std::runtime_error("enough"); };
    EXPECT_THROW(rendered(glowing(64), options), std::runtime_error);
}

} // namespace
} // namespace glint::rendering
