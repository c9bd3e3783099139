#include "picture_support.h"

#include "imaging/tone.h"

#include <limits>

namespace glint::test {

namespace {

using Png = PictureTest;

/// Values of a picture as whole numbers.
std::vector<int> codes(const LoadedPicture& picture) {
    std::vector<int> values;
    for (const float value : picture.image.pixels) values.push_back(static_cast<int>(value));
    return values;
}

TEST_F(Png, EveryCodeSurvivesWritingAndReading) {
    Image ramp(16, 16);
    for (std::size_t i = 0; i < ramp.pixels.size(); ++i)
        ramp.pixels[i] = imaging::linear_from_srgb8(static_cast<std::uint8_t>(i * 7 % 256));
    write_picture(file("ramp.png"), ramp);
    const LoadedPicture read = read_picture(file("ramp.png"));
    EXPECT_EQ(read.bits, 8);
    ASSERT_EQ(read.image.pixels.size(), ramp.pixels.size());
    for (std::size_t i = 0; i < ramp.pixels.size(); ++i)
        EXPECT_EQ(read.image.pixels[i], static_cast<float>(i * 7 % 256));
}

TEST_F(Png, EverySixteenBitCodeSurvivesWritingAndReading) {
    Image ramp(256, 86);
    for (std::size_t i = 0; i < ramp.pixels.size(); ++i)
        ramp.pixels[i] = imaging::linear_from_srgb16(static_cast<std::uint16_t>(i % 65536));
    PictureOptions options;
    options.bits = 16;
    write_picture(file("ramp.png"), ramp, options);
    const LoadedPicture read = read_picture(file("ramp.png"));
    EXPECT_EQ(read.bits, 16);
    ASSERT_EQ(read.image.pixels.size(), ramp.pixels.size());
    for (std::size_t i = 0; i < ramp.pixels.size(); ++i)
        ASSERT_EQ(read.image.pixels[i], static_cast<float>(i % 65536));
}

TEST_F(Png, RawViewTruncatesWithoutACurve) {
    Image image(2, 1);
    image.pixels = {0.5f, 1.0f, 0.999f, -1.0f, std::numeric_limits<float>::quiet_NaN(), 7.0f};
    PictureOptions options;
    options.view = View::raw;
    write_picture(file("raw.png"), image, options);
    EXPECT_EQ(codes(read_picture(file("raw.png"))), (std::vector{127, 255, 254, 0, 0, 255}));
    options.bits = 16;
    write_picture(file("raw.png"), image, options);
    EXPECT_EQ(codes(read_picture(file("raw.png"))), (std::vector{32767, 65535, 65469, 0, 0, 65535}));
}

TEST_F(Png, NamesItsCurveInAChunkAndNothingElse) {
    const auto types = [&](View view) {
        PictureOptions options;
        options.view = view;
        write_picture(file("a.png"), varied_image(4, 4), options);
        std::string joined;
        for (const auto& [type, content] : png::chunks(load(file("a.png")))) joined += type + " ";
        return joined;
    };
    EXPECT_EQ(types(View::srgb), "IHDR sRGB IDAT IEND ");
    EXPECT_EQ(types(View::raw), "IHDR IDAT IEND ");
}

TEST_F(Png, CarriesMetadataAsText) {
    PictureOptions options;
    options.metadata = {{"scene hash", "0123abcd"}, {"title", "Königsblau"}};
    write_picture(file("a.png"), varied_image(3, 2), options);
    std::vector<std::pair<std::string, std::string>> texts;
    for (const auto& [type, content] : png::chunks(load(file("a.png"))))
        if (type == "tEXt" || type == "iTXt") texts.emplace_back(type, content);
    ASSERT_EQ(texts.size(), 2U);
    using namespace std::string_literals;
    EXPECT_EQ(texts[0], std::pair("tEXt"s, "scene hash\0"s + "0123abcd"));
    EXPECT_EQ(texts[1], std::pair("iTXt"s, "title\0\0\0\0\0"s + "Königsblau"));
}

TEST_F(Png, StoresStraightAlpha) {
    PictureOptions options;
    options.alpha = {0.0f, 0.5f, 1.0f, 2.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()};
    Image half(3, 2);
    std::fill(half.pixels.begin(), half.pixels.end(), 0.5f);
    write_picture(file("a.png"), half, options);

    // Half of a white pixel is white; where nothing is, is black. IHDR says RGBA (6).
    const LoadedPicture read = read_picture(file("a.png"));
    EXPECT_EQ(codes(read), (std::vector{0, 0, 0, 255, 255, 255, 188, 188, 188, //
                                        188, 188, 188, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(read.alpha, (std::vector<float>{0, 128, 255, 255, 0, 0}));
    EXPECT_EQ(png::chunks(load(file("a.png"))).front().second[9], 6);
}

TEST_F(Png, SamePictureSameBytes) {
    PictureOptions options;
    options.metadata = {{"version", "1"}};
    options.bits = 16;
    write_picture(file("a.png"), varied_image(31, 17), options);
    write_picture(file("b.png"), varied_image(31, 17), options);
    EXPECT_EQ(load(file("a.png")), load(file("b.png")));
}

TEST_F(Png, ReadsGrayOfEveryDepthAsRgb) {
    // One bit: 0, 1, 1; four bits: 0, 15, 7; gray with alpha: 9, 200.
    EXPECT_EQ(codes(read(png::file(png::head(3, 1, 1, 0), {}, {0, 0x60}))),
              (std::vector{0, 0, 0, 255, 255, 255, 255, 255, 255}));
    EXPECT_EQ(codes(read(png::file(png::head(3, 1, 4, 0), {}, {0, 0x0f, 0x70}))),
              (std::vector{0, 0, 0, 255, 255, 255, 119, 119, 119}));
    EXPECT_EQ(codes(read(png::file(png::head(2, 1, 8, 4), {}, {0, 9, 0, 200, 255}))),
              (std::vector{9, 9, 9, 200, 200, 200}));
    const LoadedPicture wide = read(png::file(png::head(1, 1, 16, 0), {}, {0, 1, 2}));
    EXPECT_EQ(wide.bits, 16);
    EXPECT_EQ(codes(wide), (std::vector{258, 258, 258}));
}

TEST_F(Png, ReadsPalettesAndTheirTransparencyAndIgnoresGamma) {
    Bytes others = png::chunk("gAMA", big_endian(100000));
    append(others, png::chunk("PLTE", bytes_of("abcdef")));
    append(others, png::chunk("tRNS", bytes_of(std::string_view("\0", 1))));
    const LoadedPicture picture = read(png::file(png::head(2, 1, 8, 3), others, {0, 1, 0}));
    EXPECT_EQ(picture.bits, 8);
    EXPECT_EQ(codes(picture), (std::vector<int>{'d', 'e', 'f', 'a', 'b', 'c'}));
    EXPECT_EQ(picture.alpha, (std::vector<float>{255, 0}));
}

TEST_F(Png, ReadsInterlacedRows) {
    // Adam7 of 2 × 2 pixels: pass 1 has (0,0), pass 6 has (1,0), pass 7 the second row.
    const LoadedPicture picture = read(png::file(png::head(2, 2, 8, 0, 1), {}, {0, 10, 0, 20, 0, 30, 40}));
    EXPECT_EQ(codes(picture), (std::vector{10, 10, 10, 20, 20, 20, 30, 30, 30, 40, 40, 40}));
}

} // namespace

} // namespace glint::test
