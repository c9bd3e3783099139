#pragma once
// How the triangles of a MeshTree's node are divided among its children. Private to this room.

#include "bvh/split.h"
#include "trace/mesh_tree.h"

#include <limits>
#include <span>
#include <utility>

namespace glint {

inline constexpr float infinite = std::numeric_limits<float>::infinity();

/// What all steps of a build share.
struct MeshBuild {
    std::span<const vec3> positions;
    std::span<const uvec3> triangles;
    BuildQuality quality;
    float scale;     ///< of areas, see half_area()
    float root_area; ///< of everything
    Ref* refs;
    /// The price of each leaf for the memory it takes, in steps into a node of the size of its triangles. 1
    /// and above: leaves shall be pairs of triangles, the most that fit without a shared vertex.
    float thrift = 0;
};

/// How many bins a range of this size is worth.
int bins_for(std::size_t size, BuildQuality quality);

/// Cuts a range of two references or more in two, none of them empty. `bins` hold its references already
/// where they are `filled`, else they are scratch.
std::pair<Range, Range> split(const MeshBuild& build, const Range& range, const Binning& binning, Bins& bins,
                              bool filled);

} // namespace glint
