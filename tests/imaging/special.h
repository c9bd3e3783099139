#pragma once
// The floats that are no numbers to reckon with.

#include <limits>

namespace glint::imaging {

inline constexpr float no_number = std::numeric_limits<float>::quiet_NaN();
inline constexpr float infinity = std::numeric_limits<float>::infinity();

} // namespace glint::imaging
