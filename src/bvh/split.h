#pragma once
// Binned SAH splits of ranges of primitive references (Wald, "On fast Construction of SAH-based Bounding
// Volume Hierarchies", 2007). For builders only.

#include "bvh/float4.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace glint::bvh {

/// A primitive's box with its index in lane 3 of lo. Finite, lo <= hi.
struct PrimRef {
    float4 lo;
    float4 hi;

    static PrimRef of(float4 lo, float4 hi, std::uint32_t id) {
        lo[3] = std::bit_cast<float>(id);
        hi[3] = 0.0f;
        return {lo, hi};
    }
    std::uint32_t id() const { return std::bit_cast<std::uint32_t>(lo[3]); }
    SimdBounds box() const { return {lo, hi}; }
    /// Halves before adding: the sum of two large coordinates could overflow.
    float4 center() const { return without_w(lo) * splat(0.5f) + without_w(hi) * splat(0.5f); }
};

/// A range of references with spare capacity behind it, for references that spatial splits duplicate.
struct PrimRange {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t limit = 0; ///< end of the capacity
    SimdBounds box;        ///< of the references
    SimdBounds centers;    ///< of their centres
    int depth = 0;
    int failed_searches = 0; ///< consecutive searches for a spatial split that found none worth it

    std::size_t size() const { return end - begin; }
    std::size_t capacity() const { return limit - begin; }
    void add(const PrimRef& ref) {
        box.grow(ref.box());
        centers.grow(ref.center());
    }
};

/// Ranges at this depth or below are split at the median, which adds at most 32 levels.
inline constexpr int max_sah_depth = 60;
inline constexpr int max_bins = 32;

/// Maps a center to its bin along each axis.
struct Binning {
    float4 lo;    ///< 0 along an axis whose extent is 0 or not finite
    float4 scale; ///< 0 likewise
    int bins;

    Binning(const SimdBounds& centers, int count);
    int4 operator()(float4 p) const { return __builtin_convertvector((p - lo) * scale, int4); }
};

struct Bins {
    std::array<std::array<SimdBounds, max_bins>, 3> boxes;
    std::array<std::array<std::uint32_t, max_bins>, 3> counts;

    void clear(int bins);
    void fill(const Binning& binning, const PrimRef* begin, const PrimRef* end);
    void add(const Bins& other, int bins);

  private:
    void add(const Binning& binning, const PrimRef& ref);
};

/// A split candidate between two bins. Its cost is the sum over both sides of area × number of references.
struct Cut {
    int axis = -1; ///< -1: all centers coincide
    int bin = 0;   ///< first bin of the right side
    float cost = std::numeric_limits<float>::infinity();
};

/// The cheapest cut between bins; areas are multiplied by scale². With `pairs`, odd numbers of references are
/// rounded up to even.
Cut cheapest_cut(const Bins& bins, const Binning& binning, float scale, bool pairs = false);

/// Boxes of the references on both sides of a cut.
std::pair<SimdBounds, SimdBounds> boxes_of(const Bins& bins, const Binning& binning, const Cut& cut);

/// Partitions a range at a cut. Spare capacity is divided in proportion to the sizes.
std::pair<PrimRange, PrimRange> split_by(const PrimRange& range, const Bins& bins, const Binning& binning,
                                         const Cut& cut, PrimRef* refs);

/// Splits a range at the median along the longest side of its centers' box; equal centers are ordered by
/// index.
std::pair<PrimRange, PrimRange> split_in_half(const PrimRange& range, PrimRef* refs);

/// Divides the capacity up to `limit` between two adjacent ranges in proportion to their sizes, moving the
/// right range backward.
void share_capacity(PrimRange& left, PrimRange& right, std::size_t limit, PrimRef* refs);

} // namespace glint::bvh
