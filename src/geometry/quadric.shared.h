#ifndef GLINT_GEOMETRY_QUADRIC_SHARED_H
#define GLINT_GEOMETRY_QUADRIC_SHARED_H
#include "math/shared.h"

// The equations of geometry/quadric.h, in double.

GLINT_SHARED_BEGIN

/// The part of a line inside a solid, and what it goes through: 0 the side, 1 the base cap, 2 the top cap.
struct SolidSpan {
    double enter;
    double leave;
    int enter_part;
    int leave_part;
};

/// The part of v square to a unit axis.
GLINT_FN dvec3 square_to(dvec3 axis, dvec3 v) { return v - axis * dot(axis, v); }

/// The part of the line f + t d with |f + t d| <= r.
GLINT_FN bool line_in_ball(dvec3 f, dvec3 d, double r, GLINT_OUT(double) enter, GLINT_OUT(double) leave) {
    enter = -infinite_double();
    leave = infinite_double();
    double a = dot(d, d);
    if (a == 0.0) return dot(f, f) <= r * r;

    // The discriminant from the line's nearest point: no difference of large squares where f is long.
    double b = -dot(f, d);
    dvec3 nearest = f + d * (b / a);
    double delta = r * r - dot(nearest, nearest);
    if (!(delta >= 0.0)) return false;

    // Both roots without a difference of nearly equal numbers.
    double root = sqrt(a * delta);
    double q = b >= 0.0 ? b + root : b - root;
    double one = q / a;
    double other = q == 0.0 ? 0.0 : (dot(f, f) - r * r) / q;
    enter = one < other ? one : other;
    leave = one < other ? other : one;
    return true;
}

/// The same for a solid cylinder of unit axis; o is the line's origin seen from the middle of the base.
GLINT_FN bool line_in_cylinder(dvec3 o, dvec3 d, dvec3 axis, double height, double radius,
                               GLINT_OUT(SolidSpan) span) {
    double side_enter;
    double side_leave;
    if (!line_in_ball(square_to(axis, o), square_to(axis, d), radius, side_enter, side_leave)) return false;

    // Between the planes of the two caps; reversed if it comes in through the top.
    double h = dot(axis, o);
    double rise = dot(axis, d);
    double cap_enter = -infinite_double();
    double cap_leave = infinite_double();
    bool reversed = rise < 0.0;
    if (rise == 0.0) {
        if (!(h >= 0.0 && h <= height)) return false;
    } else {
        double at_base = -h / rise;
        double at_top = (height - h) / rise;
        cap_enter = reversed ? at_top : at_base;
        cap_leave = reversed ? at_base : at_top;
    }

    // The solid is convex: one way in, one way out, at the rim too.
    bool enter_side = side_enter > cap_enter;
    bool leave_side = side_leave < cap_leave;
    span.enter = enter_side ? side_enter : cap_enter;
    span.leave = leave_side ? side_leave : cap_leave;
    span.enter_part = enter_side ? 0 : (reversed ? 2 : 1);
    span.leave_part = leave_side ? 0 : (reversed ? 1 : 2);
    return span.enter <= span.leave;
}

/// The point of a sphere nearest to p, and the outward normal there.
GLINT_FN void point_of_sphere(dvec3 center, double radius, dvec3 p, GLINT_OUT(dvec3) on, GLINT_OUT(dvec3) n) {
    dvec3 v = p - center;
    n = v / sqrt(dot(v, v));
    on = center + n * radius;
}

/// The same for one part of a cylinder's surface.
GLINT_FN void point_of_cylinder(dvec3 base, dvec3 axis, double height, double radius, int part, dvec3 p,
                                GLINT_OUT(dvec3) on, GLINT_OUT(dvec3) n) {
    dvec3 v = p - base;
    dvec3 radial = square_to(axis, v);
    if (part == 1) {
        n = -axis;
        on = base + radial;
    } else if (part == 2) {
        n = axis;
        on = base + axis * height + radial;
    } else {
        n = radial / sqrt(dot(radial, radial));
        on = base + axis * dot(axis, v) + n * radius;
    }
}

/// Where a line meets the plane of all p with normal · p = offset; false if it is parallel.
GLINT_FN bool line_meets_plane(dvec3 o, dvec3 d, dvec3 normal, double offset, GLINT_OUT(double) t) {
    double fall = dot(normal, d);
    t = 0.0;
    if (fall == 0.0) return false;
    t = (offset - dot(normal, o)) / fall;
    return true;
}

/// The point of a plane nearest to p, and its normal made unit.
GLINT_FN void point_of_plane(dvec3 normal, double offset, dvec3 p, GLINT_OUT(dvec3) on, GLINT_OUT(dvec3) n) {
    double squared = dot(normal, normal);
    on = p + normal * ((offset - dot(normal, p)) / squared);
    n = normal / sqrt(squared);
}

GLINT_SHARED_END
#endif
