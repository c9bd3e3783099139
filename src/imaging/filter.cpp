// Pixel filters and their sampling tables.

#include "imaging/filter.h"

#include <cmath>

namespace glint::imaging {

namespace {

/// e^−x for x ≥ 0 as the reciprocal of a series of positive terms: only + * /, so the same bits on every
/// machine.
double exp_minus(double x) {
    double sum = 1;
    double term = 1;
    for (int k = 1; k <= 60; ++k) {
        term = term * x / k;
        sum += term;
    }
    return 1 / sum;
}

double gaussian(double x) {
    constexpr double alpha = 2;
    constexpr double radius = 1.5;
    return exp_minus(alpha * x * x) - exp_minus(alpha * radius * radius);
}

/// Mitchell and Netravali, "Reconstruction Filters in Computer Graphics", 1988, equation 8 with B = C = 1/3.
double mitchell(double x) {
    if (x < 1) return (21 * x * x * x - 36 * x * x + 16) / 18;
    return (7.0 / 18) * (2 - x) * (2 - x) * (8.0 / 7 - x);
}

} // namespace

double filter_radius(PixelFilter filter) {
    constexpr std::array radii{0.5, 1.0, 1.5, 2.0};
    return radii[static_cast<std::size_t>(filter)];
}

double filter_value(PixelFilter filter, double x) {
    x = std::abs(x);
    if (x > filter_radius(filter)) return 0;
    switch (filter) {
    case PixelFilter::box:
        return 1;
    case PixelFilter::tent:
        return 1 - x;
    case PixelFilter::gaussian:
        return gaussian(x);
    case PixelFilter::mitchell:
        break;
    }
    return mitchell(x);
}

PixelFilterSampler::PixelFilterSampler(PixelFilter filter)
    : PixelFilterSampler(filter_radius(filter), [&](double x) { return filter_value(filter, x); }) {}

PixelFilterSampler::PixelFilterSampler(double radius, const std::function<double(double)>& f)
    : radius_(static_cast<float>(radius)) {
    // Integrate |f| from the edge inward, so that sums start small and the edge keeps its precision.
    // Simpson's rule is exact for the polynomial filters; no step contains a sign change.
    const auto distance = [&](double step) { return radius * (1 - step / static_cast<double>(steps)); };
    std::array<double, steps + 1> tail{};
    for (std::size_t i = 0; i < steps; ++i) {
        const auto step = static_cast<double>(i);
        const double middle = f(distance(step + 0.5));
        const double mass = f(distance(step)) + 4 * middle + f(distance(step + 1));
        tail[i + 1] = tail[i] + std::abs(mass);
        if (middle < 0) negative_steps_ = i + 1;
    }
    for (std::size_t i = 0; i <= steps; ++i) tail_[i] = static_cast<float>(tail[i] / tail[steps]);

    std::size_t step = 0;
    for (std::size_t i = 0; i < starts; ++i) {
        while (tail_[step + 1] <= static_cast<float>(i) / static_cast<float>(starts)) ++step;
        start_[i] = static_cast<std::uint16_t>(step);
    }
}

FilterOffset PixelFilterSampler::along_axis(float u) const {
    // Only at u = 1/2, the centre, is all of |f| beyond.
    const float tail = filter_tail(u);
    std::size_t step = steps - 1;
    if (tail < 1) {
        step = start_[static_cast<std::size_t>(tail * static_cast<float>(starts))];
        while (tail_[step + 1] <= tail) ++step;
    }
    return filter_offset(u, radius_, static_cast<int>(step), static_cast<int>(negative_steps_), tail_[step],
                         tail_[step + 1]);
}

FilterSample PixelFilterSampler::sample(float u, float v) const {
    const FilterOffset x = along_axis(u);
    const FilterOffset y = along_axis(v);
    return {x.distance_to, y.distance_to, x.weight * y.weight};
}

} // namespace glint::imaging
