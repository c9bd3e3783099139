#pragma once
// Pictures in memory: linear light, Rec. 709 primaries, 32-bit float.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace glint {

/// width × height RGB pixels, linear and unbounded. Pixel (0, 0) is top left, rows from the top.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<float> pixels; ///< width · height · 3 values, RGB interleaved

    Image() = default;
    Image(int w, int h)
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 3) {}

    /// Pointer to the three values of pixel (x, y).
    float* at(int x, int y) { return pixels.data() + offset(x, y); }
    const float* at(int x, int y) const { return pixels.data() + offset(x, y); }

  private:
    std::size_t offset(int x, int y) const {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
               3;
    }
};

/// XXH3-128 of the pixels as width × height × 3 float32, little endian, rows from the top: 32 hexadecimal
/// digits.
std::string picture_hash(const Image& image);

/// Differences of two pictures of equal size over all pixels and channels.
struct Comparison {
    double max = 0;   ///< largest absolute difference
    double mae = 0;   ///< mean absolute difference
    double rmse = 0;  ///< root of the mean squared difference
    double psnr = 0;  ///< dB against `peak`; infinite for equal pictures
    double share = 0; ///< fraction of pixels with a channel that differs by more than `tolerance`
};

/// Compares two pictures. `tolerance` is in units of the pictures and inclusive; `peak` is white (1 for
/// linear light, 255 for 8-bit values). NaN equals NaN and differs from numbers by infinity. Alpha, by pixel,
/// is a fourth channel if either has it; the other is then opaque.
Comparison compare(const Image& a, const Image& b, double tolerance, double peak,
                   std::span<const float> alpha_of_a = {}, std::span<const float> alpha_of_b = {});

/// A heat map of |a − b|: black for equal, through blue and yellow to white at `full_scale` and beyond. Alpha
/// as in compare(), opaque at 1.
Image difference_heat(const Image& a, const Image& b, double full_scale,
                      std::span<const float> alpha_of_a = {}, std::span<const float> alpha_of_b = {});

} // namespace glint
