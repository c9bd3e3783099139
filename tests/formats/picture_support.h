#pragma once
// What the tests of pictures share.

#include "formats/picture/codecs.h"
#include "glint/picture_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace glint::test {

namespace fs = std::filesystem;
using Bytes = std::vector<std::byte>;

/// A folder of its own for each test, empty at first and removed at the end.
class PictureTest : public testing::Test {
  protected:
    void SetUp() override {
        const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(testing::TempDir()) /
                  (std::string("glint_") + info->test_suite_name() + "_" + info->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }
    std::size_t file_count() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    static Bytes load(const std::string& path) {
        std::ifstream in(path, std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
        const auto* first = reinterpret_cast<const std::byte*>(text.data());
        return {first, first + text.size()};
    }

  private:
    fs::path folder_;
};

/// Runs `action`, which must throw an Error of this kind whose text holds all of `parts`.
inline void expect_error(ErrorKind kind, const std::vector<std::string>& parts,
                         const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        EXPECT_EQ(static_cast<int>(error.kind()), static_cast<int>(kind)) << error.what();
        for (const std::string& part : parts)
            EXPECT_NE(std::string_view(error.what()).find(part), std::string_view::npos)
                << "no '" << part << "' in: " << error.what();
        EXPECT_FALSE(error.diagnostics().front().hint.empty()) << "no cure in: " << error.what();
        return;
    }
    ADD_FAILURE() << "no error; expected one with '" << (parts.empty() ? "" : parts.front()) << "'";
}

/// The picture in these bytes, as if they came from a file of the name "picture".
inline LoadedPicture read(const Bytes& bytes) { return formats::decode_picture(bytes, "picture"); }

/// Bytes of a text.
inline Bytes bytes_of(std::string_view text) {
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    return {first, first + text.size()};
}

inline void append(Bytes& to, const Bytes& more) { to.insert(to.end(), more.begin(), more.end()); }

/// A 32-bit number, the highest byte first, as PNG has them.
inline Bytes big_endian(std::uint32_t value) {
    Bytes bytes;
    for (unsigned shift = 32; shift > 0; shift -= 8)
        bytes.push_back(static_cast<std::byte>(value >> (shift - 8) & 255U));
    return bytes;
}

/// A picture with bright, dark, negative and awkward values; pixels all differ.
inline Image varied_image(int width, int height) {
    Image image(width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<float>(i % 97) / 61.0f - 0.1f + static_cast<float>(i) * 1e-6f;
    return image;
}

/// Every kind of float: subnormal, −0, NaN with a payload, infinities.
inline Image awkward_image() {
    Image image = varied_image(37, 53);
    image.pixels[0] = -0.0f;
    image.pixels[1] = std::numeric_limits<float>::denorm_min();
    image.pixels[2] = std::numeric_limits<float>::infinity();
    image.pixels[3] = -std::numeric_limits<float>::max();
    image.pixels[4] = std::bit_cast<float>(0x7fc12345U);
    return image;
}

/// The same bits, NaN included.
inline bool same_bits(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height &&
           std::equal(a.pixels.begin(), a.pixels.end(), b.pixels.begin(), b.pixels.end(),
                      [](float x, float y) {
                          return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
                      });
}

/// PNG files made by hand, so that the reader meets more than what glint's own writer makes.
namespace png {

/// A chunk with its length and checksum.
Bytes chunk(std::string_view type, const Bytes& data);
/// The signature and an IHDR chunk.
Bytes head(std::uint32_t width, std::uint32_t height, int depth, int color_type, int interlaced = 0);
/// An IDAT chunk of these rows, each with its filter byte, stored without compression.
Bytes data(const std::vector<int>& rows);
/// A whole file: head, other chunks, data, end.
Bytes file(const Bytes& head, const Bytes& others, const std::vector<int>& rows);
/// Type and content of every chunk of a file, in order.
std::vector<std::pair<std::string, std::string>> chunks(const Bytes& file);

} // namespace png

} // namespace glint::test
