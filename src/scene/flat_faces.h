#pragma once
// Flat parts of surfaces, and where two of them lie in one place.

#include "math/bounds.h"
#include "math/vec.h"

#include <algorithm>
#include <vector>

namespace glint::scene {

/// A flat part of a surface in world space: a convex polygon, or a whole plane if it has no corners.
struct FlatFace {
    dvec3 point{0}; ///< any of its points
    dvec3 normal{0, 0, 1};
    std::vector<dvec3> corners;
    dvec3 reach{0}; ///< the largest |coordinate| of point and corners along each axis
};

FlatFace polygon_face(std::vector<dvec3> corners);

/// A polygon around the circle p(x, y) = center + x · across[0] + y · across[1] with x² + y² = 1.
FlatFace circle_face(const dvec3& center, const dvec3 (&across)[2]);

/// Of a plane everything.
Bounds box_of(const FlatFace& face);

/// A distance from the plane of a face within which a point may be in it but for the rounding of single
/// precision, or so near that a ray may leap the gap; `reach` has the largest |coordinate| along each axis.
double rounding_at(const FlatFace& face, const dvec3& reach);

/// A box in which surfaces coincide, and how far apart they are there at most.
struct CommonPart {
    Bounds box;
    double apart = 0;

    void grow(const CommonPart& other) {
        box.grow(other.box);
        apart = std::max(apart, other.apart);
    }
};

/// The faces' common part if they lie in one plane, within the rounding of single precision, and cover a
/// common area; otherwise empty.
CommonPart common_part(const FlatFace& a, const FlatFace& b);

} // namespace glint::scene
