// Trigonometric functions by Taylor series and Newton iteration.

#include "math/trig.h"

#include <cmath>
#include <limits>

namespace glint {
namespace {

constexpr double radians_per_degree = 3.14159265358979323846 / 180;

// Taylor series on [0, 45] degrees: the first omitted term is below 1e-19.
double sin_core(double degrees) {
    const double x = degrees * radians_per_degree;
    const double z = x * x;
    double series = 1;
    for (int k = 17; k >= 3; k -= 2) series = 1 - series * z / (k * (k - 1));
    return x * series;
}

double cos_core(double degrees) {
    const double x = degrees * radians_per_degree;
    const double z = x * x;
    double series = 1;
    for (int k = 18; k >= 2; k -= 2) series = 1 - series * z / (k * (k - 1));
    return series;
}

// sin on [0, 90]; 30 degrees is exact, as it is common in scenes.
double sin_quadrant(double degrees) {
    if (degrees == 30) return 0.5;
    return degrees <= 45 ? sin_core(degrees) : cos_core(90 - degrees);
}

} // namespace

double sin_degrees(double degrees) {
    // fmod is exact, so large angles lose no precision.
    const double turned = std::fmod(degrees, 360.0);
    const double a = std::fabs(turned);
    double value;
    if (a <= 90) {
        value = sin_quadrant(a);
    } else if (a <= 180) {
        value = sin_quadrant(180 - a);
    } else if (a <= 270) {
        value = -sin_quadrant(a - 180);
    } else {
        value = -sin_quadrant(360 - a);
    }
    return turned < 0 ? -value : value;
}

double cos_degrees(double degrees) { return sin_degrees(90 - std::fabs(std::fmod(degrees, 360.0))); }

double asin_degrees(double sine) {
    const double x = std::fabs(sine);
    if (x >= 1) return std::copysign(90, sine);
    // Above 1/2, where asin is steep: asin x = 90° − 2 asin √((1 − x)/2).
    if (x > 0.5) return std::copysign(90 - 2 * asin_degrees(std::sqrt((1 - x) / 2)), sine);
    // Newton iteration doubles the digits; below 30 degrees the initial guess has three.
    double angle = (x + x * x * x / 6) / radians_per_degree;
    for (int i = 0; i < 4; ++i) angle -= (sin_core(angle) - x) / (cos_core(angle) * radians_per_degree);
    return std::copysign(angle, sine);
}

double acos_degrees(double cosine) {
    if (cosine > 0.5) return 2 * asin_degrees(std::sqrt((1 - std::fmin(cosine, 1.0)) / 2));
    return 90 - asin_degrees(cosine);
}

double tan_degrees(double degrees) {
    const double c = cos_degrees(degrees);
    const double s = sin_degrees(degrees);
    if (c == 0) return std::copysign(std::numeric_limits<double>::infinity(), s);
    return s / c;
}

} // namespace glint
