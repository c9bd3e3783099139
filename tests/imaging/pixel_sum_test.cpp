#include "imaging/pixel_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {

using namespace glint;
using namespace glint::imaging;

TEST(PairwiseSum, AddsByTheFixedTree) {
    // A sum of texts shows the order in which they were added.
    struct Term {
        std::string text;
        Term operator+(const Term& other) const { return {"(" + text + other.text + ")"}; }
    };
    PairwiseSum<Term> sum;
    EXPECT_EQ(sum.total().text, "");
    const char* expected[] = {
        "a", "(ab)", "((ab)c)", "((ab)(cd))", "(((ab)(cd))e)", "(((ab)(cd))(ef))", "(((ab)(cd))((ef)g))"};
    for (int i = 0; i < 7; ++i) {
        sum.add({std::string(1, static_cast<char>('a' + i))});
        EXPECT_EQ(sum.total().text, expected[i]);
    }
    EXPECT_EQ(sum.count(), 7U);
}

TEST(PairwiseSum, BlocksOfSixteenCanBeSummedApart) {
    const auto value = [](int i) { return 1.0f / static_cast<float>(i + 3); };
    PairwiseSum<float> whole;
    PairwiseSum<float> of_blocks;
    for (int block = 0; block < 11; ++block) {
        PairwiseSum<float> part;
        for (int i = 16 * block; i < 16 * block + 16; ++i) {
            whole.add(value(i));
            part.add(value(i));
        }
        of_blocks.add(part.total());
    }
    EXPECT_EQ(whole.total(), of_blocks.total());
}

TEST(PairwiseSum, StaysExactWhereARunningSumDrifts) {
    PairwiseSum<float> sum;
    float running = 0;
    for (int i = 0; i < 1 << 20; ++i) {
        sum.add(0.1f);
        running += 0.1f;
    }
    const double exact = (1 << 20) * static_cast<double>(0.1f);
    EXPECT_EQ(static_cast<double>(sum.total()), exact);
    EXPECT_GT(std::abs(static_cast<double>(running) - exact), 1);
}

TEST(PixelSum, OneSampleIsThePixel) {
    PixelSum<vec3> pixel;
    EXPECT_EQ(pixel.value(), vec3(0));
    pixel.add(vec3(0.1f, 0.2f, 0.7f), 1);
    EXPECT_EQ(pixel.value(), vec3(0.1f, 0.2f, 0.7f));
}

TEST(PixelSum, DividesTheWeightedSumByTheWeights) {
    // (12 · 2 − 4 · 4) / (12 − 4): half of the samples' number remains, just enough.
    PixelSum<vec3> pixel;
    for (int i = 0; i < 16; ++i) pixel.add(i % 4 == 1 ? vec3(4) : vec3(2), i % 4 == 1 ? -1.0f : 1.0f);
    EXPECT_EQ(pixel.value(), vec3(1));
}

TEST(PixelSum, LeavesNegativeLobesOutOfFewSamples) {
    PixelSum<vec3> pixel;
    for (int i = 0; i < 15; ++i) pixel.add(i == 7 ? vec3(100) : vec3(2), i == 7 ? -1.0f : 1.0f);
    EXPECT_EQ(pixel.value(), vec3(2));
}

TEST(PixelSum, TakesThePositiveMeanWhereWeightsNearlyCancel) {
    PixelSum<vec3> pixel;
    pixel.add(vec3(1), 1);
    pixel.add(vec3(9), -1);
    EXPECT_EQ(pixel.value(), vec3(1));
    pixel.add(vec3(2), 1);
    EXPECT_EQ(pixel.value(), vec3(1.5f));
}

TEST(PixelSum, TakesThePlainMeanWhereNoWeightIsPositive) {
    PixelSum<vec3> pixel;
    pixel.add(vec3(2), -1);
    pixel.add(vec3(4), -1);
    EXPECT_EQ(pixel.value(), vec3(3));
}

TEST(PixelSum, DoubledLightDoublesThePixelInEveryBit) {
    PixelSum<vec3> once;
    PixelSum<vec3> twice;
    for (int i = 0; i < 37; ++i) {
        const vec3 light(std::sin(static_cast<float>(i)), 0.3f * static_cast<float>(i), 1e-3f);
        const float weight = i % 7 == 3 ? -1.0f : 1.0f;
        once.add(light, weight);
        twice.add(2.0f * light, weight);
    }
    EXPECT_EQ(twice.value(), 2.0f * once.value());
}

} // namespace
