#pragma once
// Spatial splits: references are clipped at a plane, so that a triangle may appear on both sides with a
// smaller box each (Stich, Friedrich, Dietrich, "Spatial Splits in Bounding Volume Hierarchies", 2009).
// Private to this room.

#include "trace/mesh/split.h"

#include <limits>
#include <utility>

namespace glint::trace {

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
