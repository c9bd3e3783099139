#include "geometry/quadric.h"

#include <cmath>
#include <limits>
#include <utility>

namespace glint {

namespace {

using glm::dot;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The part of the line f + t d with |f + t d| <= r.
bool line_in_ball(const dvec3& f, const dvec3& d, double r, Interval& t) {
    const double a = dot(d, d);
    if (a == 0.0) {
        t = {-infinity, infinity};
        return dot(f, f) <= r * r;
    }
    // The discriminant from the line's nearest point: no difference of large squares where f is long.
    const double b = -dot(f, d);
    const dvec3 nearest = f + d * (b / a);
    const double delta = r * r - dot(nearest, nearest);
    if (!(delta >= 0.0)) return false;

    // Both roots without a difference of nearly equal numbers.
    const double root = std::sqrt(a * delta);
    const double q = b >= 0.0 ? b + root : b - root;
    const double one = q / a;
    const double other = q == 0.0 ? 0.0 : (dot(f, f) - r * r) / q;
    t = one < other ? Interval{one, other} : Interval{other, one};
    return true;
}

dvec3 across(const dvec3& axis, const dvec3& v) { return v - axis * dot(axis, v); }

/// The part of the line between the planes of the two caps; `reversed` if it comes in through the top.
bool line_between_caps(const Line& line, const Cylinder& cylinder, Interval& t, bool& reversed) {
    const double h = dot(cylinder.axis, line.origin - cylinder.base);
    const double rise = dot(cylinder.axis, line.direction);
    reversed = rise < 0.0;
    if (rise == 0.0) {
        t = {-infinity, infinity};
        return h >= 0.0 && h <= cylinder.height;
    }
    const double at_base = -h / rise;
    const double at_top = (cylinder.height - h) / rise;
    t = reversed ? Interval{at_top, at_base} : Interval{at_base, at_top};
    return true;
}

} // namespace

bool intersect(const Line& line, const Sphere& sphere, Interval& t) {
    return line_in_ball(line.origin - sphere.center, line.direction, sphere.radius, t);
}

bool intersect(const Line& line, const Cylinder& cylinder, CylinderInterval& t) {
    Interval side;
    const dvec3 f = across(cylinder.axis, line.origin - cylinder.base);
    if (!line_in_ball(f, across(cylinder.axis, line.direction), cylinder.radius, side)) return false;
    Interval caps;
    bool reversed;
    if (!line_between_caps(line, cylinder, caps, reversed)) return false;

    // The solid is convex: one way in, one way out, at the rim too.
    const bool enter_side = side.enter > caps.enter;
    const bool leave_side = side.leave < caps.leave;
    t.t = {enter_side ? side.enter : caps.enter, leave_side ? side.leave : caps.leave};
    if (!(t.t.enter <= t.t.leave)) return false;
    const CylinderPart first = reversed ? CylinderPart::top_cap : CylinderPart::base_cap;
    const CylinderPart last = reversed ? CylinderPart::base_cap : CylinderPart::top_cap;
    t.enter_part = enter_side ? CylinderPart::side : first;
    t.leave_part = leave_side ? CylinderPart::side : last;
    return true;
}

ExactPoint surface(const Sphere& sphere, const dvec3& p) {
    const dvec3 v = p - sphere.center;
    const dvec3 n = v / std::sqrt(dot(v, v));
    return {sphere.center + n * sphere.radius, n};
}

ExactPoint surface(const Cylinder& cylinder, CylinderPart part, const dvec3& p) {
    const dvec3 v = p - cylinder.base;
    const dvec3 radial = across(cylinder.axis, v);
    if (part == CylinderPart::base_cap) return {cylinder.base + radial, -cylinder.axis};
    if (part == CylinderPart::top_cap)
        return {cylinder.base + cylinder.axis * cylinder.height + radial, cylinder.axis};
    const dvec3 n = radial / std::sqrt(dot(radial, radial));
    return {cylinder.base + cylinder.axis * dot(cylinder.axis, v) + n * cylinder.radius, n};
}

ExactPoint surface(const Plane& plane, const dvec3& p) {
    const double squared = dot(plane.normal, plane.normal);
    const dvec3 on_plane = p + plane.normal * ((plane.offset - dot(plane.normal, p)) / squared);
    return {on_plane, plane.normal / std::sqrt(squared)};
}

Interval extent(const Sphere& sphere, const dvec3& g) {
    const double middle = dot(g, sphere.center);
    const double half = sphere.radius * std::sqrt(dot(g, g));
    return {middle - half, middle + half};
}

Interval extent(const Cylinder& cylinder, const dvec3& g) {
    const dvec3 slant = across(cylinder.axis, g);
    const double half = cylinder.radius * std::sqrt(dot(slant, slant));
    double low = dot(g, cylinder.base);
    double high = dot(g, cylinder.base + cylinder.axis * cylinder.height);
    if (low > high) std::swap(low, high);
    return {low - half, high + half};
}

} // namespace glint
