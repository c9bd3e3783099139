// Comparing pictures: error measures and heat maps.

#include "glint/error.h"
#include "glint/image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace glint {

namespace {

/// |a − b| in double precision. Equal values and two NaN differ by 0, NaN and a number by infinity.
double difference(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    if (std::isnan(a) || std::isnan(b)) return std::numeric_limits<double>::infinity();
    return std::abs(static_cast<double>(a) - static_cast<double>(b));
}

void require_same_size(const Image& a, const Image& b) {
    if (a.width == b.width && a.height == b.height) return;
    const auto size = [](const Image& image) {
        return std::to_string(image.width) + " x " + std::to_string(image.height);
    };
    throw Error(ErrorKind::input, "the pictures have different sizes: " + size(a) + " and " + size(b),
                "compare pictures of one size");
}

using Color = std::array<float, 3>;

/// Colour map: black, blue, yellow, white at t = 0, 1/3, 2/3, 1, linear between.
Color heat_color(double t) {
    static constexpr std::array<std::array<double, 3>, 4> stops{
        {{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, 1.0, 0.0}, {1.0, 1.0, 1.0}}};
    const double position = 3 * std::clamp(t, 0.0, 1.0);
    const auto from = static_cast<std::size_t>(std::min(2.0, std::floor(position)));
    const double share = position - static_cast<double>(from);

    Color color;
    for (std::size_t i = 0; i < 3; ++i)
        color[i] = static_cast<float>(stops[from][i] + share * (stops[from + 1][i] - stops[from][i]));
    return color;
}

/// The values of a picture by channel. Alpha is a fourth one, `white` where the picture has none.
struct Channels {
    const Image& image;
    std::span<const float> alpha;
    float white;

    float operator()(int x, int y, int channel) const {
        const float* pixel = image.at(x, y);
        if (channel < 3) return pixel[channel];
        return alpha.empty() ? white : alpha[static_cast<std::size_t>(pixel - image.pixels.data()) / 3];
    }
};

} // namespace

Comparison compare(const Image& a, const Image& b, double tolerance, double peak,
                   std::span<const float> alpha_of_a, std::span<const float> alpha_of_b) {
    require_same_size(a, b);
    const int channels = alpha_of_a.empty() && alpha_of_b.empty() ? 3 : 4;
    const Channels values_of_a{a, alpha_of_a, static_cast<float>(peak)};
    const Channels values_of_b{b, alpha_of_b, static_cast<float>(peak)};

    // Sum by rows: this keeps rounding errors small in a fixed order.
    Comparison result;
    double sum = 0;
    double sum_of_squares = 0;
    double beyond = 0;
    for (int y = 0; y < a.height; ++y) {
        double row_sum = 0;
        double row_squares = 0;
        for (int x = 0; x < a.width; ++x) {
            double worst = 0;
            for (int channel = 0; channel < channels; ++channel) {
                const double d = difference(values_of_a(x, y, channel), values_of_b(x, y, channel));
                row_sum += d;
                row_squares += d * d;
                worst = std::max(worst, d);
            }
            result.max = std::max(result.max, worst);
            if (worst > tolerance) beyond += 1;
        }
        sum += row_sum;
        sum_of_squares += row_squares;
    }

    const double pixels = static_cast<double>(a.width) * static_cast<double>(a.height);
    if (pixels > 0) {
        result.mae = sum / (channels * pixels);
        result.rmse = std::sqrt(sum_of_squares / (channels * pixels));
        result.share = beyond / pixels;
    }
    result.psnr =
        result.rmse > 0 ? 20 * std::log10(peak / result.rmse) : std::numeric_limits<double>::infinity();
    return result;
}

Image difference_heat(const Image& a, const Image& b, double full_scale, std::span<const float> alpha_of_a,
                      std::span<const float> alpha_of_b) {
    require_same_size(a, b);
    const int channels = alpha_of_a.empty() && alpha_of_b.empty() ? 3 : 4;
    const Channels values_of_a{a, alpha_of_a, 1};
    const Channels values_of_b{b, alpha_of_b, 1};
    Image heat(a.width, a.height);
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            double worst = 0;
            for (int channel = 0; channel < channels; ++channel)
                worst = std::max(worst, difference(values_of_a(x, y, channel), values_of_b(x, y, channel)));

            // Compare before dividing: with scale 0 any difference is white.
            const double t = worst == 0 ? 0 : worst >= full_scale ? 1 : worst / full_scale;
            const Color color = heat_color(t);
            std::copy(color.begin(), color.end(), heat.at(x, y));
        }
    return heat;
}

} // namespace glint
