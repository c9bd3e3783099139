#include "picture_support.h"

#include "imaging/tone.h"

namespace glint::test {
namespace {

TEST(ScreenPixels, AreTheCodesOfEachChannel) {
    const float odd[] = {std::numeric_limits<float>::quiet_NaN(), -1.0f, -0.0f, 1.0f, 1.5f, 1e30f,
                         std::numeric_limits<float>::infinity()};
    Image image(29, 31);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = i % 11 == 0 ? odd[i / 11 % std::size(odd)]
                                      : static_cast<float>(i) / static_cast<float>(image.pixels.size());
    std::vector<std::uint32_t> shown{1, 2, 3}; // of another picture
    for (const View view : {View::srgb, View::raw}) {
        screen_pixels(image, view, shown);
        ASSERT_EQ(shown.size(), 29u * 31u);
        const auto code = view == View::srgb ? imaging::srgb8_from_linear : imaging::raw8_from_linear;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const float* c = image.at(x, y);
                const std::uint32_t expected = 0xff000000u | std::uint32_t{code(c[0])} << 16u |
                                               std::uint32_t{code(c[1])} << 8u | code(c[2]);
                ASSERT_EQ(shown[static_cast<std::size_t>(y * image.width + x)], expected) << x << "," << y;
            }
    }
}

} // namespace
} // namespace glint::test
