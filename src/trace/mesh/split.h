#pragma once
// Splitting ranges of triangles, by bins or spatially. Private to this room.

#include "bvh/split.h"
#include "trace/mesh/tree.h"

#include <limits>
#include <span>
#include <utility>

namespace glint::trace {

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

// Spatial splits: references are clipped at a plane, so that a triangle may appear on both sides with a
// smaller box each (Stich, Friedrich, Dietrich, "Spatial Splits in Bounding Volume Hierarchies", 2009).

struct SpatialCut {
    int axis = -1; ///< -1: none
    float plane = 0;
    float cost = std::numeric_limits<float>::infinity(); ///< in the units of Cut
};

/// The cheapest of some planes for which the range has spare capacity.
SpatialCut cheapest_spatial_cut(const MeshBuild& build, const PrimRange& range);

/// Splits a range at a plane as far as its capacity allows; returns false, with no effect, if a side would be
/// empty.
bool split_at(const MeshBuild& build, const PrimRange& range, const SpatialCut& cut,
              std::pair<PrimRange, PrimRange>& sides);

/// Bounds of the parts of a reference's triangle, within the reference's box, on both sides of a plane; a
/// side may be empty. Rounded outward by more than the clipping error.
struct ClippedBoxes {
    SimdBounds left, right;
};
ClippedBoxes clip(const MeshBuild& build, const PrimRef& ref, int axis, float plane);

} // namespace glint::trace
