#include "picture_support.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfRgbaFile.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputFile.h>

namespace glint::test {

namespace {

using Exr = PictureTest;

/// One channel of an EXR, read by OpenEXR itself.
std::vector<float> channel_of(const std::string& path, const std::string& name, int width, int height) {
    std::vector<float> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), -99.0f);
    Imf::InputFile file(path.c_str(), 0);
    Imf::FrameBuffer buffer;
    const auto stride = sizeof(float) * static_cast<std::size_t>(width);
    buffer.insert(name,
                  Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float), stride));
    file.setFrameBuffer(buffer);
    file.readPixels(0, height - 1);
    return values;
}

TEST_F(Exr, WritesAndReadsTheSameBits) {
    const Image image = awkward_image();
    write_picture(file("a.exr"), image);
    const LoadedPicture read = read_picture(file("a.exr"));
    EXPECT_EQ(read.bits, 32);
    EXPECT_TRUE(same_bits(read.image, image));
}

TEST_F(Exr, SamePictureSameBytes) {
    PictureOptions options;
    options.metadata = {{"version", "1"}};
    write_picture(file("a.exr"), awkward_image(), options);
    write_picture(file("b.exr"), awkward_image(), options);
    EXPECT_EQ(load(file("a.exr")), load(file("b.exr")));
}

TEST_F(Exr, CarriesAlphaAndMetadata) {
    PictureOptions options;
    options.alpha = {0, 0.25f, 0.5f, 1, 2, 3};
    options.metadata = {{"compression", "not OpenEXR's own"},
                        {"a name that is longer than OpenEXR's short ones", "x"},
                        {"glint.hash", "0123"}};
    write_picture(file("a.exr"), varied_image(3, 2), options);
    EXPECT_EQ(channel_of(file("a.exr"), "A", 3, 2), options.alpha);
    EXPECT_EQ(read_picture(file("a.exr")).alpha, options.alpha);

    const Imf::InputFile read(file("a.exr").c_str(), 0);
    const auto* first = read.header().findTypedAttribute<Imf::StringAttribute>("glint.compression");
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(first->value(), "not OpenEXR's own");
    EXPECT_NE(read.header().findTypedAttribute<Imf::StringAttribute>("glint.hash"), nullptr);
    EXPECT_EQ(read.header().compression(), Imf::ZIP_COMPRESSION);
    EXPECT_NE(read.header().findTypedAttribute<Imf::StringAttribute>("glint." + options.metadata[1].first),
              nullptr);
}

TEST_F(Exr, APartKeepsItsPlace) {
    PictureOptions options;
    options.x = 5;
    options.y = 7;
    options.full_width = 20;
    options.full_height = 10;
    const Image part = varied_image(3, 2);
    write_picture(file("a.exr"), part, options);
    const Imf::InputFile read(file("a.exr").c_str(), 0);
    EXPECT_EQ(read.header().dataWindow(), Imath::Box2i({5, 7}, {7, 8}));
    EXPECT_EQ(read.header().displayWindow(), Imath::Box2i({0, 0}, {19, 9}));
    EXPECT_EQ(read_picture(file("a.exr")).image.pixels, part.pixels);
    options.full_width = 7;
    expect_error(ErrorKind::usage, {"does not lie within the whole", "7 x 10"},
                 [&] { write_picture(file("b.exr"), part, options); });
}

TEST_F(Exr, MayBePackedMoreThanDeflateCan) {
    // One colour in blocks of cosines is a few bytes for 256 rows.
    Imf::Header header(4096, 4096);
    header.compression() = Imf::DWAB_COMPRESSION;
    std::vector<half> pixels(4096, half(0.5f));
    Imf::FrameBuffer buffer;
    for (const char* name : {"R", "G", "B"}) {
        header.channels().insert(name, Imf::Channel(Imf::HALF));
        buffer.insert(name, Imf::Slice(Imf::HALF, reinterpret_cast<char*>(pixels.data()), sizeof(half), 0));
    }
    {
        Imf::OutputFile out(file("a.exr").c_str(), header, 0);
        out.setFrameBuffer(buffer);
        out.writePixels(4096);
    }
    EXPECT_LT(fs::file_size(file("a.exr")), 4096u * 4096u * 2u / 1032u);
    EXPECT_EQ(read_picture(file("a.exr")).image.height, 4096);
}

