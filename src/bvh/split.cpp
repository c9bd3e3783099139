// Binning, the SAH sweep over bins, and partitioning.

#include "bvh/split.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

namespace glint::bvh {

float area_scale(const SimdBounds& box) {
    float max_coordinate = 0;
    for (int axis = 0; axis < 3; ++axis)
        max_coordinate = std::max({max_coordinate, std::abs(box.lo[axis]), std::abs(box.hi[axis])});
    int exponent = 0;
    std::frexp(max_coordinate, &exponent);
    return std::ldexp(1.0f, std::clamp(-exponent, -120, 120));
}

Binning::Binning(const SimdBounds& centers, int count) : lo(splat(0.0f)), scale(splat(0.0f)), bins(count) {
    // Just below the number of bins, so that the largest center falls into the last bin.
    const float max_position = static_cast<float>(bins) * (1.0f - 0x1p-20f);
    for (int axis = 0; axis < 3; ++axis) {
        const float extent = centers.hi[axis] - centers.lo[axis];
        const float factor = max_position / extent;
        if (!(extent > 0.0f && std::isfinite(factor) && std::isfinite(extent))) continue;
        lo[axis] = centers.lo[axis];
        scale[axis] = factor;
    }
}

void Bins::clear(int bins) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::fill_n(boxes[axis].begin(), bins, SimdBounds{});
        std::fill_n(counts[axis].begin(), bins, 0u);
    }
}

inline void Bins::add(const Binning& binning, const PrimRef& ref) {
    const int4 at = binning(ref.center());
    const auto add = [&](std::size_t axis, std::int32_t bin) {
        boxes[axis][static_cast<std::size_t>(bin)].grow(ref.box());
        ++counts[axis][static_cast<std::size_t>(bin)];
    };
    add(0, at[0]);
    add(1, at[1]);
    add(2, at[2]);
}

void Bins::fill(const Binning& binning, const PrimRef* begin, const PrimRef* end) {
    // Neighbouring references mostly fall into the same bin, and updates of one bin depend on each other:
    // interleaving four runs hides that latency.
    const std::ptrdiff_t part = (end - begin) / 4;
    for (const PrimRef* last = begin + part; begin != last; ++begin) {
        add(binning, begin[0]);
        add(binning, begin[part]);
        add(binning, begin[2 * part]);
        add(binning, begin[3 * part]);
    }
    for (begin += 3 * part; begin != end; ++begin) add(binning, *begin);
}

void Bins::add(const Bins& other, int bins) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t bin = 0; bin < static_cast<std::size_t>(bins); ++bin) {
            boxes[axis][bin].grow(other.boxes[axis][bin]);
            counts[axis][bin] += other.counts[axis][bin];
        }
}

namespace {

/// Sweeps the bins of one axis from both ends and updates `best`.
void sweep(const std::array<SimdBounds, max_bins>& boxes, const std::array<std::uint32_t, max_bins>& counts,
           int bins, float scale, bool pairs, int axis, Cut& best) {
    const std::uint32_t odd = pairs ? 1 : 0;
    std::array<float, max_bins> right_cost;
    SimdBounds box;
    std::uint32_t elements = 0;
    for (auto i = static_cast<std::size_t>(bins - 1); i > 0; --i) {
        box.grow(boxes[i]);
        elements += counts[i];
        right_cost[i] = elements > 0 ? half_area(box, scale) * static_cast<float>(elements + (elements & odd))
                                     : std::numeric_limits<float>::infinity();
    }
    box = {};
    elements = 0;
    for (std::size_t i = 1; i < static_cast<std::size_t>(bins); ++i) {
        box.grow(boxes[i - 1]);
        elements += counts[i - 1];
        if (elements == 0) continue;
        const float cost =
            half_area(box, scale) * static_cast<float>(elements + (elements & odd)) + right_cost[i];
        if (cost < best.cost) best = {axis, static_cast<int>(i), cost};
    }
}

} // namespace

Cut cheapest_cut(const Bins& bins, const Binning& binning, float scale, bool pairs) {
    Cut best;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (binning.scale[axis] > 0.0f)
            sweep(bins.boxes[axis], bins.counts[axis], binning.bins, scale, pairs, static_cast<int>(axis),
                  best);
    return best;
}

std::pair<SimdBounds, SimdBounds> boxes_of(const Bins& bins, const Binning& binning, const Cut& cut) {
    std::pair<SimdBounds, SimdBounds> sides;
    assert(cut.axis >= 0 && cut.bin > 0 && cut.bin < binning.bins);
    const auto& boxes = bins.boxes[static_cast<std::size_t>(cut.axis)];
    for (int i = 0; i < binning.bins; ++i)
        (i < cut.bin ? sides.first : sides.second).grow(boxes[static_cast<std::size_t>(i)]);
    return sides;
}

void share_capacity(PrimRange& left, PrimRange& right, std::size_t limit, PrimRef* refs) {
    assert(left.end == right.begin && right.end <= limit);
    const std::size_t spare = limit - right.end;
    const auto share = static_cast<std::size_t>(
        static_cast<double>(spare) *
        (static_cast<double>(left.size()) / static_cast<double>(left.size() + right.size())));
    left.limit = left.end + share;
    right.limit = limit;
    if (share == 0) return;
    // Order within a range is irrelevant, so only the references in the way move.
    const std::size_t moved = std::min(share, right.size());
    std::copy_n(refs + right.begin, moved, refs + right.end + share - moved);
    right.begin += share;
    right.end += share;
}

