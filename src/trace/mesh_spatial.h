#pragma once
// Spatial splits: references cut at a plane, so that a triangle stands on both sides, each time within a
// smaller box (Stich, Friedrich, Dietrich, "Spatial Splits in Bounding Volume Hierarchies", 2009). Private to
// this room.

#include "trace/mesh_split.h"

#include <limits>
#include <utility>

namespace glint {

struct SpatialCut {
    int axis = -1; ///< -1: none
    float plane = 0;
    float cost = std::numeric_limits<float>::infinity(); ///< in the measure of Cut
};

/// The cheapest of some planes through a range that the range has room for.
SpatialCut cheapest_spatial_cut(const MeshBuild& build, const Range& range);

/// Cuts a range at a plane, as far as its room allows; false, with nothing done, if a side would be empty.
bool split_at(const MeshBuild& build, const Range& range, const SpatialCut& cut,
              std::pair<Range, Range>& sides);

/// A box around what a reference's box holds of its triangle, on either side of a plane; a side may be empty.
/// Conservative: rounded outward by more than the clipping errs by.
struct ClippedBoxes {
    QuadBox left, right;
};
ClippedBoxes clip(const MeshBuild& build, const Ref& ref, int axis, float plane);

} // namespace glint
