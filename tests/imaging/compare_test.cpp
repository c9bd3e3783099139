#include "glint/error.h"
#include "glint/image.h"
#include "special.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace {

using glint::compare;
using glint::Comparison;
using glint::Image;
using glint::imaging::infinity;
using glint::imaging::no_number;

Image gray(int width, int height, float value) {
    Image image(width, height);
    for (float& v : image.pixels) v = value;
    return image;
}

TEST(Compare, EqualPicturesDifferInNothing) {
    const Comparison c = compare(gray(5, 4, 0.25f), gray(5, 4, 0.25f), 0, 1);
    EXPECT_EQ(c.max, 0);
    EXPECT_EQ(c.mae, 0);
    EXPECT_EQ(c.rmse, 0);
    EXPECT_EQ(c.share, 0);
    EXPECT_EQ(c.psnr, std::numeric_limits<double>::infinity());
}

TEST(Compare, MeasuresOneChangedChannelByHand) {
    // One value of 24 is 8 too high: MAE 8/24, RMSE √(64/24), one pixel of eight.
    const Image a = gray(4, 2, 100);
    Image b = a;
    b.at(3, 1)[2] = 108;
    const Comparison c = compare(a, b, 7, 255);
    EXPECT_EQ(c.max, 8);
    EXPECT_DOUBLE_EQ(c.mae, 8.0 / 24);
    EXPECT_DOUBLE_EQ(c.rmse, std::sqrt(64.0 / 24));
    EXPECT_DOUBLE_EQ(c.psnr, 10 * std::log10(255.0 * 255.0 * 24 / 64));
    EXPECT_DOUBLE_EQ(c.share, 1.0 / 8);
}

TEST(Compare, ToleranceIsInclusive) {
    const Image a = gray(1, 1, 10);
    const Image b = gray(1, 1, 12);
    EXPECT_EQ(compare(a, b, 2, 255).share, 0);
    EXPECT_EQ(compare(a, b, std::nextafter(2.0, 0.0), 255).share, 1);
}

TEST(Compare, CountsAPixelOnceHoweverManyOfItsChannelsDiffer) {
    Image b = gray(2, 1, 0);
    b.at(0, 0)[0] = b.at(0, 0)[1] = b.at(0, 0)[2] = 1;
    EXPECT_EQ(compare(gray(2, 1, 0), b, 0.5, 1).share, 0.5);
}

TEST(Compare, NanAndInfinityEqualThemselvesAndNothingElse) {
    EXPECT_EQ(compare(gray(1, 1, no_number), gray(1, 1, no_number), 0, 1).max, 0);
    EXPECT_EQ(compare(gray(1, 1, infinity), gray(1, 1, infinity), 0, 1).rmse, 0);

    const double without_end = std::numeric_limits<double>::infinity();
    EXPECT_EQ(compare(gray(1, 1, no_number), gray(1, 1, 0), 1e30, 1).max, without_end);
    EXPECT_EQ(compare(gray(1, 1, 0), gray(1, 1, no_number), 1e30, 1).share, 1);
    EXPECT_EQ(compare(gray(1, 1, infinity), gray(1, 1, -infinity), 0, 1).mae, without_end);
    EXPECT_EQ(compare(gray(1, 1, infinity), gray(1, 1, 0), 0, 1).psnr, -without_end);
}

TEST(Compare, PicturesWithoutPixelsAreEqual) {
    const Comparison c = compare(Image(0, 3), Image(0, 3), 0, 1);
    EXPECT_EQ(c.mae, 0);
    EXPECT_EQ(c.share, 0);
}

TEST(Compare, RefusesDifferentSizesAndNamesBoth) {
    try {
        compare(Image(3, 2), Image(2, 3), 0, 1);
        FAIL() << "sizes were accepted";
    } catch (const glint::Error& error) {
        EXPECT_EQ(error.kind(), glint::ErrorKind::input);
        EXPECT_EQ(error.diagnostics().front().message, "the pictures have different sizes: 3 x 2 and 2 x 3");
    }
    EXPECT_THROW(glint::difference_heat(Image(3, 2), Image(3, 3), 1), glint::Error);
}

TEST(DifferenceHeat, RunsFromBlackThroughBlueAndYellowToWhite) {
    const Image a = gray(5, 1, 0);
    Image b = a;
    const float values[] = {0, 1, 2, 3, 100};
    for (int x = 0; x < 5; ++x) b.at(x, 0)[x % 3] = -values[x];

    const Image heat = glint::difference_heat(a, b, 3);
    const float expected[] = {0, 0, 0, 0, 0, 1, 1, 1, 0, 1, 1, 1, 1, 1, 1};
    for (std::size_t i = 0; i < 15; ++i) EXPECT_FLOAT_EQ(heat.pixels[i], expected[i]) << "value " << i;
}

TEST(DifferenceHeat, ShowsAlpha) {
    const Image same = gray(2, 1, 0.5f);
    const std::vector<float> alpha{1, 0};
    const Image heat = glint::difference_heat(same, same, 1, alpha);
    EXPECT_EQ(heat.pixels, (std::vector<float>{0, 0, 0, 1, 1, 1}));
}

TEST(DifferenceHeat, ShowsAnyDifferenceInWhiteAtAScaleOfZero) {
    Image b = gray(2, 1, 0.5f);
    b.at(1, 0)[0] = no_number;
    const Image heat = glint::difference_heat(gray(2, 1, 0.5f), b, 0);
    EXPECT_EQ(heat.at(0, 0)[0], 0);
    EXPECT_EQ(heat.at(1, 0)[0], 1);
    EXPECT_EQ(heat.at(1, 0)[2], 1);
}

} // namespace
