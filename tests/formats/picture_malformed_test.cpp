#include "picture_support.h"

#include "formats/picture/exr_header.h"

namespace glint::test {

namespace {

using Malformed = PictureTest;
using namespace std::string_view_literals;

/// Reading these bytes must fail with Error(input) that names the file and holds all of `parts`.
#define EXPECT_REFUSED(bytes, ...)                                                                           \
    do {                                                                                                     \
        SCOPED_TRACE("refusing");                                                                            \
        std::vector<std::string> parts{__VA_ARGS__};                                                         \
        parts.emplace_back("picture");                                                                       \
        expect_error(ErrorKind::input, parts, [&] { read(bytes); });                                         \
    } while (false)

TEST_F(Malformed, FilesThatAreNoPictures) {
    EXPECT_REFUSED({}, "the file is empty");
    EXPECT_REFUSED(bytes_of("\xff\xd8\xff\xe0JFIF"), "no picture in PNG, EXR or PFM");
    EXPECT_REFUSED(bytes_of("\x1f\x8b\x08"), "compressed with gzip", "gunzip");
    EXPECT_REFUSED(bytes_of("BZh91AY&SY"), "compressed with bzip2");
    EXPECT_REFUSED(bytes_of("P6\n1 1\n255\nabc"), "no picture in PNG, EXR or PFM");
}

TEST_F(Malformed, FilesThatAreNotThere) {
    expect_error(ErrorKind::input, {"missing.png", "No such file", "check the name"},
                 [&] { read_picture(file("missing.png")); });
    fs::create_directory(file("folder.png"));
    expect_error(ErrorKind::input, {"folder.png", "Is a directory"},
                 [&] { read_picture(file("folder.png")); });
}

TEST_F(Malformed, PngWithLyingSizes) {
    const std::vector<int> row{0, 1, 2, 3};
    EXPECT_REFUSED(png::file(png::head(70000, 1, 8, 2), {}, row), "70000 x 1", "65,536 pixels a side");
    EXPECT_REFUSED(png::file(png::head(65536, 65536, 8, 2), {}, row), "65536 x 65536", "2^30");
    EXPECT_REFUSED(png::file(png::head(0x7fffffff, 0x7fffffff, 16, 6), {}, row), "2147483647 x 2147483647");
    EXPECT_REFUSED(png::file(png::head(0, 1, 8, 2), {}, row), "damaged PNG");
    // Sizes within the limits that so few bytes can never fill take no memory.
    EXPECT_REFUSED(png::file(png::head(32768, 32768, 16, 2), {}, row), "too short for 32768 x 32768 pixels");
    EXPECT_REFUSED(png::file(png::head(2, 2, 8, 2), {}, row), "damaged PNG");
}

TEST_F(Malformed, PngWithBadHeaderFields) {
    EXPECT_REFUSED(png::file(png::head(1, 1, 3, 2), {}, {0, 1, 2, 3}), "damaged PNG");
    EXPECT_REFUSED(png::file(png::head(1, 1, 8, 5), {}, {0, 1, 2, 3}), "damaged PNG");
    EXPECT_REFUSED(png::file(png::head(1, 1, 8, 2, 9), {}, {0, 1, 2, 3}), "damaged PNG");
    EXPECT_REFUSED(bytes_of("\x89PNG\n\n\x1a\n"), "damaged PNG");
    EXPECT_REFUSED(bytes_of("\x89PNG"), "damaged PNG", "the data end early");
}

TEST_F(Malformed, PngWithBadChunks) {
    EXPECT_REFUSED(png::file(png::head(1, 1, 8, 3), {}, {0, 0}), "damaged PNG", "PLTE");
    EXPECT_REFUSED(png::file(png::head(1, 1, 8, 2), png::chunk("QQQQ", {}), {0, 1, 2, 3}), "damaged PNG");
    EXPECT_REFUSED(png::file(png::head(1, 1, 8, 2), {}, {7, 1, 2, 3}), "damaged PNG", "filter");

    Bytes wrong_sum = png::file(png::head(1, 1, 8, 2), {}, {0, 1, 2, 3});
    wrong_sum[8 + 8 + 13] ^= std::byte{1};
    EXPECT_REFUSED(wrong_sum, "damaged PNG", "CRC");

    Bytes too_long = png::head(1, 1, 8, 2);
    append(too_long, big_endian(0x7fffffff));
    append(too_long, bytes_of("tEXtt"));
    EXPECT_REFUSED(too_long, "damaged PNG", "a chunk is longer than the file");

    Bytes no_data = png::head(1, 1, 8, 2);
    append(no_data, png::chunk("IEND", {}));
    EXPECT_REFUSED(no_data, "damaged PNG");
}

TEST_F(Malformed, PfmWithBadHeaders) {
    const std::string pixel(12, '\0');
    EXPECT_REFUSED(bytes_of("PF"), "ends within its header");
    EXPECT_REFUSED(bytes_of("PF\n1 1"), "ends within its header");
    EXPECT_REFUSED(bytes_of("PF\n1 1\n-1.0"), "ends within its header");
    EXPECT_REFUSED(bytes_of("PFM\n1 1\n-1.0\n" + pixel), "not 'PF' or 'Pf'");
    EXPECT_REFUSED(bytes_of("PF\none 1\n-1.0\n" + pixel), "the width is no valid number", "byte 3");
    EXPECT_REFUSED(bytes_of("PF\n1 99999999999999\n-1.0\n" + pixel), "the height is no valid number",
                   "byte 5");
    EXPECT_REFUSED(bytes_of("PF\n1 -1\n-1.0\n" + pixel), "1 x -1");
    EXPECT_REFUSED(bytes_of("PF\n65536 65536\n-1.0\n" + pixel), "65536 x 65536");
    EXPECT_REFUSED(bytes_of("PF\n1 1\n0\n" + pixel), "the scale is neither positive nor negative");
    EXPECT_REFUSED(bytes_of("PF\n1 1\nnan\n" + pixel), "the scale is neither positive nor negative");
    EXPECT_REFUSED(bytes_of("PF\n1 1\n-1.0x\n" + pixel), "the scale is no valid number");
}

TEST_F(Malformed, PfmWithTooFewOrTooManyPixels) {
    EXPECT_REFUSED(bytes_of("PF\n1 1\n-1.0\n12345678901"sv), "11 bytes of pixels", "promises 12", "byte 12");
    EXPECT_REFUSED(bytes_of("PF\n1 1\n-1.0\n1234567890123"sv), "13 bytes of pixels", "promises 12");
    EXPECT_REFUSED(bytes_of("Pf\n32768 32768\n-1.0\n1234"sv), "promises 4294967296");
}

#ifdef GLINT_WITH_EXR
/// A small EXR of glint's own, and places in its header.
class MalformedExr : public PictureTest {
  protected:
    void SetUp() override {
        PictureTest::SetUp();
        write_picture(file("good.exr"), varied_image(9, 40));
        good_ = load(file("good.exr"));
    }

