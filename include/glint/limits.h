#pragma once
// The limits of scenes and pictures.

#include <cstdint>

namespace glint {

/// Coordinates and lengths end here, in scene units.
inline constexpr double coordinate_limit = 1e12;

/// Pixels of a picture's side, and of the whole.
inline constexpr int picture_side_limit = 65536;
inline constexpr std::int64_t picture_pixel_limit = std::int64_t{1} << 30;

/// Samples per pixel.
inline constexpr int sample_limit = 1 << 20;

} // namespace glint
