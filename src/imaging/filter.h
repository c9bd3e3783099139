#pragma once
// Pixel filters by importance: M. Ernst, M. Stamminger, G. Greiner, "Filter Importance Sampling", Interactive
// Ray Tracing 2006. A sample belongs to one pixel alone: its offset is drawn in proportion to |f|, its weight
// is the sign of f. Nothing is splatted to other pixels, so tiles never wait for each other.

#include "glint/filter.h"
#include "imaging/filter.shared.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace glint {

/// Beyond this distance in x or y, in pixels, the filter is 0.
double filter_radius(PixelFilter filter);

/// The filter along one axis at distance x from the centre; its integral is 1 for all but the gaussian.
double filter_value(PixelFilter filter, double x);

/// Where in (or around) a pixel to look, and what the sample counts.
struct FilterSample {
    float dx = 0;     ///< pixels from the pixel's centre, to the right
    float dy = 0;     ///< pixels from the pixel's centre, downward
    float weight = 1; ///< +1, or −1 where the filter is negative
};

/// Draws offsets distributed as |f|, by table: the filter is taken as constant over each of 896 steps on a
/// side.
class PixelFilterSampler {
  public:
    explicit PixelFilterSampler(PixelFilter filter);

    /// Maps u, v in [0, 1) to an offset, monotonically; 1 − u gives exactly the mirrored offset of u.
    FilterSample sample(float u, float v) const;

    /// The table, for those who search it elsewhere: the share of |f| beyond a distance of radius · (1 − i /
    /// n), i = 0 … n; and the number of its outermost steps on which the filter is below 0.
    std::span<const float> tails() const { return tail_; }
    std::size_t negative_steps() const { return negative_steps_; }
    float radius() const { return radius_; }

  private:
    FilterOffset along_axis(float u) const;

    static constexpr std::size_t steps = filter_steps;
    /// A power of two, so that finding the place to begin a search is exact.
    static constexpr std::size_t starts = 1024;

    float radius_;
    std::size_t negative_steps_ = 0;    ///< outermost steps on which the filter is below 0
    std::array<float, steps + 1> tail_; ///< share of |f| beyond a distance of radius · (1 − i / steps)
    std::array<std::uint16_t, starts>
        start_; ///< by tail · starts, rounded down: the step to begin the search at
};

} // namespace glint
