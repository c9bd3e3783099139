// glint-bench-filters: what pixel filters make of straight edges, as a table in Markdown. Each filter is
// compared with its own exact picture of the edge:
//
//   drawn      as glint does: each sample belongs to one pixel, at an offset drawn by the filter
//   gathered   samples spread evenly over their pixels, each weighted in all pixels that the filter reaches
//   from it
//
// RMSE is over all pixels within four pixels of the edge, noise over those whose exact value is from 0.02 to
// 0.98.

#include "imaging/filter.h"
#include "imaging/pixel_sum.h"
#include "math/random.shared.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace glint;
using namespace glint::imaging;

struct Filter {
    const char* name;
    double radius;
    std::function<double(double)> value; ///< along one axis, for x ≥ 0
};

Filter of_glint(const char* name, PixelFilter filter) {
    return {name, filter_radius(filter), [filter](double x) { return filter_value(filter, x); }};
}

/// Four terms, F. J. Harris, "On the Use of Windows for Harmonic Analysis", 1978.
double blackman_harris(double x, double radius) {
    const double turn = std::numbers::pi * (x / radius + 1);
    return 0.35875 - 0.48829 * std::cos(turn) + 0.14128 * std::cos(2 * turn) - 0.01168 * std::cos(3 * turn);
}

std::vector<Filter> filters() {
    return {of_glint("box", PixelFilter::box),
            of_glint("tent", PixelFilter::tent),
            of_glint("gaussian", PixelFilter::gaussian),
            {"Blackman-Harris", 1.5, [](double x) { return x > 1.5 ? 0 : blackman_harris(x, 1.5); }},
            of_glint("mitchell", PixelFilter::mitchell)};
}

/// Light of 1 where a x + b y < c, in pixels.
struct Edge {
    double a, b, c;
    bool lit(double x, double y) const { return a * x + b * y < c; }
};

/// The filter along one axis from its lower end to x, as a share of the whole.
class Integral {
  public:
    explicit Integral(const Filter& filter) : radius_(filter.radius) {
        for (std::size_t i = 0; i < steps; ++i)
            sums_[i + 1] = sums_[i] + filter.value(std::abs(position(static_cast<double>(i) + 0.5)));
        for (double& sum : sums_) sum /= sums_[steps];
    }
    double operator()(double x) const {
        const double at = std::clamp((x / radius_ + 1) / 2, 0.0, 1.0) * steps;
        const std::size_t i = std::min(static_cast<std::size_t>(at), steps - 1);
        return sums_[i] + (at - static_cast<double>(i)) * (sums_[i + 1] - sums_[i]);
    }
    /// The light of a pixel: the mean of (*this)(the edge's x at y), by the filter along y. |a| ≥ |b|.
    double light(const Edge& edge, int x, int y) const {
        double sum = 0;
        constexpr int rows = 400;
        double before = 0;
        for (int i = 0; i < rows; ++i) {
            const double until = (*this)(radius_ * (2 * (i + 1.0) / rows - 1));
            const double dy = radius_ * (2 * (i + 0.5) / rows - 1);
            sum += (until - before) * (*this)((edge.c - edge.b * (y + dy)) / edge.a - x);
            before = until;
        }
        return sum;
    }

  private:
    static constexpr std::size_t steps = 1 << 14;
    double position(double step) const { return radius_ * (2 * step / steps - 1); }

    double radius_;
    std::array<double, steps + 1> sums_{};
};

vec2 numbers_of(int x, int y, int sample) {
    return sample_pair(pixel_key(7, 0, static_cast<uint>(x + 1000), static_cast<uint>(y + 1000)),
                       static_cast<uint>(sample), 0);
}

double drawn(const PixelFilterSampler& sampler, const Edge& edge, int x, int y, int samples) {
    PixelSum<float> sum;
    for (int i = 0; i < samples; ++i) {
        const vec2 u = numbers_of(x, y, i);
        const FilterSample at = sampler.sample(u.x, u.y);
        sum.add(edge.lit(x + double{at.dx}, y + double{at.dy}) ? 1.0f : 0.0f, at.weight);
    }
    return double{sum.value()};
}

double gathered(const Filter& filter, const Edge& edge, int x, int y, int samples) {
    const int reach = static_cast<int>(std::ceil(filter.radius - 0.5));
    double light = 0;
    double weights = 0;
    for (int py = y - reach; py <= y + reach; ++py)
        for (int px = x - reach; px <= x + reach; ++px)
            for (int i = 0; i < samples; ++i) {
                const vec2 u = numbers_of(px, py, i);
                const double sx = px + double{u.x} - 0.5, sy = py + double{u.y} - 0.5;
                const double weight = filter.value(std::abs(sx - x)) * filter.value(std::abs(sy - y));
                weights += weight;
                light += edge.lit(sx, sy) ? weight : 0;
            }
    return light / weights;
}

struct Errors {
    double squares = 0, squares_of_edge = 0, largest = 0;
    int pixels = 0, pixels_of_edge = 0;

    void add(double value, double exact) {
        const double error = value - exact;
        squares += error * error;
        ++pixels;
        largest = std::max(largest, std::abs(error));
        if (exact < 0.02 || exact > 0.98) return;
        squares_of_edge += error * error;
        ++pixels_of_edge;
    }
    double rmse() const { return std::sqrt(squares / pixels); }
    double noise() const { return std::sqrt(squares_of_edge / pixels_of_edge); }
};

/// Edges of 12 slopes from upright to diagonal, along 40 rows each.
Errors measure(const Filter& filter, bool gathers, int samples) {
    const PixelFilterSampler sampler(filter.radius, filter.value);
    const Integral integral(filter);
    Errors errors;
    for (int k = 0; k < 12; ++k) {
        const double angle = (k + 0.37) / 12 * std::numbers::pi / 4;
        const Edge edge{std::cos(angle), std::sin(angle), 0.29 + 0.61 * k};
        for (int y = 0; y < 40; ++y) {
            const int middle = static_cast<int>(std::floor((edge.c - edge.b * y) / edge.a));
            for (int x = middle - 4; x <= middle + 5; ++x) {
                const double value =
                    gathers ? gathered(filter, edge, x, y, samples) : drawn(sampler, edge, x, y, samples);
                errors.add(value, integral.light(edge, x, y));
            }
        }
    }
    return errors;
}

} // namespace

int main() {
    constexpr std::array counts{1, 4, 16, 64};
    std::printf("| filter | | RMSE at 1 | 4 | 16 | 64 | noise at 1 | 4 | 16 | 64 | largest at 16 |\n"
                "|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const Filter& filter : filters())
        for (const bool gathers : {false, true}) {
            std::array<Errors, counts.size()> errors;
            for (std::size_t i = 0; i < counts.size(); ++i) errors[i] = measure(filter, gathers, counts[i]);
            std::printf("| %s | %s", filter.name, gathers ? "gathered" : "drawn");
            for (const Errors& e : errors) std::printf(" | %.4f", e.rmse());
            for (const Errors& e : errors) std::printf(" | %.4f", e.noise());
            std::printf(" | %.3f |\n", errors[2].largest);
        }
}