namespace {

/// Tells on which side of a cut a center lies, with the arithmetic of Binning: a scaled coordinate is below a
/// bin's number exactly when its bin is.
template <int axis>
struct SideOf {
    float lo;
    float scale;
    float bound;

    SideOf(const Binning& binning, int bin)
        : lo(binning.lo[axis]), scale(binning.scale[axis]), bound(static_cast<float>(bin)) {}
    bool is_left(float4 middle) const { return (middle[axis] - lo) * scale < bound; }
};

/// Ranges of at most this many references are partitioned without branches.
constexpr std::size_t few = 256;

/// Stable, branchless partition(): the side of a reference is unpredictable, so each is written to both
/// outputs and only the matching end advances.
template <int axis>
PrimRef* partition_few(PrimRef* begin, PrimRef* end, SideOf<axis> side, SimdBounds& left, SimdBounds& right) {
    const float4 none = splat(std::numeric_limits<float>::infinity());
    SimdBounds left_centers;
    SimdBounds right_centers;
    std::array<PrimRef, few> rest;
    PrimRef* to_rest = rest.data();
    PrimRef* to = begin;
    for (const PrimRef* from = begin; from != end; ++from) {
        const PrimRef ref = *from;
        const float4 middle = ref.center();
        const bool is_left = side.is_left(middle);
        const std::int32_t bits = is_left ? -1 : 0;
        const int4 mask{bits, bits, bits, bits};
        left_centers.grow({mask ? middle : none, mask ? middle : -none});
        right_centers.grow({mask ? none : middle, mask ? -none : middle});
        *to = ref;
        *to_rest = ref;
        to += is_left ? 1 : 0;
        to_rest += is_left ? 0 : 1;
    }
    std::copy(rest.data(), to_rest, to);
    left = left_centers;
    right = right_centers;
    return to;
}

/// Partitions [begin, end) at a cut, bounds the centers of both sides, and returns where the right one
/// starts.
template <int axis>
PrimRef* partition(PrimRef* begin, PrimRef* end, const Binning& binning, int bin, SimdBounds& left,
                   SimdBounds& right) {
    const SideOf<axis> side(binning, bin);
    if (static_cast<std::size_t>(end - begin) <= few) return partition_few(begin, end, side, left, right);
    SimdBounds left_centers;
    SimdBounds right_centers;
    for (;;) {
        for (; begin < end; ++begin) {
            const float4 middle = begin->center();
            if (!side.is_left(middle)) break;
            left_centers.grow(middle);
        }
        for (; begin < end; --end) {
            const float4 middle = end[-1].center();
            if (side.is_left(middle)) break;
            right_centers.grow(middle);
        }
        if (begin >= end) break;
        std::swap(*begin, end[-1]);
    }
    left = left_centers;
    right = right_centers;
    return begin;
}

} // namespace

std::pair<PrimRange, PrimRange> split_by(const PrimRange& range, const Bins& bins, const Binning& binning,
                                         const Cut& cut, PrimRef* refs) {
    PrimRange left;
    PrimRange right;
    std::tie(left.box, right.box) = boxes_of(bins, binning, cut);
    left.depth = right.depth = range.depth + 1;
    left.failed_searches = right.failed_searches = range.failed_searches;

    const auto sort = cut.axis == 0 ? partition<0> : cut.axis == 1 ? partition<1> : partition<2>;
    const PrimRef* middle =
        sort(refs + range.begin, refs + range.end, binning, cut.bin, left.centers, right.centers);
    left.begin = range.begin;
    left.end = right.begin = static_cast<std::size_t>(middle - refs);
    right.end = range.end;
    assert(left.size() > 0 && right.size() > 0);
    share_capacity(left, right, range.limit, refs);
    return {left, right};
}

std::pair<PrimRange, PrimRange> split_in_half(const PrimRange& range, PrimRef* refs) {
    assert(range.size() >= 2);
    const float4 d = range.centers.hi - range.centers.lo;
    const int axis = d[0] >= d[1] ? (d[0] >= d[2] ? 0 : 2) : (d[1] >= d[2] ? 1 : 2);
    const std::size_t half = range.begin + range.size() / 2;
    if (d[axis] > 0.0f)
        std::nth_element(refs + range.begin, refs + half, refs + range.end,
                         [axis](const PrimRef& a, const PrimRef& b) {
                             const float x = a.lo[axis] * 0.5f + a.hi[axis] * 0.5f;
                             const float y = b.lo[axis] * 0.5f + b.hi[axis] * 0.5f;
                             return x != y ? x < y : a.id() < b.id();
                         });
    PrimRange left;
    PrimRange right;
    left.begin = range.begin;
    left.end = right.begin = half;
    right.end = range.end;
    left.depth = right.depth = range.depth + 1;
    left.failed_searches = right.failed_searches = range.failed_searches;
    for (std::size_t i = left.begin; i < left.end; ++i) left.add(refs[i]);
    for (std::size_t i = right.begin; i < right.end; ++i) right.add(refs[i]);
    share_capacity(left, right, range.limit, refs);
    return {left, right};
}

} // namespace glint::bvh
