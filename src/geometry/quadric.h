#pragma once
// Quadrics and planes in double precision; geometry/quadric.shared.h has the equations.

#include "geometry/quadric.shared.h"
#include "math/vec.h"

#include <array>
#include <cmath>
#include <vector>

namespace glint::geometry {

/// By kind, in the plural.
inline constexpr std::array<const char*, quadric_kinds> quadric_names{"spheres", "cylinders", "disks",
                                                                      "cones"};
static_assert(quadric_names.back() != nullptr, "a kind of quadric has no name");

inline QuadricShape make_sphere(const dvec3& center, double radius) {
    return {quadric_sphere, center, dvec3(0, 0, 1), 0, radius};
}
/// `axis` is of unit length and points from the base to the top.
inline QuadricShape make_cylinder(const dvec3& base, const dvec3& axis, double height, double radius) {
    return {quadric_cylinder, base, axis, height, radius};
}
/// `normal` is of unit length.
inline QuadricShape make_disk(const dvec3& center, const dvec3& normal, double radius) {
    return {quadric_disk, center, normal, 0, radius};
}
/// A solid cone with its cap; `axis` is of unit length and points from the middle of the base to the apex.
inline QuadricShape make_cone(const dvec3& base, const dvec3& axis, double height, double radius) {
    return {quadric_cone, base, axis, height, radius};
}

/// The image under p ↦ m p, which must scale all lengths by `scale`.
inline QuadricShape transformed(const QuadricShape& shape, const dmat4& m, double scale) {
    return {shape.kind, dvec3(m * dvec4(shape.base, 1.0)), glm::normalize(dmat3(m) * shape.axis),
            shape.height * scale, shape.radius * scale};
}

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

/// A point of a surface with the unit normal there, both in double.
struct ExactPoint {
    dvec3 p;
    dvec3 n;
};

struct Interval {
    double low;
    double high;
};

/// False if the line misses; a tangent hits.
inline bool intersect(const Line& line, const QuadricShape& shape, SolidSpan& span) {
    return line_in_quadric(shape, line.origin, line.direction, span);
}
/// False if the line is parallel to the plane.
inline bool intersect(const Line& line, const Plane& plane, double& t) {
    return line_meets_plane(line.origin, line.direction, plane.normal, plane.offset, t);
}

/// The point of one part of the surface (SolidSpan::enter_part) nearest to p, at least `margin` from the
/// part's rim; outward normal.
inline ExactPoint surface(const QuadricShape& shape, int part, const dvec3& p, double margin = 0) {
    ExactPoint point;
    point_of_quadric(shape, part, p, margin, point.p, point.n);
    return point;
}

/// Range of g · p over the quadric.
inline Interval extent(const QuadricShape& shape, const dvec3& g) {
    Interval values;
    extent_of_quadric(shape, g, values.low, values.high);
    return values;
}

/// Where flat parts of the surface are: circles of the shape's radius at these heights along its axis.
inline std::vector<double> flat_heights(const QuadricShape& shape) {
    if (shape.kind == quadric_sphere) return {};
    if (shape.kind == quadric_cylinder) return {0, shape.height};
    return {0};
}

inline bool has_round_side(const QuadricShape& shape) { return shape.kind != quadric_disk; }

/// Do the round sides of two quadrics coincide if they are long enough, to within `error` in length?
inline bool same_side(const QuadricShape& a, const QuadricShape& b, double error) {
    const auto none = [&](const dvec3& difference) { return glm::length(difference) <= error; };
    if (a.kind != b.kind || !has_round_side(a)) return false;
    if (a.kind == quadric_cone)
        return none(a.base + a.axis * a.height - (b.base + b.axis * b.height)) &&
               none(a.radius * (a.axis - b.axis)) &&
               std::abs(a.radius - a.height * (b.radius / b.height)) <= error;
    if (std::abs(a.radius - b.radius) > error) return false;
    if (a.kind == quadric_sphere) return none(a.base - b.base);
    return none(a.radius * glm::cross(a.axis, b.axis)) && none(perpendicular_to(a.axis, b.base - a.base));
}

} // namespace glint::geometry
