#pragma once
// Pixel reconstruction filters.

#include "glint/enum_names.h"

namespace glint {

/// All are separable: f(x) · f(y), with x and y in pixels from the pixel's centre.
enum class PixelFilter {
    box,      ///< 1 for |x| ≤ 0.5
    tent,     ///< 1 − |x|, radius 1
    gaussian, ///< e^(−2x²) − e^(−2r²), radius r = 1.5 (standard deviation 0.5 pixel)
    mitchell, ///< Mitchell and Netravali 1988 with B = C = 1/3, radius 2; below 0 between 8/7 and 2
};
template <>
inline constexpr NamesUpTo<PixelFilter::mitchell> enum_names<PixelFilter>{"box", "tent", "gaussian",
                                                                          "mitchell"};

} // namespace glint
