#pragma once
// The limits of scenes and pictures.

#include <cstdint>

namespace glint {

/// Largest coordinate and length, in scene units.
inline constexpr double coordinate_limit = 1e12;

/// Largest side of a picture, and largest number of pixels.
inline constexpr int picture_side_limit = 65536;
inline constexpr std::int64_t picture_pixel_limit = std::int64_t{1} << 30;

/// Largest number of samples per pixel.
inline constexpr int sample_limit = 1 << 20;

} // namespace glint