    /// The offset of an attribute's length field; its value follows.
    std::size_t length_field(const std::string& name, const std::string& type) const {
        const std::string text(reinterpret_cast<const char*>(good_.data()), good_.size());
        const std::string key = name + '\0' + type + '\0';
        const std::size_t at = text.find(key);
        EXPECT_NE(at, std::string::npos) << name;
        return at + key.size();
    }

    /// The good file with a little-endian number put in.
    Bytes with(std::size_t at, std::uint32_t value) const {
        Bytes changed = good_;
        std::ranges::copy(bytes_of(little_endian(value)), changed.begin() + static_cast<std::ptrdiff_t>(at));
        return changed;
    }

    /// The good file with an attribute more.
    Bytes with_attribute(const std::string& type, const std::string& value) const {
        const std::string text =
            "more" + std::string(1, '\0') + type + '\0' + little_endian(value.size()) + value;
        Bytes changed = good_;
        const Bytes added = bytes_of(text);
        changed.insert(changed.begin() + 8, added.begin(), added.end());
        return changed;
    }

    static std::string little_endian(std::size_t value) {
        std::string text;
        for (std::size_t i = 0; i < 4; ++i) text += static_cast<char>(value >> (8 * i) & 255U);
        return text;
    }

    /// An entry of a list of channels.
    static std::string channel(const std::string& name) {
        return name + '\0' + little_endian(2) + little_endian(0) + little_endian(1) + little_endian(1);
    }

