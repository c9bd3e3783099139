// Parsing of colours.

#include "formats/scene/colors.h"

#include "formats/embedded.h"
#include "imaging/tone.h"
#include "scene/text.h"

#include <algorithm>
#include <charconv>
#include <sstream>

namespace glint::formats {
namespace {

// "#rgb" doubles each digit.
std::optional<std::uint32_t> hex_color(std::string_view digits) {
    std::string six(digits);
    if (six.size() == 3) six = {six[0], six[0], six[1], six[1], six[2], six[2]};
    if (six.size() != 6) return std::nullopt;
    std::uint32_t rgb = 0;
    const auto [end, fault] = std::from_chars(six.data(), six.data() + six.size(), rgb, 16);
    return fault == std::errc() && end == six.data() + six.size() ? std::optional(rgb) : std::nullopt;
}

// rgb.txt rounds 2.55 · n, a product of binary fractions: gray50 is 127, not 128.
std::uint32_t x11_gray(int percent) {
    const auto code = static_cast<std::uint32_t>(2.55 * percent + 0.5);
    return code << 16 | code << 8 | code;
}

std::optional<std::uint32_t> gray_percent(std::string_view name) {
    if (!name.starts_with("gray") && !name.starts_with("grey")) return std::nullopt;
    for (int percent = 0; percent <= 100; ++percent)
        if (name.substr(4) == std::to_string(percent)) return x11_gray(percent);
    return std::nullopt;
}

struct NamedColor {
    std::string name; ///< lower case
    std::uint32_t rgb;
};

// The names of CSS Color Module Level 4, section 6.1, then the numbered shades of X11's rgb.txt without its
// greys, which follow a formula.
const std::vector<NamedColor>& named_colors() {
    static const std::vector<NamedColor> colors = [] {
        std::vector<NamedColor> all;
        std::istringstream lines{std::string(embedded_text("formats/scene/colors.txt"))};
        for (std::string name, digits; lines >> name >> digits;) all.push_back({name, *hex_color(digits)});
        return all;
    }();
    return colors;
}

} // namespace

std::optional<std::uint32_t> color_codes(std::string_view text) {
    if (text.starts_with('#')) return hex_color(text.substr(1));
    const std::string name = scene::lower_case(text);
    const auto found = std::ranges::find(named_colors(), name, &NamedColor::name);
    if (found != named_colors().end()) return found->rgb;
    return gray_percent(name);
}

Vec3 linear_color(std::uint32_t rgb, ColorValues values) {
    const auto linear = [&](int shift) {
        const double value = static_cast<double>(rgb >> shift & 0xffu) / 255.0;
        return values == ColorValues::srgb ? imaging::linear_from_srgb(value) : value;
    };
    return {linear(16), linear(8), linear(0)};
}

std::vector<std::string> color_names() {
    std::vector<std::string> names;
    for (const NamedColor& color : named_colors()) names.push_back(color.name);
    return names;
}

} // namespace glint::formats
