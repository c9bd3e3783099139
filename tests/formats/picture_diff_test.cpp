#include "picture_support.h"

#include <cmath>
#include <limits>

namespace glint::test {

namespace {

LoadedPicture gray(int width, int height, int bits, float value) {
    LoadedPicture picture{Image(width, height), bits};
    std::fill(picture.image.pixels.begin(), picture.image.pixels.end(), value);
    return picture;
}

TEST(DiffPictures, CountsEightBitPicturesInStepsOf255) {
    LoadedPicture b = gray(10, 1, 8, 100);
    b.image.pixels[4] = 103;
    const PictureDifference d = diff_pictures(gray(10, 1, 8, 100), b, 2);
    EXPECT_TRUE(d.eight_bit);
    EXPECT_EQ(d.comparison.max, 3);
    EXPECT_DOUBLE_EQ(d.comparison.mae, 0.1);
    EXPECT_DOUBLE_EQ(d.comparison.share, 0.1);
    EXPECT_DOUBLE_EQ(d.comparison.psnr, 20 * std::log10(255 / std::sqrt(9.0 / 30)));
    EXPECT_EQ(diff_pictures(gray(10, 1, 8, 100), b, 3).comparison.share, 0);
}

TEST(DiffPictures, CountsAlphaAsAFourthChannel) {
    const LoadedPicture opaque = gray(2, 1, 8, 100);
    LoadedPicture clear = opaque;
    clear.alpha = {255, 205};
    EXPECT_EQ(diff_pictures(opaque, clear, 0).comparison.max, 50);
    EXPECT_DOUBLE_EQ(diff_pictures(clear, opaque, 0).comparison.mae, 50.0 / 8);
    EXPECT_EQ(diff_pictures(opaque, clear, 0).comparison.share, 0.5);
    EXPECT_EQ(diff_pictures(clear, clear, 0).comparison.max, 0);
    clear.alpha[1] = 255;
    EXPECT_EQ(diff_pictures(opaque, clear, 0).comparison.max, 0) << "255 is opaque";

    LoadedPicture deep = gray(2, 1, 16, 100 * 257);
    deep.alpha = {65535, 65535 - 257};
    EXPECT_EQ(diff_pictures(deep, opaque, 0).comparison.max, 1);
    LoadedPicture linear = gray(2, 1, 32, 0.5f);
    linear.alpha = {1, 0.25f};
    EXPECT_EQ(diff_pictures(gray(2, 1, 32, 0.5f), linear, 0).comparison.max, 0.75);
}

TEST(DiffPictures, CountsSixteenBitPicturesInTheSameUnits) {
    // One step of 1/255 is 257 steps of 1/65535, exactly, at the tolerance's edge too.
    for (int code = 0; code < 255; ++code) {
        const LoadedPicture a = gray(1, 1, 16, static_cast<float>(code * 257));
        const LoadedPicture b = gray(1, 1, 16, static_cast<float>(code * 257 + 257));
        const PictureDifference d = diff_pictures(a, b, 1);
        EXPECT_TRUE(d.eight_bit);
        EXPECT_EQ(d.comparison.max, 1);
        EXPECT_EQ(d.comparison.rmse, 1);
        EXPECT_EQ(d.comparison.share, 0);
    }
}

TEST(DiffPictures, EightAndSixteenBitsOfOnePictureAreEqual) {
    for (int code = 0; code <= 255; ++code) {
        const PictureDifference d = diff_pictures(gray(1, 1, 8, static_cast<float>(code)),
                                                  gray(1, 1, 16, static_cast<float>(code * 257)), 0);
        EXPECT_EQ(d.comparison.max, 0);
        EXPECT_EQ(d.comparison.psnr, std::numeric_limits<double>::infinity());
    }
}

TEST(DiffPictures, ComparesFloatPicturesLinearly) {
    const PictureDifference d = diff_pictures(gray(2, 2, 32, 0.5f), gray(2, 2, 32, 0.25f), 0.25);
    EXPECT_FALSE(d.eight_bit);
    EXPECT_EQ(d.comparison.max, 0.25);
    EXPECT_EQ(d.comparison.share, 0);
    EXPECT_DOUBLE_EQ(d.comparison.psnr, 20 * std::log10(4.0));
}

TEST(DiffPictures, RefusesCodesAgainstLightAndNamesBothKinds) {
    expect_error(ErrorKind::usage, {"an 8-bit picture", "a float picture", "linear light"},
                 [] { diff_pictures(gray(1, 1, 8, 0), gray(1, 1, 32, 0), 0); });
    expect_error(ErrorKind::usage, {"a float picture with a 16-bit picture"},
                 [] { diff_pictures(gray(1, 1, 32, 0), gray(1, 1, 16, 0), 0); });
}

TEST(DiffPictures, RefusesDifferentSizesAndNamesBoth) {
    expect_error(ErrorKind::input, {"3 x 2 and 2 x 3"},
                 [] { diff_pictures(gray(3, 2, 8, 0), gray(2, 3, 8, 0), 0); });
}

} // namespace

} // namespace glint::test
