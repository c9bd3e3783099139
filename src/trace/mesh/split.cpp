// The choice between binned and spatial splits.

#include "trace/mesh/split.h"

namespace glint::trace {

int bins_for(std::size_t size, BuildQuality quality) {
    if (quality == BuildQuality::fast) return size > 1024 ? 16 : 8;
    return size > 256 ? max_bins : size > 16 ? 16 : 8;
}

namespace {

// Parameters of spatial splits. Measured: scans, whose triangles are small relative to their nodes, are
// hardly searched and not changed; on architecture the SAH cost drops by 9 % for 2 % more references.

/// Smaller ranges are not searched.
constexpr std::size_t min_spatial_size = 64;
/// Minimal overlap of the best binned split's sides, relative to the root and to the range.
constexpr float min_overlap_of_root = 1e-3f;
constexpr float min_overlap_of_range = 0.3f;
/// A spatial split must cost less than this times the best binned one.
constexpr float max_cost_ratio = 0.98f;
/// After this many consecutive searches without success, ranges below are not searched.
constexpr int max_failed_searches = 3;

/// Whether a spatial split could pay: the sides of the best binned split overlap much.
bool may_pay(const MeshBuild& build, const PrimRange& range, const Bins& bins, const Binning& binning,
             const Cut& cut) {
    if (build.quality != BuildQuality::high || range.limit == range.end || range.size() < min_spatial_size ||
        range.failed_searches >= max_failed_searches)
        return false;
    if (cut.axis < 0) return true;
    auto [both, other] = boxes_of(bins, binning, cut);
    both.intersect(other);
    for (int axis = 0; axis < 3; ++axis)
        if (both.lo[axis] > both.hi[axis]) return false;
    const float overlap = half_area(both, build.scale);
    return overlap > min_overlap_of_root * build.root_area &&
           overlap > min_overlap_of_range * half_area(range.box, build.scale);
}

} // namespace

std::pair<PrimRange, PrimRange> split(const MeshBuild& build, const PrimRange& whole, const Binning& binning,
                                      Bins& bins, bool filled) {
    PrimRange range = whole;
    if (range.depth >= max_sah_depth) return split_in_half(range, build.refs);
    if (!filled) {
        bins.clear(binning.bins);
        bins.fill(binning, build.refs + range.begin, build.refs + range.end);
    }
    const Cut cut = cheapest_cut(bins, binning, build.scale, build.leaf_memory_cost >= 1.0f);
    std::pair<PrimRange, PrimRange> sides;
    if (may_pay(build, range, bins, binning, cut)) {
        const SpatialCut spatial = cheapest_spatial_cut(build, range);
        if (spatial.cost < max_cost_ratio * cut.cost && split_at(build, range, spatial, sides)) return sides;
        ++range.failed_searches;
    }
    if (cut.axis < 0) return split_in_half(range, build.refs);
    return split_by(range, bins, binning, cut, build.refs);
}

} // namespace glint::trace
