#include "trace/mesh_split.h"

#include <algorithm>

namespace glint {

int bins_for(std::size_t size, BuildQuality quality) {
    if (quality == BuildQuality::fast) return size > 1024 ? 16 : 8;
    return size > 256 ? most_bins : size > 16 ? 16 : 8;
}

std::pair<Range, Range> split(const MeshBuild& build, const Range& range, const Binning& binning, Bins& bins,
                              bool filled) {
    if (range.depth >= deepest_search) return split_in_half(range, build.refs);
    if (!filled) {
        bins.clear(binning.bins);
        bins.fill(binning, build.refs + range.begin, build.refs + range.end);
    }
    const Cut cut = cheapest_cut(bins, binning, build.scale);
    if (cut.axis < 0) return split_in_half(range, build.refs);
    return split_by(range, bins, binning, cut, build.refs);
}

} // namespace glint