    Bytes good_;
};

TEST_F(MalformedExr, HeadersThatLie) {
    const std::size_t window = length_field("dataWindow", "box2i") + 4;
    EXPECT_REFUSED(with(window + 8, 0x7fffffff), "2147483648 x 40");
    EXPECT_REFUSED(with(window + 8, 0xffffffff), "0 x 40");
    EXPECT_REFUSED(with(window + 12, 60000), "damaged EXR");
    Bytes large = with(window + 8, 6000);
    std::copy_n(with(window + 12, 1600).begin() + static_cast<std::ptrdiff_t>(window) + 12, 4,
                large.begin() + static_cast<std::ptrdiff_t>(window) + 12);
    EXPECT_REFUSED(large, "damaged EXR");
    EXPECT_REFUSED(with(window, 0x80000000U), "65,536 pixels a side");
    EXPECT_REFUSED(with(length_field("channels", "chlist"), 0x7fffffff),
                   "an attribute is longer than the file");
    EXPECT_REFUSED(with(length_field("channels", "chlist"), 0xffffffff),
                   "an attribute is longer than the file");
    EXPECT_REFUSED(with(4, 3), "unknown version");
    EXPECT_REFUSED(with(4, 0x802), "deep pixels", "one part");
    EXPECT_REFUSED(with(4, 0x1002), "several parts");

    Bytes no_window = good_;
    no_window[length_field("dataWindow", "box2i") - 7] = std::byte{'W'};
    EXPECT_REFUSED(no_window, "no data window");

    Bytes no_compression = good_;
    no_compression[length_field("compression", "compression") + 4] = std::byte{77};
    EXPECT_REFUSED(no_compression, "damaged EXR");
}

TEST_F(MalformedExr, AttributesOfOtherLengthsThanTheirTypes) {
    const std::string nul(1, '\0');
    const std::string much = little_endian(0x7ffffff0);
    const std::pair<std::string, std::string> damaged[] = {
        {"float", "123"},
        {"box2i", std::string(15, '1')},
        {"m44d", std::string(129, '1')},
        {"compression", ""},
        {"floatvector", "123456"},
        {"idmanifest", "123"},
        {"preview", little_endian(1) + little_endian(1) + "123"},
        {"preview", much + much + "1234"},
        {"preview", little_endian(0)},
        {"stringvector", much + "abc"},
        {"stringvector", little_endian(2) + "abc"},
        {"chlist", ""},
        {"chlist", channel("B")},
        {"chlist", channel("B") + "G" + nul + little_endian(2) + nul},
        {"chlist", channel("B") + nul + "123"},
    };
    for (const auto& more : damaged)
        EXPECT_REFUSED(with_attribute(more.first, more.second),
                       "the attribute 'more' is no whole " + more.first, "byte 8");
    EXPECT_REFUSED(with_attribute(std::string(256, 'x'), ""), "longer than 255 bytes");

    const std::pair<std::string, std::string> whole[] = {
        {"float", "1234"},
        {"floatvector", "12345678"},
        {"preview", little_endian(1) + little_endian(2) + "12345678"},
        {"stringvector", little_endian(3) + "abc" + little_endian(0)},
        {"chlist", channel("B") + nul},
        {"string", ""},
        {"unknown", "12345"},
    };
    for (const auto& [type, value] : whole)
        EXPECT_EQ(formats::read_exr_header(with_attribute(type, value), "picture").window.width(), 9) << type;
}

TEST_F(MalformedExr, BlocksThatMemoryDoesNotHold) {
    std::string channels;
    for (int i = 0; i < 2000; ++i) channels += channel("c" + std::to_string(i));
    constexpr char dwab = 9;
    good_[length_field("compression", "compression") + 4] = std::byte{dwab};
    good_ = with(length_field("dataWindow", "box2i") + 12, 65535);
    expect_error(ErrorKind::resource, {"picture", "65536 x 40 pixels", "GiB of memory"},
                 [&] { read(with_attribute("chlist", channels + '\0')); });
}

TEST_F(MalformedExr, EveryCut) {
    for (std::size_t size = 4; size < good_.size(); size += size < 500 ? 1 : 37) {
        SCOPED_TRACE(size);
        EXPECT_REFUSED(Bytes(good_.begin(), good_.begin() + static_cast<std::ptrdiff_t>(size)));
    }
}
#endif

/// Changes single bytes all over a file; reading must end in a picture or in an Error about the input.
void read_with_changes(const Bytes& good, int min_refused) {
    int refused = 0;
    for (std::size_t at = 0; at < good.size(); ++at)
        for (const unsigned change : {0x01U, 0x80U, 0xffU}) {
            Bytes changed = good;
            changed[at] ^= static_cast<std::byte>(change);
            try {
                read(changed);
            } catch (const Error& error) {
                EXPECT_TRUE(error.kind() == ErrorKind::input || error.kind() == ErrorKind::resource)
                    << error.what();
                ++refused;
            }
        }
    EXPECT_GE(refused, min_refused);
}

#ifdef GLINT_WITH_EXR
TEST_F(MalformedExr, AnyChangedByteIsReadOrRefused) {
    write_picture(file("good.exr"), varied_image(3, 18));
    read_with_changes(load(file("good.exr")), 20);
}
#endif

TEST_F(Malformed, AnyChangedByteOfAPngOrPfmIsReadOrRefused) {
    write_picture(file("good.png"), varied_image(5, 4));
    read_with_changes(load(file("good.png")), 20);
    write_picture(file("good.pfm"), varied_image(2, 2));
    read_with_changes(load(file("good.pfm")), 20);
}

TEST_F(Malformed, EveryCutOfAPngAndAPfm) {
    for (const char* name : {"good.png", "good.pfm"}) {
        write_picture(file(name), varied_image(5, 4));
        const Bytes good = load(file(name));
        for (std::size_t size = 0; size < good.size(); ++size) {
            SCOPED_TRACE(size);
            EXPECT_REFUSED(Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)));
        }
    }
}

} // namespace

} // namespace glint::test
