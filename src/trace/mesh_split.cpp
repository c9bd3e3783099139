#include "trace/mesh_split.h"

#include "trace/mesh_spatial.h"

namespace glint {

int bins_for(std::size_t size, BuildQuality quality) {
    if (quality == BuildQuality::fast) return size > 1024 ? 16 : 8;
    return size > 256 ? most_bins : size > 16 ? 16 : 8;
}

namespace {

// When triangles are cut. Measured: scans, whose triangles are small against their nodes, are hardly tried
// and not changed; architecture costs 9 % less by the surface area heuristic for 2 % more references.

/// Ranges of fewer references are not worth the search.
constexpr std::size_t least_cut = 64;
/// The sides of the best cut without cutting triangles overlap by these parts, of everything and of
/// themselves.
constexpr float least_overlap_of_all = 1e-3f;
constexpr float least_overlap_of_range = 0.3f;
/// A cut through triangles must be cheaper by this factor.
constexpr float gain = 0.98f;
/// After as many searches in vain on the way to a range, it is not searched.
constexpr int most_misses = 3;

/// Whether cutting triangles could pay: where the sides of the best cut without overlap much.
bool may_pay(const MeshBuild& build, const Range& range, const Bins& bins, const Binning& binning,
             const Cut& cut) {
    if (build.quality != BuildQuality::high || range.limit == range.end || range.size() < least_cut ||
        range.misses >= most_misses)
        return false;
    if (cut.axis < 0) return true;
    auto [both, other] = boxes_of(bins, binning, cut);
    both.intersect(other);
    for (int axis = 0; axis < 3; ++axis)
        if (both.lo[axis] > both.hi[axis]) return false;
    const float overlap = half_area(both, build.scale);
    return overlap > least_overlap_of_all * build.root_area &&
           overlap > least_overlap_of_range * half_area(range.box, build.scale);
}

} // namespace

std::pair<Range, Range> split(const MeshBuild& build, const Range& whole, const Binning& binning, Bins& bins,
                              bool filled) {
    Range range = whole;
    if (range.depth >= deepest_search) return split_in_half(range, build.refs);
    if (!filled) {
        bins.clear(binning.bins);
        bins.fill(binning, build.refs + range.begin, build.refs + range.end);
    }
    const Cut cut = cheapest_cut(bins, binning, build.scale, build.thrift >= 1.0f);
    std::pair<Range, Range> sides;
    if (may_pay(build, range, bins, binning, cut)) {
        const SpatialCut spatial = cheapest_spatial_cut(build, range);
        if (spatial.cost < gain * cut.cost && split_at(build, range, spatial, sides)) return sides;
        ++range.misses;
    }
    if (cut.axis < 0) return split_in_half(range, build.refs);
    return split_by(range, bins, binning, cut, build.refs);
}

} // namespace glint
