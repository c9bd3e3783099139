#pragma once
// Colours as people write them: "#rgb", "#rrggbb", and names.

#include "glint/scene.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// How the codes 0 … 255 of a written colour become linear light.
enum class ColorValues {
    srgb,  ///< decoded by the sRGB curve
    linear ///< divided by 255
};

struct NamedColor {
    std::string_view name; ///< lower case
    std::uint32_t rgb;     ///< 0xrrggbb
};

/// An X11 name that stands for four colours: NAME1 to NAME4.
struct ShadedColor {
    std::string_view name; ///< lower case
    std::uint32_t rgb[4];
};

/// The 148 names of CSS Color Module Level 4.
std::span<const NamedColor> css_colors();

/// The 78 numbered names of X11's rgb.txt; besides them there are gray0 … gray100 and grey0 … grey100.
std::span<const ShadedColor> x11_shades();

/// 0xrrggbb of "#rgb", "#rrggbb" or a name in any case; CSS names win over X11's. None: there is no such
/// colour.
std::optional<std::uint32_t> color_codes(std::string_view text);

/// Linear RGB of 0xrrggbb.
Vec3 linear_color(std::uint32_t rgb, ColorValues values);

/// All names, for suggestions.
std::vector<std::string> color_names();

} // namespace glint