TEST_F(Exr, LayersAddUpToThePictureToTheBit) {
    // A picture that is the float sum of its terms, in their order, must be so after a trip through the file.
    const Image first = varied_image(19, 21);
    Image second = first;
    for (float& value : second.pixels) value = value * value * 0.3f + 1e-5f;
    Image picture(19, 21);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        picture.pixels[i] = first.pixels[i] + second.pixels[i];
    PictureOptions options;
    options.layers = {{"diffuse", first}, {"highlight", second}};
    write_picture(file("a.exr"), picture, options);

    const Image read = read_picture(file("a.exr")).image;
    EXPECT_TRUE(same_bits(read, picture));
    const std::array<std::string, 3> channels{"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        const std::vector<float> a = channel_of(file("a.exr"), "diffuse." + channels[c], 19, 21);
        const std::vector<float> b = channel_of(file("a.exr"), "highlight." + channels[c], 19, 21);
        for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(a[i] + b[i], read.pixels[3 * i + c]);
    }
}

TEST_F(Exr, ReadsHalfFloatsInAWindowOfItsOwn) {
    Imf::Header header(Imath::Box2i({0, 0}, {99, 99}), Imath::Box2i({-3, 10}, {0, 11}));
    std::vector<Imf::Rgba> pixels;
    for (int i = 0; i < 8; ++i) pixels.emplace_back(half(static_cast<float>(i)), half(0.5f), half(-1.0f));
    {
        Imf::RgbaOutputFile out(file("half.exr").c_str(), header, Imf::WRITE_RGB);
        out.setFrameBuffer(pixels.data() + 3 - std::ptrdiff_t{4} * 10, 1, 4);
        out.writePixels(2);
    }

    const LoadedPicture read = read_picture(file("half.exr"));
    ASSERT_EQ(read.image.width, 4);
    ASSERT_EQ(read.image.height, 2);
    EXPECT_EQ(read.image.at(2, 1)[0], 6.0f);
    EXPECT_EQ(read.image.at(0, 0)[1], 0.5f);
    EXPECT_EQ(read.image.at(3, 1)[2], -1.0f);
}

/// An EXR of 2 × 1 pixels with these float channels, all holding 0.25 and 4.
void write_channels(const std::string& path, const std::vector<std::string>& names) {
    const std::vector<float> values{0.25f, 4.0f};
    Imf::Header header(2, 1);
    Imf::FrameBuffer buffer;
    for (const std::string& name : names) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        char* base = reinterpret_cast<char*>(const_cast<float*>(values.data()));
        buffer.insert(name, Imf::Slice(Imf::FLOAT, base, sizeof(float), 2 * sizeof(float)));
    }
    Imf::OutputFile out(path.c_str(), header, 0);
    out.setFrameBuffer(buffer);
    out.writePixels(1);
}

TEST_F(Exr, ReadsLuminanceAsGray) {
    write_channels(file("y.exr"), {"Y"});
    EXPECT_EQ(read_picture(file("y.exr")).image.pixels, (std::vector{0.25f, 0.25f, 0.25f, 4.0f, 4.0f, 4.0f}));
}

TEST_F(Exr, RefusesAPictureWithoutAllOfRgbAndNamesItsChannels) {
    write_channels(file("rg.exr"), {"R", "G", "A"});
    expect_error(ErrorKind::input, {"rg.exr", "neither R, G and B nor Y", "A, G, R"},
                 [&] { read_picture(file("rg.exr")); });
    write_channels(file("chroma.exr"), {"Y", "RY", "BY"});
    expect_error(ErrorKind::input, {"BY, RY, Y"}, [&] { read_picture(file("chroma.exr")); });
}

TEST_F(Exr, RefusesTiles) {
    {
        Imf::Header header(2, 2);
        header.channels().insert("R", Imf::Channel(Imf::FLOAT));
        header.setTileDescription(Imf::TileDescription(16, 16, Imf::ONE_LEVEL));
        const Imf::TiledOutputFile out(file("tiles.exr").c_str(), header, 0);
    }
    expect_error(ErrorKind::input, {"in tiles", "by scan lines"}, [&] { read_picture(file("tiles.exr")); });
}

} // namespace

} // namespace glint::test
