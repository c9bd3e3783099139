#pragma once
// Colours in scene files: "#rgb", "#rrggbb", and names.

#include "glint/scene.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint::formats {

/// Conversion of the codes 0 … 255 of a colour to linear light.
enum class ColorValues {
    srgb,  ///< decoded by the sRGB curve
    linear ///< divided by 255
};
} // namespace glint::formats

namespace glint {

template <>
inline constexpr NamesUpTo<formats::ColorValues::linear> enum_names<formats::ColorValues>{"srgb", "linear"};

} // namespace glint

namespace glint::formats {

/// 0xrrggbb of "#rgb", "#rrggbb" or a case-insensitive name: the 148 of CSS Color Module Level 4, the 78
/// shaded ones of X11's rgb.txt with their numbers 1 to 4, gray0 … gray100 and grey0 … grey100. None if there
/// is no such colour.
std::optional<std::uint32_t> color_codes(std::string_view text);

/// Linear RGB of 0xrrggbb.
Vec3 linear_color(std::uint32_t rgb, ColorValues values);

/// All names but the numbered greys, for suggestions.
std::vector<std::string> color_names();

} // namespace glint::formats
