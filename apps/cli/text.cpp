// Texts of numbers, times and sizes.
#include "text.h"

#include <fmt/format.h>

#include <cmath>

namespace glint::cli {

std::string with_commas(std::uint64_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t from_end = 3; from_end < digits.size(); from_end += 4)
        digits.insert(digits.size() - from_end, 1, ',');
    return digits;
}

std::string counted(std::uint64_t number, const std::string& noun) {
    return with_commas(number) + " " + noun + (number == 1 ? "" : "s");
}

std::string duration(double seconds) {
    if (seconds < 0.9995) return fmt::format("{:.3f} s", seconds);
    if (seconds < 59.95) return fmt::format("{:.{}f} s", seconds, seconds < 9.995 ? 2 : 1);
    return whole_duration(std::round(seconds));
}

std::string whole_duration(double seconds) {
    const auto whole = static_cast<std::uint64_t>(std::ceil(seconds));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

double mega_rays(std::uint64_t rays, double seconds) {
    return seconds > 0 ? static_cast<double>(rays) / seconds / 1e6 : 0;
}

std::string ray_rate(std::uint64_t rays, double seconds) {
    return fmt::format("{:.2f} Mrays/s", mega_rays(rays, seconds));
}

std::string setting_name(const std::string& key) { return key.substr(key.rfind('.') + 1); }

} // namespace glint::cli
