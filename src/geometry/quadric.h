#pragma once
// Sphere, cylinder and plane against lines, in double. Roots by Haines et al., "Precision Improvements for
// Ray/Sphere Intersection", Ray Tracing Gems (2019), chapter 7. Every sum is written so that mirrored scenes,
// scenes with x and y exchanged and scenes scaled by 2^k give the same bits.

#include "geometry/quadric.shared.h"
#include "math/vec.h"

namespace glint {

struct Sphere {
    dvec3 center{0};
    double radius = 1;
};

/// A solid cylinder with both caps; `axis` is of unit length and points from the base to the top.
struct Cylinder {
    dvec3 base{0};
    dvec3 axis{0, 0, 1};
    double height = 1;
    double radius = 1;
};

/// All p with normal · p = offset.
struct Plane {
    dvec3 normal{0, 0, 1};
    double offset = 0;
};

/// A line o + t d; d is not zero.
struct Line {
    dvec3 origin{0};
    dvec3 direction{0, 0, 1};
};

enum class CylinderPart { side, base_cap, top_cap };

/// The part of a line inside a convex solid: enter <= t <= leave. A tangent has enter == leave.
struct Interval {
    double enter;
    double leave;
};

/// The same, with the parts of the surface where the line passes.
struct CylinderInterval {
    Interval t;
    CylinderPart enter_part;
    CylinderPart leave_part;
};

/// A point of a surface with the unit normal there, both in double.
struct ExactPoint {
    dvec3 p;
    dvec3 n;
};

/// False if the line misses; a tangent hits.
bool intersect(const Line& line, const Sphere& sphere, Interval& t);
bool intersect(const Line& line, const Cylinder& cylinder, CylinderInterval& t);
/// False if the line is parallel to the plane.
inline bool intersect(const Line& line, const Plane& plane, double& t) {
    return line_meets_plane(line.origin, line.direction, plane.normal, plane.offset, t);
}

/// The point of the surface nearest to p, outward normal.
ExactPoint surface(const Sphere& sphere, const dvec3& p);
/// The same for one part of the surface.
ExactPoint surface(const Cylinder& cylinder, CylinderPart part, const dvec3& p);
ExactPoint surface(const Plane& plane, const dvec3& p);

/// Least and greatest g · p over the solid.
Interval extent(const Sphere& sphere, const dvec3& g);
Interval extent(const Cylinder& cylinder, const dvec3& g);

} // namespace glint
