// Timelines: exact at keyframes, within their range, without jumps of speed, the same bits every time.

#include "scene/animation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace glint::scene {
namespace {

struct Curve {
    Timeline timeline;
    std::vector<double> values;

    double at(double frame) const {
        return timeline.at(timeline.within(frame), [&](std::size_t i) { return values[i]; });
    }
};

Curve random_curve(std::mt19937& random, Interpolation interpolation, bool loop) {
    std::uniform_real_distribution<double> gap(0.1, 9), value(-5, 5);
    Curve curve{{{}, interpolation, loop}, {}};
    double frame = value(random);
    for (std::size_t count = 1 + random() % 6, i = 0; i < count; ++i) {
        curve.timeline.frames.push_back(frame);
        // Now and then a rest.
        curve.values.push_back(i > 0 && random() % 4 == 0 ? curve.values.back() : value(random));
        frame += gap(random);
    }
    return curve;
}

TEST(Timeline, IsExactAtKeyframesAndWithinTheRangeBetweenThem) {
    std::mt19937 random(1);
    for (int round = 0; round < 600; ++round) {
        const auto interpolation = static_cast<Interpolation>(round % 3);
        const Curve curve = random_curve(random, interpolation, false);
        const auto& frames = curve.timeline.frames;
        for (std::size_t i = 0; i < frames.size(); ++i) EXPECT_EQ(curve.at(frames[i]), curve.values[i]);
        for (std::size_t i = 0; i + 1 < frames.size(); ++i)
            for (int k = 1; k < 8; ++k) {
                const double v = curve.at(frames[i] + (frames[i + 1] - frames[i]) * k / 8);
                EXPECT_GE(v, std::min(curve.values[i], curve.values[i + 1]));
                EXPECT_LE(v, std::max(curve.values[i], curve.values[i + 1]));
            }
        EXPECT_EQ(curve.at(frames.front() - 3), curve.values.front());
        EXPECT_EQ(curve.at(frames.back() + 3), curve.values.back());
    }
}

TEST(Timeline, LinearGoesAtEvenSpeedAndStepNotAtAll) {
    const Curve linear{{{0, 10}, Interpolation::linear, false}, {2, 4}};
    EXPECT_EQ(linear.at(5), 3);
    EXPECT_EQ(linear.at(2.5), 2.5);
    const Curve step{{{0, 10}, Interpolation::step, false}, {2, 4}};
    EXPECT_EQ(step.at(9.999), 2);
    EXPECT_EQ(step.at(10), 4);
}

TEST(Timeline, SmoothBetweenTwoKeyframesIsSmoothstep) {
    const Curve curve{{{0, 4}, Interpolation::smooth, false}, {0, 1}};
    EXPECT_EQ(curve.at(1), 3 * 0.0625 - 2 * 0.015625);
    EXPECT_EQ(curve.at(2), 0.5);
}

// The speeds of both sides of a keyframe agree, however the frames are spaced.
TEST(Timeline, SmoothHasNoJumpsOfSpeed) {
    std::mt19937 random(2);
    for (int round = 0; round < 400; ++round) {
        Curve curve = random_curve(random, Interpolation::smooth, round % 2 == 1);
        if (curve.values.size() < 2) continue;
        if (curve.timeline.loop) curve.values.back() = curve.values.front();
        const double h = 1e-6;
        for (const double frame : curve.timeline.frames) {
            const double before = (curve.at(frame) - curve.at(frame - h)) / h;
            const double after = (curve.at(frame + h) - curve.at(frame)) / h;
            EXPECT_NEAR(before, after, 1e-2);
        }
    }
}

TEST(Timeline, ALoopRepeatsItself) {
    const Curve curve{{{2, 6, 10}, Interpolation::smooth, true}, {0, 1, 0}};
    for (const double frame : {2.0, 3.5, 6.0, 9.5}) {
        EXPECT_EQ(curve.at(frame + 8), curve.at(frame));
        EXPECT_EQ(curve.at(frame - 16), curve.at(frame));
    }
    // An angle that turns on and on has no rest at the seam.
    const Curve turning{{{0, 60}, Interpolation::smooth, true}, {0, 360}};
    for (const double frame : {1.0, 15.0, 59.0}) EXPECT_NEAR(turning.at(frame), 6 * frame, 1e-12);
}

} // namespace
} // namespace glint::scene
