#pragma once
// Pixel filters by importance sampling: M. Ernst, M. Stamminger, G. Greiner, "Filter Importance Sampling",
// Interactive Ray Tracing 2006. A sample contributes to one pixel only: its offset is drawn with density
// proportional to |f|, and its weight is the sign of f. No splatting to other pixels, so tiles are
// independent.

#include "glint/filter.h"
#include "imaging/filter.shared.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace glint::imaging {

/// Radius in pixels along x and y; the filter is 0 beyond.
double filter_radius(PixelFilter filter);

/// The filter along one axis at distance x from the centre. Its integral is 1 except for the gaussian.
double filter_value(PixelFilter filter, double x);

/// The offset of a sample from its pixel, and its weight.
struct FilterSample {
    float dx = 0;     ///< pixels to the right of the pixel's centre
    float dy = 0;     ///< pixels below the pixel's centre
    float weight = 1; ///< +1, or −1 where the filter is negative
};

/// Samples offsets with density |f| from a table: the filter is piecewise constant on 896 steps on each side.
class PixelFilterSampler {
  public:
    explicit PixelFilterSampler(PixelFilter filter);
    /// Of a filter that is 0 beyond a radius in pixels: f(x) along one axis for 0 ≤ x ≤ radius, negative on a
    /// rim at most.
    PixelFilterSampler(double radius, const std::function<double(double)>& f);

    /// Maps u, v in [0, 1) to an offset, monotonically; 1 − u gives exactly the mirrored offset.
    FilterSample sample(float u, float v) const;

    /// The table, for use on a GPU: the fraction of |f| beyond a distance of radius · (1 − i / n), i = 0 … n,
    /// and the number of outermost steps where the filter is negative.
    std::span<const float> tails() const { return tail_; }
    std::size_t negative_steps() const { return negative_steps_; }
    float radius() const { return radius_; }

  private:
    FilterOffset along_axis(float u) const;

    static constexpr std::size_t steps = filter_steps;
    /// A power of two, so that computing the start of a search is exact.
    static constexpr std::size_t starts = 1024;

    float radius_;
    std::size_t negative_steps_ = 0;    ///< outermost steps where the filter is negative
    std::array<float, steps + 1> tail_; ///< fraction of |f| beyond a distance of radius · (1 − i / steps)
    std::array<std::uint16_t, starts> start_; ///< search start by floor(tail · starts)
};

} // namespace glint::imaging
