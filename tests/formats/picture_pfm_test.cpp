#include "picture_support.h"

namespace glint::test {

namespace {

using Pfm = PictureTest;

TEST_F(Pfm, WritesAndReadsTheSameBits) {
    const Image image = awkward_image();
    write_picture(file("a.pfm"), image);
    const LoadedPicture read = read_picture(file("a.pfm"));
    EXPECT_EQ(read.bits, 32);
    EXPECT_TRUE(same_bits(read.image, image));
}

TEST_F(Pfm, MayHaveMoreRowsThanTheSystemWritesAtOnce) {
    const Image image = varied_image(3, 5000);
    write_picture(file("a.pfm"), image);
    EXPECT_TRUE(same_bits(read_picture(file("a.pfm")).image, image));
}

TEST_F(Pfm, IsLittleEndianFromTheBottomAndNothingMore) {
    Image image(1, 2);
    image.pixels = {1, 2, 3, -1, 0.5f, 0};
    write_picture(file("a.pfm"), image);
    using namespace std::string_view_literals;
    EXPECT_EQ(load(file("a.pfm")), bytes_of("PF\n1 2\n-1.0\n"
                                            "\0\0\x80\xbf\0\0\0\x3f\0\0\0\0"
                                            "\0\0\x80\x3f\0\0\0\x40\0\0\x40\x40"sv));
}

TEST_F(Pfm, ReadsBothByteOrdersAndGray) {
    using namespace std::string_view_literals;
    EXPECT_EQ(read(bytes_of("PF 1 1 1.0\n\x3f\x80\0\0\x40\0\0\0\0\0\0\0"sv)).image.pixels,
              (std::vector{1.0f, 2.0f, 0.0f}));
    EXPECT_EQ(read(bytes_of("Pf\n1 2\n-2.5\n\0\0\x80\x3f\0\0\0\x40"sv)).image.pixels,
              (std::vector{2.0f, 2.0f, 2.0f, 1.0f, 1.0f, 1.0f}));
}

} // namespace

} // namespace glint::test
