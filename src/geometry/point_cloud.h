#pragma once
// Point clouds: their outliers, and the radius of the spheres that show their points.

#include "math/bounds.h"
#include "math/vec.h"

#include <span>

namespace glint::geometry {

/// A closed box that contains the points of a cloud except for outliers: the box from the 2 % to the 98 %
/// quantile of each coordinate, grown on all sides by the length of its largest side. The quantiles are those
/// of up to 4096 points, at even distances in the list. Infinite for fewer than 32 points, and if nearly all
/// lie in one place. Points that are not finite do not count.
Bounds cloud_without_outliers(std::span<const vec3> points);

/// Half the distance of neighbouring points if those without outliers were evenly distributed on the sides of
/// their box; 1 for a single point.
double default_point_radius(std::span<const vec3> points);

} // namespace glint::geometry
