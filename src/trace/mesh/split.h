#pragma once
// Splitting ranges of triangles, by bins or spatially. Private to this room.

#include "bvh/split.h"
#include "trace/mesh/tree.h"

#include <limits>
#include <span>
#include <utility>

namespace glint::trace {

using bvh::Binning;
using bvh::Bins;
using bvh::Cut;
using bvh::float4;
using bvh::half_area;
using bvh::PrimRange;
using bvh::PrimRef;
using bvh::SimdBounds;
using bvh::splat;
using bvh::to_float4;
using bvh::without_w;

inline constexpr float infinite = std::numeric_limits<float>::infinity();

/// Parameters shared by all steps of a build.
struct MeshBuild {
    std::span<const vec3> positions;
    std::span<const uvec3> triangles;
    BuildQuality quality;
    float scale;     ///< scale of areas, see half_area()
    float root_area; ///< half area of the root
    PrimRef* refs;
    /// Cost of each leaf for the memory it takes, relative to visiting a node of the triangles' size. From 1
    /// on, leaves should be pairs of triangles, the most that fit without shared vertices.
    float leaf_memory_cost = 0;
};

/// Number of bins for a range of this size.
int bins_for(std::size_t size, BuildQuality quality);

/// Splits a range of at least two references into two non-empty ones. `bins` contain its references if
/// `filled`, otherwise they are scratch memory.
std::pair<PrimRange, PrimRange> split(const MeshBuild& build, const PrimRange& range, const Binning& binning,
                                      Bins& bins, bool filled);

} // namespace glint::trace
