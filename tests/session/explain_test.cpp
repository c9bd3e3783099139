// Explaining a pixel in the background: again when its scene changes, cancelled at once.

#include "session/explainer.h"

#include "scene_kit.h"
#include "wait_until.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <thread>

namespace glint::viewer {
namespace {

using Clock = std::chrono::steady_clock;

/// A ball under a point light.
Scene ball(const Vec3& color, int samples = 1) {
    SceneDescription scene = kit::empty_scene(Vec3(0, -6, 1), Vec3(0, 6, -1), 48, 40);
    scene.render.spp = samples;
    Material material;
    material.color = color;
    kit::add(scene, SphereShape{Vec3(0), 1}, material);
    kit::add_light(scene, Vec3(3, -5, 4), 40);
    return build_scene(scene);
}

/// Shells of glass that split the ray at each surface: a sample takes longer than any test.
Scene endless() {
    SceneDescription scene = kit::empty_scene(Vec3(0, -6, 1), Vec3(0, 6, -1), 48, 40);
    scene.whitted.max_depth = 40;
    Material glass;
    glass.reflectivity = 0.5;
    glass.transparency = 0.5;
    glass.index = 1.1;
    for (int i = 0; i < 8; ++i) kit::add(scene, SphereShape{Vec3(0), 1 - 0.1 * i}, glass);
    return build_scene(scene);
}

class ExplainerTest : public testing::Test {
  protected:
    PixelQuestion question(ViewSlot slot = ViewSlot::main, int x = 24, int y = 20) const {
        return {slot, red.camera(), 48, 40, x, y};
    }
    /// The answer, once the explainer is idle.
    std::shared_ptr<const PixelAnswer> answer() const {
        EXPECT_TRUE(wait_until([&] { return !explainer.is_busy(); }));
        return explainer.latest();
    }
    static void expect_same(const PixelAnswer& answer, const Scene& scene) {
        const PixelQuestion& asked = answer.question;
        const Scene seen = with_view(scene, asked.camera, asked.width, asked.height);
        const Explanation wanted = explain(seen, asked.x, asked.y);
        EXPECT_EQ(answer.explanation.color, wanted.color);
        EXPECT_EQ(answer.explanation.samples.size(), wanted.samples.size());
        EXPECT_EQ(answer.fault, "");
    }

    const Scene red = ball(Vec3(1, 0, 0));
    const Scene green = ball(Vec3(0, 1, 0));
    SessionExplainer explainer{{}};
};

TEST_F(ExplainerTest, AnswersWhatExplainAnswers) {
    explainer.ask(question());
    EXPECT_FALSE(explainer.is_busy()) << "there is no scene yet";
    explainer.set_scene(ViewSlot::main, red);
    explainer.ask(question());
    const auto first = answer();
    ASSERT_TRUE(first);
    expect_same(*first, red);
    explainer.ask(question(ViewSlot::main, 20, 18));
    const auto second = answer();
    ASSERT_TRUE(second);
    EXPECT_EQ(second->question.x, 20);
    expect_same(*second, red);
}

TEST_F(ExplainerTest, AnswersAgainWhenTheSceneChanges) {
    explainer.set_scene(ViewSlot::main, red);
    explainer.ask(question());
    const auto first = answer();
    explainer.set_scene(ViewSlot::main, green);
    const auto second = answer();
    ASSERT_TRUE(second);
    EXPECT_NE(second->explanation.color, first->explanation.color);
    expect_same(*second, green);
}

TEST_F(ExplainerTest, EachPictureHasItsOwnScene) {
    explainer.set_scene(ViewSlot::main, red);
    explainer.set_scene(ViewSlot::reference, green);
    explainer.ask(question(ViewSlot::reference));
    expect_same(*answer(), green);
    explainer.set_scene(ViewSlot::main, green);
    expect_same(*answer(), green);
    explainer.set_scene(ViewSlot::reference, std::nullopt);
    EXPECT_FALSE(answer()) << "the picture is gone, and what was told of it";
    explainer.set_scene(ViewSlot::reference, red);
    EXPECT_FALSE(answer()) << "and does not come back by itself";
}

TEST_F(ExplainerTest, RaysAreKeptOfTheFirstSamplesOnly) {
    const Scene many = ball(Vec3(1, 0, 0), explained_samples + 3);
    explainer.set_scene(ViewSlot::main, many);
    explainer.ask(question());
    const auto got = answer();
    expect_same(*got, many);
    EXPECT_FALSE(got->explanation.samples[explained_samples - 1].rays.empty());
    EXPECT_TRUE(got->explanation.samples[explained_samples].rays.empty());
}

TEST_F(ExplainerTest, WhatCannotBeExplainedIsTold) {
    explainer.set_scene(ViewSlot::main, red);
    explainer.ask(question(ViewSlot::main, 48, 0));
    EXPECT_NE(answer()->fault.find("not in the picture"), std::string::npos);
}

TEST_F(ExplainerTest, ANewerQuestionOvertakesWhatTakesLong) {
    explainer.set_scene(ViewSlot::main, endless());
    explainer.set_scene(ViewSlot::reference, green);
    for (int i = 0; i < 20; ++i) {
        explainer.ask(question(ViewSlot::main, 20 + i % 4));
        std::this_thread::sleep_for(std::chrono::milliseconds(i % 3));
    }
    explainer.ask(question(ViewSlot::reference));
    const auto got = answer();
    ASSERT_TRUE(got);
    EXPECT_EQ(got->question.slot, ViewSlot::reference);
    expect_same(*got, green);
    explainer.ask(question(ViewSlot::main));
    explainer.forget();
    EXPECT_FALSE(answer());
}

TEST_F(ExplainerTest, ManyChangesEndInTheLastOne) {
    explainer.set_scene(ViewSlot::main, red);
    explainer.ask(question());
    for (int i = 0; i < 50; ++i) {
        explainer.set_scene(ViewSlot::main, i % 2 == 0 ? green : red);
        if (i % 5 == 0) explainer.latest();
        if (i % 7 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    explainer.set_scene(ViewSlot::main, green);
    expect_same(*answer(), green);
}

TEST(SessionExplainer, EndsAtOnceWhileItExplains) {
    const Scene scene = endless();
    double longest = 0;
    for (int delay = 0; delay < 12; delay += 3) {
        Clock::time_point begin;
        {
            SessionExplainer explainer{{}};
            explainer.set_scene(ViewSlot::main, scene);
            explainer.ask({ViewSlot::main, scene.camera(), 4096, 4096, 2048, 2048});
            std::this_thread::sleep_for(std::chrono::milliseconds(delay));
            EXPECT_TRUE(explainer.is_busy());
            begin = Clock::now();
        }
        longest = std::max(longest, std::chrono::duration<double>(Clock::now() - begin).count());
    }
    std::cout << "ended within " << longest * 1e3 << " ms\n";
}

} // namespace
} // namespace glint::viewer
