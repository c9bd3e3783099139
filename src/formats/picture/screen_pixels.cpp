// Conversion of pictures to display codes.

#include "glint/picture_files.h"
#include "imaging/tone.h"

#include <algorithm>

namespace glint {

void screen_pixels(const Image& image, View view, std::vector<std::uint32_t>& pixels) {
    const auto width = static_cast<std::size_t>(image.width);
    pixels.resize(image.pixels.size() / 3);
    std::vector<std::uint8_t> row(3 * width);
    auto out = pixels.begin();
    for (int y = 0; y < image.height; ++y) {
        const float* light = image.at(0, y);
        if (view == View::srgb)
            imaging::srgb8_codes({light, row.size()}, row.data());
        else
            std::transform(light, light + row.size(), row.begin(), imaging::raw8_from_linear);
        for (std::size_t x = 0; x < width; ++x) {
            const std::uint8_t* code = row.data() + 3 * x;
            *out++ = 0xff000000U | std::uint32_t{code[0]} << 16U | std::uint32_t{code[1]} << 8U | code[2];
        }
    }
}

} // namespace glint
