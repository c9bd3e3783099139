#include "geometry/quadric.h"

#include <cmath>
#include <utility>

namespace glint {

namespace {

constexpr CylinderPart parts[] = {CylinderPart::side, CylinderPart::base_cap, CylinderPart::top_cap};

} // namespace

bool intersect(const Line& line, const Sphere& sphere, Interval& t) {
    return line_in_ball(line.origin - sphere.center, line.direction, sphere.radius, t.enter, t.leave);
}

bool intersect(const Line& line, const Cylinder& cylinder, CylinderInterval& t) {
    SolidSpan span;
    if (!line_in_cylinder(line.origin - cylinder.base, line.direction, cylinder.axis, cylinder.height,
                          cylinder.radius, span))
        return false;
    t = {{span.enter, span.leave}, parts[span.enter_part], parts[span.leave_part]};
    return true;
}

ExactPoint surface(const Sphere& sphere, const dvec3& p) {
    ExactPoint point;
    point_of_sphere(sphere.center, sphere.radius, p, point.p, point.n);
    return point;
}

ExactPoint surface(const Cylinder& cylinder, CylinderPart part, const dvec3& p) {
    ExactPoint point;
    point_of_cylinder(cylinder.base, cylinder.axis, cylinder.height, cylinder.radius, static_cast<int>(part),
                      p, point.p, point.n);
    return point;
}

ExactPoint surface(const Plane& plane, const dvec3& p) {
    ExactPoint point;
    point_of_plane(plane.normal, plane.offset, p, point.p, point.n);
    return point;
}

Interval extent(const Sphere& sphere, const dvec3& g) {
    const double middle = dot(g, sphere.center);
    const double half = sphere.radius * std::sqrt(dot(g, g));
    return {middle - half, middle + half};
}

Interval extent(const Cylinder& cylinder, const dvec3& g) {
    const dvec3 slant = square_to(cylinder.axis, g);
    const double half = cylinder.radius * std::sqrt(dot(slant, slant));
    double low = dot(g, cylinder.base);
    double high = dot(g, cylinder.base + cylinder.axis * cylinder.height);
    if (low > high) std::swap(low, high);
    return {low - half, high + half};
}

} // namespace glint
