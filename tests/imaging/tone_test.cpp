#include "imaging/tone.h"
#include "special.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace {

using namespace glint;
using namespace glint::imaging;

/// The definition, with the C library's pow: good for checks that are not about the last bit.
double encode(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

TEST(Tone, EveryCodeComesBack) {
    for (unsigned code = 0; code <= 255; ++code) {
        const auto c = static_cast<std::uint8_t>(code);
        EXPECT_EQ(srgb8_from_linear(linear_from_srgb8(c)), c);
    }
    for (unsigned code = 0; code <= 65535; ++code) {
        const auto c = static_cast<std::uint16_t>(code);
        ASSERT_EQ(srgb16_from_linear(linear_from_srgb16(c)), c);
    }
}

TEST(Tone, DecodingFollowsTheStandardToTheLastDigits) {
    EXPECT_EQ(linear_from_srgb(0), 0);
    EXPECT_EQ(linear_from_srgb(1), 1);
    EXPECT_DOUBLE_EQ(linear_from_srgb(0.04045), 0.04045 / 12.92);
    for (int i = 0; i <= 4000; ++i) {
        const double e = 0.0405 + i * 0.0005;
        const double expected = std::pow((e + 0.055) / 1.055, 2.4);
        EXPECT_NEAR(linear_from_srgb(e), expected, 2e-15 * expected) << "at " << e;
    }
}

TEST(Tone, EncodingRoundsToTheNearestCode) {
    // Values where the definition is too near a half to tell are left to the test of the steps below.
    for (int i = 0; i <= 200000; ++i) {
        const auto linear = static_cast<float>(i) / 200000.0f;
        const double exact8 = 255 * encode(linear);
        const double exact16 = 65535 * encode(linear);
        if (std::abs(exact8 - std::floor(exact8) - 0.5) > 1e-6) {
            ASSERT_EQ(srgb8_from_linear(linear), static_cast<int>(exact8 + 0.5)) << "at " << linear;
        }
        if (std::abs(exact16 - std::floor(exact16) - 0.5) > 2e-3) {
            ASSERT_EQ(srgb16_from_linear(linear), static_cast<int>(exact16 + 0.5)) << "at " << linear;
        }
    }
}

TEST(Tone, StepsLieBetweenNeighbouringFloats) {
    for (unsigned code = 0; code < 255; ++code) {
        const double step = linear_from_srgb((code + 0.5) / 255);
        auto above = static_cast<float>(step);
        if (above < step) above = std::nextafter(above, 2.0f);
        EXPECT_EQ(srgb8_from_linear(above), code + 1);
        EXPECT_EQ(srgb8_from_linear(std::nextafter(above, 0.0f)), code);
    }
}

TEST(Tone, EncodingNeverFalls) {
    unsigned last = 0;
    for (float linear = 1e-6f; linear < 1.1f; linear *= 1.00003f) {
        const unsigned code = srgb16_from_linear(linear);
        ASSERT_GE(code, last);
        last = code;
    }
    EXPECT_EQ(last, 65535U);
}

TEST(Tone, RawTruncatesWithoutACurve) {
    EXPECT_EQ(raw8_from_linear(0.5f), 127);
    EXPECT_EQ(raw8_from_linear(std::nextafter(1.0f, 0.0f)), 254);
    EXPECT_EQ(raw8_from_linear(1.0f), 255);
    EXPECT_EQ(raw16_from_linear(0.5f), 32767);
    EXPECT_EQ(raw16_from_linear(1.0f), 65535);
    // The product is not rounded: 3 · 2^-8 · 255 = 2.98828125.
    EXPECT_EQ(raw8_from_linear(0.01171875f), 2);
}

TEST(Tone, WhatIsNoLightIsBlackAndWhatIsTooBrightIsWhite) {
    for (const float dark : {no_number, -0.0f, -1.0f, -infinity}) {
        EXPECT_EQ(srgb8_from_linear(dark), 0);
        EXPECT_EQ(srgb16_from_linear(dark), 0);
        EXPECT_EQ(raw8_from_linear(dark), 0);
        EXPECT_EQ(raw16_from_linear(dark), 0);
        EXPECT_EQ(unorm8_from_float(dark), 0);
        EXPECT_EQ(unorm16_from_float(dark), 0);
    }
    for (const float bright : {1.0f, 1e30f, infinity}) {
        EXPECT_EQ(srgb8_from_linear(bright), 255);
        EXPECT_EQ(srgb16_from_linear(bright), 65535);
        EXPECT_EQ(raw8_from_linear(bright), 255);
        EXPECT_EQ(raw16_from_linear(bright), 65535);
        EXPECT_EQ(unorm8_from_float(bright), 255);
        EXPECT_EQ(unorm16_from_float(bright), 65535);
    }
}

TEST(Tone, SharesRoundToTheNearestCode) {
    EXPECT_EQ(unorm8_from_float(0.5f), 128);
    EXPECT_EQ(unorm8_from_float(0.25f), 64);
    EXPECT_EQ(unorm16_from_float(0.25f), 16384);
}

} // namespace
