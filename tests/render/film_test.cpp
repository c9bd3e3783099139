// Films that are cut into parts, kept as bytes and joined: bit for bit the picture that is rendered at once.

#include "render/cpu_executor.h"
#include "render/film.h"
#include "render/schedule_run.h"

#include "gallery.h"
#include "scene_kit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>

namespace glint::rendering {
namespace {

using namespace kit;

Scene exhibit_scene(int samples) {
    SceneDescription scene = gallery().front().scene;
    scene.render.width = 21;
    scene.render.height = 13;
    scene.render.spp = samples;
    scene.render.filter = PixelFilter::mitchell; // has samples of negative weight
    return build_scene(scene);
}

RenderOptions in_tiles(int tile_size) {
    RenderOptions options;
    options.tile_size = tile_size;
    options.terms = true;
    options.coverage = true;
    return options;
}

/// Runs passes over a film. Returns the number of rays.
std::uint64_t run(const Scene& scene, Film& film, std::vector<Pass> passes, const Shard& shard = {},
                  const CancelFlag* cancel = nullptr, std::function<void(const Progress&)> progress = {}) {
    parallel::TaskPool pool(1);
    CpuExecutor executor(scene.data(), film, pool, {}, cancel, shard);
    ScheduleRun run(executor, std::move(passes), cancel, std::move(progress));
    run.run(no_deadline);
    return run.reached().rays;
}

Film film_of(const Scene& scene, const RenderOptions& options, std::vector<Pass> passes,
             const Shard& shard = {}) {
    Film film(film_layout(scene.render_settings(), options));
    run(scene, film, std::move(passes), shard);
    return film;
}

void expect_same(Film& film, const Picture& expected, const std::string& what) {
    Picture picture;
    film.move_to(picture);
    EXPECT_EQ(picture_hash(picture.image), picture_hash(expected.image)) << what;
    for (std::size_t t = 0; t < expected.terms.size(); ++t)
        EXPECT_EQ(picture.terms[t].pixels, expected.terms[t].pixels) << what << ", term " << t;
    EXPECT_EQ(picture.coverage, expected.coverage) << what;
}

TEST(Film, ShardsOfTilesJoinToTheWhole) {
    for (const int samples : {1, 6}) {
        const Scene scene = exhibit_scene(samples);
        const RenderOptions options = in_tiles(4);
        Film whole(film_layout(scene.render_settings(), options));
        for (const int i : {2, 0, 1}) {
            EXPECT_FALSE(whole.is_complete());
            whole.join(film_of(scene, options, picture_passes({samples}, {}), {i, 3}));
        }
        EXPECT_TRUE(whole.is_complete());
        expect_same(whole, render(scene, options), std::to_string(samples) + " samples");
    }
}

TEST(Film, ShardsOfSamplesJoinToTheWholeInAnyOrder) {
    std::mt19937 random(7);
    for (const int samples : {2, 5, 16, 23, 37})
        for (const int shards : {2, 3, 5}) {
            const Scene scene = exhibit_scene(samples);
            const RenderOptions options = in_tiles(16);
            std::vector<int> order;
            for (int i = 0; i < shards; ++i) order.push_back(i);
            std::shuffle(order.begin(), order.end(), random);
            Film whole(film_layout(scene.render_settings(), options));
            for (const int i : order) whole.join(film_of(scene, options, sample_shard(samples, {i, shards})));
            EXPECT_TRUE(whole.is_complete());
            expect_same(whole, render(scene, options),
                        std::to_string(samples) + " samples in " + std::to_string(shards));
        }
}

TEST(Film, RandomCancelsSavesAndLoadsChangeNoBit) {
    std::mt19937 random(11);
    for (int trial = 0; trial < 12; ++trial) {
        const int samples = 1 + static_cast<int>(random() % 40);
        const Scene scene = exhibit_scene(samples);
        const RenderOptions options = in_tiles(trial % 2 == 0 ? 4 : 8);
        // What others have begun.
        const auto passes = sample_shard(samples, {static_cast<int>(random() % 3), 3});
        Film film = film_of(scene, options, passes, {static_cast<int>(random() % 2), 2});
        for (int turn = 0; turn < 6; ++turn) {
            film = Film::load(film.save());
            CancelFlag cancel{false};
            int tiles = static_cast<int>(random() % 8);
            run(scene, film, picture_passes({samples}, {}), {}, &cancel,
                [&](const Progress&) { cancel = --tiles <= 0; });
        }
        run(scene, film, picture_passes({samples}, {}));
        EXPECT_TRUE(film.is_complete());
        film = Film::load(film.save());
        expect_same(film, render(scene, options), std::to_string(samples) + " samples");
    }
}

TEST(Film, PassesThatDoubleGoOnAfterALoad) {
    const Scene scene = exhibit_scene(11);
    RenderOptions options;
    options.show = Aov::diffuse;
    Film film(film_layout(scene.render_settings(), options));
    for (const Pass& pass : refining_passes(1, {11})) {
        run(scene, film, {pass});
        film = Film::load(film.save());
    }
    expect_same(film, render(scene, options), "diffuse");
}

TEST(Film, WhatIsDoneIsNotMeasuredAgain) {
    const Scene scene = exhibit_scene(4);
    const RenderOptions options = in_tiles(4);
    Film film = film_of(scene, options, picture_passes({4}, {}), {0, 2});
    Film odd(film_layout(scene.render_settings(), options));
    EXPECT_EQ(run(scene, film, picture_passes({4}, {})), run(scene, odd, picture_passes({4}, {}), {1, 2}));
    EXPECT_TRUE(film.is_complete());
}

TEST(Film, RefinesWhatWasRenderedInPart) {
    const Scene scene = exhibit_scene(6);
    const RenderOptions options = in_tiles(4);
    Film film = film_of(scene, options, picture_passes({6}, {}), {1, 3});
    run(scene, film, refining_passes(8, {6}));
    EXPECT_TRUE(film.is_complete());
    expect_same(film, render(scene, options), "refined");
}

TEST(Film, ManyBlocksWithGapsCanBeSaved) {
    const Scene scene = exhibit_scene(256);
    RenderOptions options;
    options.tile_size = 16;
    options.crop = Rect{3, 2, 2, 2};
    Film film(film_layout(scene.render_settings(), options));
    for (const int odd : {0, 1}) {
        for (int first = 2 * odd; first < 256; first += 4) run(scene, film, {{1, false, first, 2}});
        film = Film::load(film.save());
    }
    expect_same(film, render(scene, options), "every second block first");
}

TEST(Film, APlainPictureKeepsNoSums) {
    const Scene scene = exhibit_scene(16);
    const Film film = film_of(scene, {}, picture_passes({16}, {}));
    const std::size_t image = film.image().pixels.size() * sizeof(float);
    EXPECT_LT(film.save().size(), image + 200);
}

std::string refusal(const std::function<void()>& f) {
    try {
        f();
    } catch (const Error& error) {
        return error.diagnostics().at(0).message;
    }
    return "nothing was thrown";
}

TEST(Film, RefusesToJoinWhatDoesNotFit) {
    const Scene scene = exhibit_scene(4);
    const RenderOptions options = in_tiles(4);
    Film film = film_of(scene, options, {{1, false, 0, 2}}, {0, 2});
    const std::vector<std::byte> before = film.save();
    EXPECT_EQ(refusal([&] { film.join(film_of(scene, options, picture_passes({4}, {}))); }),
              "both films have the same samples");
    EXPECT_EQ(refusal([&] { film.join(Film(film_layout(exhibit_scene(5).render_settings(), options))); }),
              "the films differ in their samples per pixel");
    EXPECT_EQ(refusal([&] { film.join(Film(film_layout(scene.render_settings(), in_tiles(8)))); }),
              "the films differ in their tile size");
    const Scene one_sample = exhibit_scene(1);
    RenderOptions shown;
    Film light(film_layout(one_sample.render_settings(), shown));
    shown.show = Aov::depth;
    EXPECT_EQ(refusal([&] { light.join(Film(film_layout(one_sample.render_settings(), shown))); }),
              "the films differ in their quantity");
    EXPECT_EQ(film.save(), before);
}

/// The check sum of all bytes but its own 8 at the end: FNV-1a over words of 8 bytes.
void set_check_sum(std::vector<std::byte>& film) {
    std::uint64_t hash = 0xcbf29ce484222325;
    const std::size_t end = film.size() - 8;
    for (std::size_t at = 0; at < end; at += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, &film[at], std::min<std::size_t>(8, end - at));
        hash = (hash ^ word) * 0x100000001b3;
        hash ^= hash >> 32;
    }
    std::memcpy(&film[end], &hash, 8);
}

TEST(Film, TakesNoMemoryForWhatOnlyItsHeaderClaims) {
    std::vector<std::byte> film =
        film_of(exhibit_scene(4), in_tiles(8), picture_passes({4}, {}), {0, 2}).save();
    set_check_sum(film);
    EXPECT_NO_THROW(Film::load(film));
    const std::int32_t width_height_and_tile[] = {30000, 30000, 1};
    std::memcpy(&film[20], width_height_and_tile, sizeof width_height_and_tile);
    set_check_sum(film);
    EXPECT_EQ(refusal([&] { Film::load(film); }), "the film cannot be read: it ends too early");
    const std::int32_t whole = 30000;
    std::memcpy(&film[28], &whole, sizeof whole);
    set_check_sum(film);
    EXPECT_EQ(refusal([&] { Film::load(film); }), "the film cannot be read: it ends too early");
}

TEST(Film, DamageIsFoundWhereverItIs) {
    const std::vector<std::byte> sound =
        film_of(exhibit_scene(4), in_tiles(8), {{1, false, 0, 2}}, {0, 2}).save();
    EXPECT_NO_THROW(Film::load(sound));
    for (std::size_t at = 0; at < sound.size(); at += 1 + at / 16) {
        std::vector<std::byte> damaged = sound;
        damaged[at] ^= std::byte{16};
        EXPECT_NE(refusal([&] { Film::load(damaged); }), "nothing was thrown") << "byte " << at;
        EXPECT_NE(refusal([&] { Film::load(std::span(sound).first(at)); }), "nothing was thrown");
    }
    std::vector<std::byte> other = sound;
    other[8] = std::byte{99};
    EXPECT_EQ(refusal([&] { Film::load(other); }),
              "the film cannot be read: it is of another version of glint");
    EXPECT_EQ(refusal([&] { Film::load(std::vector<std::byte>(100)); }),
              "the film cannot be read: it is not a film of glint");
}

} // namespace
} // namespace glint::rendering
