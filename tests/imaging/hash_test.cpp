#include "glint/image.h"

#include <gtest/gtest.h>

namespace {

using glint::Image;

TEST(PictureHash, IsXxh3OfTheLittleEndianFloats) {
    // Reference digests: xxhsum -H2 of the same bytes.
    Image ramp(2, 2);
    for (std::size_t i = 0; i < ramp.pixels.size(); ++i) ramp.pixels[i] = static_cast<float>(i);
    EXPECT_EQ(glint::picture_hash(ramp), "bdb3f41b7b694e4bb6d47b1326c96fde");
    EXPECT_EQ(glint::picture_hash(Image(0, 0)), "99aa06d3014798d86001c324468d497f");

    Image large(100, 30);
    for (std::size_t i = 0; i < large.pixels.size(); ++i) large.pixels[i] = static_cast<float>(i) / 8;
    EXPECT_EQ(glint::picture_hash(large), "49890da21e80187f06a8e8711cb0e9b6");
}

TEST(PictureHash, SeesTheSignOfZeroAndASwapOfPixels) {
    Image a(2, 1);
    Image b(2, 1);
    b.pixels[0] = -0.0f;
    EXPECT_NE(glint::picture_hash(a), glint::picture_hash(b));

    a.pixels = {1, 2, 3, 4, 5, 6};
    b.pixels = {4, 5, 6, 1, 2, 3};
    EXPECT_NE(glint::picture_hash(a), glint::picture_hash(b));
}

} // namespace
