#pragma once
// From a pixel's samples to its value, in an order that depends only on the number of the sample.

#include "math/vec.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace glint::imaging {

/// A sum of up to 2^32 − 1 values by a fixed tree. Values are added in pairs, pairs in pairs, and so on, as
/// carries run through a binary counter: each aligned block of a power of two is a full tree, so blocks may
/// be summed separately. Values that do not fill a tree are added at the end, the latest first. Rounding
/// grows with log n, not n.
template <class T>
class PairwiseSum {
  public:
    void add(const T& value) {
        T carry = value;
        std::size_t level = 0;
        for (; (count_ >> level & 1U) != 0; ++level) carry = trees_[level] + carry;
        trees_[level] = carry;
        ++count_;
    }

    /// The sum; T{} when nothing was added.
    T total() const {
        if (count_ == 0) return T{};
        auto level = static_cast<std::size_t>(std::countr_zero(count_));
        T sum = trees_[level];
        for (++level; (count_ >> level) != 0; ++level)
            if ((count_ >> level & 1U) != 0) sum = trees_[level] + sum;
        return sum;
    }

    std::uint32_t count() const { return count_; }

    /// Begins with `count` values, a power of two, whose sum total() gave before.
    void resume(const T& sum, std::uint32_t count) {
        trees_[static_cast<std::size_t>(std::countr_zero(count))] = sum;
        count_ = count;
    }

  private:
    std::uint32_t count_ = 0;
    std::array<T, 32> trees_{}; ///< tree of 2^level values where bit `level` of the count is set
};

/// From this many samples on, a filter's negative lobes count.
inline constexpr std::uint32_t samples_for_lobes = 16;

/// True if `count` samples, `positives` of them with positive weight, resolve the negative lobes.
inline bool lobes_count(std::uint32_t count, std::uint32_t positives) {
    return count >= samples_for_lobes && 4 * std::int64_t{positives} >= 3 * std::int64_t{count};
}

/// Sums over one pixel's samples of positive and of negative weight.
template <class T>
struct SignedSums {
    T positive{};
    T negative{};
    std::uint32_t count = 0;     ///< of samples
    std::uint32_t positives = 0; ///< of samples of positive weight
};

/// The pixel's value: see PixelSum. T{} where there are no samples.
template <class T>
T pixel_value(const SignedSums<T>& sums) {
    const std::uint32_t negatives = sums.count - sums.positives;
    if (sums.count == 0) return T{};
    if (sums.positives == 0) return sums.negative / static_cast<float>(negatives);

    if (!lobes_count(sums.count, sums.positives)) return sums.positive / static_cast<float>(sums.positives);
    const std::int64_t weights = std::int64_t{sums.positives} - std::int64_t{negatives};
    return (sums.positive - sums.negative) / static_cast<float>(weights);
}

/// Samples that hit something, by the sign of their weight.
struct CoveredCounts {
    std::uint32_t positive = 0;
    std::uint32_t negative = 0;

    void add(bool covered, float weight) {
        if (covered) ++(weight > 0 ? positive : negative);
    }
    friend CoveredCounts operator+(const CoveredCounts& a, const CoveredCounts& b) {
        return {a.positive + b.positive, a.negative + b.negative};
    }
};

/// The coverage of a pixel, filtered as its value is: what is covered alike has one colour up to its edge.
inline float pixel_coverage(const CoveredCounts& covered, std::uint32_t count, std::uint32_t positives) {
    const SignedSums<float> sums{static_cast<float>(covered.positive), static_cast<float>(covered.negative),
                                 count, positives};
    return std::clamp(pixel_value(sums), 0.0f, 1.0f);
}

/// One pixel's samples: Σ w L / Σ w for weights of ±1 (imaging/filter.h). Few samples do not resolve a
/// negative lobe: one bright sample there among four would turn a pixel black. So with fewer than
/// samples_for_lobes, or where the weights nearly cancel (Σ w < n / 2), the pixel is the plain mean of the
/// samples of positive weight, or of all where there is none.
///
/// T is what a sample measures: T{} is 0, and it has + − and / float.
template <class T>
class PixelSum {
  public:
    /// The state of a sum whose number of samples is a power of two; enough to continue it.
    struct Part {
        T positive{};
        T negative{};
        std::uint32_t positives = 0;

        /// Joins the sum of samples [first, first + n) to that of [first + n, first + n + m). The result is
        /// bit for bit the sum of all n + m where both are trees of the whole (n is a power of two, m is n or
        /// what is left of the pixel, and `first` a multiple of the power of two that n + m fit in).
        friend Part operator+(const Part& before, const Part& after) {
            return {before.positive + after.positive, before.negative + after.negative,
                    before.positives + after.positives};
        }
    };

    PixelSum() = default;
    /// Continues after `count` samples: 0 or a power of two.
    PixelSum(const Part& part, std::uint32_t count) : positives_(part.positives) {
        if (count == 0) return;
        positive_.resume(part.positive, count);
        negative_.resume(part.negative, count);
    }
    /// The state from which the sum can be continued, if the number of samples is a power of two.
    Part part() const { return {positive_.total(), negative_.total(), positives_}; }

    void add(const T& radiance, float weight) {
        // Each side counts every sample, so that its tree does not depend on the signs.
        const bool plus = weight > 0;
        positive_.add(plus ? radiance : T{});
        negative_.add(plus ? T{} : radiance);
        if (plus) ++positives_;
    }

    /// T{} when nothing was added.
    T value() const {
        return pixel_value(
            SignedSums<T>{positive_.total(), negative_.total(), positive_.count(), positives_});
    }

    float coverage(const CoveredCounts& covered) const {
        return pixel_coverage(covered, positive_.count(), positives_);
    }

    /// True if samples of this weight count in value().
    bool counts(float weight) const {
        return weight > 0 || positives_ == 0 || lobes_count(positive_.count(), positives_);
    }

  private:
    PairwiseSum<T> positive_;
    PairwiseSum<T> negative_;
    std::uint32_t positives_ = 0;
};

} // namespace glint::imaging
