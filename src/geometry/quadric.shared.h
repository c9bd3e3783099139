#ifndef GLINT_GEOMETRY_QUADRIC_SHARED_H
#define GLINT_GEOMETRY_QUADRIC_SHARED_H
#include "math/shared.h"

// Everything that tells one quadric from another, in double: its kind, its bounds, where lines are inside it,
// and its points and normals. C++ (geometry/quadric.h), vectors of rays (trace/simd/quadric_lanes-inl.h) and
// the shader read this text; where else a kind is asked for, it is for speed alone. Plane equations are here
// too.
//
// Roots by Haines et al., "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems (2019),
// chapter 7. Every sum is written so that mirrored scenes, scenes with x and y exchanged and scenes scaled by
// 2^k give the same bits.

// Shapes are the same for all rays of a vector.
#ifndef GLINT_LANES

GLINT_SHARED_BEGIN

const int quadric_sphere = 0;   // base: the centre
const int quadric_cylinder = 1; // solid, with both caps; from base along axis
const int quadric_disk = 2;     // thin: base is the centre, axis the normal
const int quadric_cone = 3;     // solid, with its cap; from base along axis to the apex
const int quadric_kinds = 4;

/// What a kind does not use is 0, but for the axis, which is always a unit vector.
struct QuadricShape {
    int kind;
    dvec3 base;
    dvec3 axis;
    double height;
    double radius;
};

/// Errors of double arithmetic relative to the largest number in it, with a wide margin: 2^-45.
const double surface_error = 1.0 / 35184372088832.0;

/// The largest number that a point of the surface is computed from.
GLINT_FN double size_of_quadric(GLINT_IN(QuadricShape) shape) {
    dvec3 base = abs(shape.base);
    return max(max(base.x, base.y), base.z) + shape.radius + shape.height;
}

/// The least and the greatest g · p over all points p of the quadric: over a sphere, or two parallel circles.
GLINT_FN void extent_of_quadric(GLINT_IN(QuadricShape) shape, dvec3 g, GLINT_OUT(double) low,
                                GLINT_OUT(double) high) {
    dvec3 across = shape.kind == quadric_sphere ? g : g - shape.axis * dot(shape.axis, g);
    double reach = shape.radius * sqrt(dot(across, across));
    double reach_at_top = shape.kind == quadric_cone ? 0.0 : reach;
    double base = dot(g, shape.base);
    double top = dot(g, shape.base + shape.axis * shape.height);
    low = min(base - reach, top - reach_at_top);
    high = max(base + reach, top + reach_at_top);
}

GLINT_SHARED_END
#endif

GLINT_SHARED_BEGIN

/// The part of a line inside a convex solid, enter <= t <= leave: there is one at most, and the parts of the
/// surface that it passes. A tangent has enter == leave. Parts: 0 the side, 1 the base cap, 2 the top cap.
struct SolidSpan {
    real64 enter;
    real64 leave;
    integer enter_part;
    integer leave_part;
};

/// The part of v perpendicular to a unit axis.
GLINT_FN dvec3 square_to(dvec3 axis, dvec3 v) { return v - axis * dot(axis, v); }

/// The part of the line f + t d with |f + t d| <= r. False if there is none: then it is not set.
GLINT_FN truth line_in_ball(dvec3 f, dvec3 d, double r, GLINT_OUT(real64) enter, GLINT_OUT(real64) leave) {
    enter = -infinite_double();
    leave = infinite_double();
    real64 a = dot(d, d);
    truth still = a == 0.0; // d = 0: all of the line is inside, or nothing

    // The discriminant from the line's nearest point: no difference of large squares where f is long. NaN if
    // still.
    real64 b = -dot(f, d);
    dvec3 nearest = f + d * (b / a);
    real64 delta = r * r - dot(nearest, nearest);
    real64 squared = dot(f, f);
    truth met = (still && squared <= r * r) || delta >= 0.0;
    if (!any_lane(met)) return met;

    // Both roots without a difference of nearly equal numbers.
    real64 root = sqrt(a * delta);
    real64 q = pick(b >= 0.0, b + root, b - root);
    real64 one = q / a;
    real64 other = pick(q == 0.0, 0.0, (squared - r * r) / q);
    truth ordered = one < other;
    enter = pick(still, enter, pick(ordered, one, other));
    leave = pick(still, leave, pick(ordered, other, one));
    return met;
}

/// Clips a span to 0 <= h + t rise <= height, where h is measured along the axis from the base cap.
GLINT_FN truth clip_to_caps(real64 h, real64 rise, double height, real64 side_enter, real64 side_leave,
                            GLINT_OUT(SolidSpan) span) {
    truth level = rise == 0.0;
    truth reversed = rise < 0.0; // in through the top
    real64 at_base = -h / rise;
    real64 at_top = (height - h) / rise;
    real64 cap_enter = pick(level, -infinite_double(), pick(reversed, at_top, at_base));
    real64 cap_leave = pick(level, infinite_double(), pick(reversed, at_base, at_top));

    // The solid is convex: one way in, one way out, at the rim too.
    truth enter_side = side_enter > cap_enter;
    truth leave_side = side_leave < cap_leave;
    span.enter = pick(enter_side, side_enter, cap_enter);
    span.leave = pick(leave_side, side_leave, cap_leave);
    span.enter_part = pick(enter_side, 0, pick(reversed, 2, 1));
    span.leave_part = pick(leave_side, 0, pick(reversed, 1, 2));
    truth outside = level && !(h >= 0.0 && h <= height);
    return !outside && span.enter <= span.leave;
}

/// The part of a line in a solid cylinder; o is the line's origin seen from the base.
GLINT_FN truth line_in_cylinder(dvec3 o, dvec3 d, dvec3 axis, double height, double radius,
                                GLINT_OUT(SolidSpan) span) {
    real64 side_enter;
    real64 side_leave;
    truth met = line_in_ball(square_to(axis, o), square_to(axis, d), radius, side_enter, side_leave);
    if (!any_lane(met)) return met;
    return clip_to_caps(dot(axis, o), dot(axis, d), height, side_enter, side_leave, span) && met;
}

/// Where a line crosses a disk; o is the line's origin seen from the centre. There is no way out: leave is
/// -infinity, before any ray begins.
GLINT_FN truth line_meets_disk(dvec3 o, dvec3 d, dvec3 normal, double radius, GLINT_OUT(SolidSpan) span) {
    // Parallel to the disk t is infinite or NaN, and p NaN: no hit.
    real64 t = -dot(normal, o) / dot(normal, d);
    dvec3 p = square_to(normal, o + d * t);
    span.enter = t;
    span.leave = -infinite_double();
    span.enter_part = 0;
    span.leave_part = 0;
    return dot(p, p) <= radius * radius;
}

/// The part of a line in a solid cone; o is the line's origin seen from the base. Inside the double cone
/// about the apex a t^2 - 2 b t + c <= 0.
GLINT_FN truth line_in_cone(dvec3 o, dvec3 d, dvec3 axis, double height, double radius,
                            GLINT_OUT(SolidSpan) span) {
    // t counts from the line's point nearest to the apex: no difference of large squares where o is far.
    dvec3 from_apex = o - axis * height;
    real64 shift = -dot(from_apex, d) / dot(d, d);
    dvec3 f = from_apex + d * shift;

    double slope = radius / height;
    double slope2 = slope * slope;
    real64 down = -dot(axis, f);
    real64 fall = -dot(axis, d);
    dvec3 f_across = square_to(axis, f);
    dvec3 d_across = square_to(axis, d);
    real64 a = dot(d_across, d_across) - slope2 * (fall * fall);
    real64 b = slope2 * (down * fall) - dot(f_across, d_across);
    real64 c = dot(f_across, f_across) - slope2 * (down * down);

    // b^2 - a c with its large terms cancelled by hand. A line steeper than the side always meets the double
    // cone.
    dvec3 along = d_across * down - f_across * fall;
    dvec3 around = cross(f_across, d_across);
    real64 delta = slope2 * dot(along, along) - dot(around, around);
    truth steep = a < 0.0;
    truth met = steep || delta >= 0.0;
    if (!any_lane(met)) return met;

    // Rounding may leave no delta to a steep line outside the double cone, where b^2 - a c does not cancel.
    real64 uncancelled = pick(steep && c > 0.0, b * b - a * c, 0.0);
    real64 root = sqrt(pick(delta > 0.0, delta, uncancelled));
    real64 q = pick(b >= 0.0, b + root, b - root);
    // All is 0 but c: the line is parallel to the side and meets it nowhere.
    truth misses = q == 0.0 && c > 0.0;
    real64 one = pick(q == 0.0, 0.0, q / a); // infinite where the line is parallel to the side
    real64 other = pick(q == 0.0, 0.0, c / q);
    truth ordered = one < other;
    real64 first = pick(ordered, one, other);
    real64 second = pick(ordered, other, one);

    // Steep lines are inside before the first root and after the second: one of the two is below the apex.
    truth descends = fall > 0.0;
    real64 side_enter = pick(steep, pick(descends, second, -infinite_double()), first) + shift;
    real64 side_leave = pick(steep, pick(descends, infinite_double(), first), second) + shift;
    return clip_to_caps(dot(axis, o), dot(axis, d), height, side_enter, side_leave, span) && met && !misses;
}

/// The part of the line o + t d inside a quadric.
GLINT_FN truth line_in_quadric(GLINT_IN(QuadricShape) shape, dvec3 o, dvec3 d, GLINT_OUT(SolidSpan) span) {
    dvec3 from = o - shape.base;
    if (shape.kind == quadric_cylinder)
        return line_in_cylinder(from, d, shape.axis, shape.height, shape.radius, span);
    if (shape.kind == quadric_disk) return line_meets_disk(from, d, shape.axis, shape.radius, span);
    if (shape.kind == quadric_cone)
        return line_in_cone(from, d, shape.axis, shape.height, shape.radius, span);
    span.enter_part = 0;
    span.leave_part = 0;
    return line_in_ball(from, d, shape.radius, span.enter, span.leave);
}

/// The point of a sphere nearest to p, and the outward normal there.
GLINT_FN void point_of_sphere(dvec3 center, double radius, dvec3 p, GLINT_OUT(dvec3) on, GLINT_OUT(dvec3) n) {
    dvec3 v = p - center;
    n = v / sqrt(dot(v, v));
    on = center + n * radius;
}

/// The same for one part of a cylinder's surface.
GLINT_FN void point_of_cylinder(dvec3 base, dvec3 axis, double height, double radius, integer part, dvec3 p,
                                GLINT_OUT(dvec3) on, GLINT_OUT(dvec3) n) {
    dvec3 v = p - base;
    dvec3 radial = square_to(axis, v);
    dvec3 out_of_side = radial / sqrt(dot(radial, radial));
    truth on_base = part == 1;
    truth on_top = part == 2;
    dvec3 on_side = base + axis * dot(axis, v) + out_of_side * radius;
    n = pick(on_base, -axis, pick(on_top, axis, out_of_side));
    on = pick(on_base, base + radial, pick(on_top, base + axis * height + radial, on_side));
}

/// The same for one part of a cone's surface. At the apex the normal is the axis.
GLINT_FN void point_of_cone(dvec3 base, dvec3 axis, double height, double radius, integer part, dvec3 p,
                            GLINT_OUT(dvec3) on, GLINT_OUT(dvec3) n) {
    dvec3 v = p - base;
    dvec3 radial = square_to(axis, v);
    real64 distance = sqrt(dot(radial, radial));
    real64 slant = sqrt(height * height + radius * radius);
    dvec3 out_of_side = radial / distance * (height / slant) + axis * (radius / slant);
    truth on_base = part == 1;
    n = pick(on_base, -axis, pick(distance > 0.0, out_of_side, axis));
    // How far p is above the side.
    real64 above = ((distance - radius) * height + dot(axis, v) * radius) / slant;
    on = base + pick(on_base, radial, v - n * above);
}

/// The point of one part of a quadric's surface nearest to p, and the outward normal there.
GLINT_FN void point_of_quadric(GLINT_IN(QuadricShape) shape, integer part, dvec3 p, GLINT_OUT(dvec3) on,
                               GLINT_OUT(dvec3) n) {
    if (shape.kind == quadric_cylinder)
        point_of_cylinder(shape.base, shape.axis, shape.height, shape.radius, part, p, on, n);
    else if (shape.kind == quadric_cone)
        point_of_cone(shape.base, shape.axis, shape.height, shape.radius, part, p, on, n);
    else if (shape.kind == quadric_disk) {
        dvec3 axis = shape.axis;
        on = shape.base + square_to(axis, p - shape.base);
        n = axis;
    } else
        point_of_sphere(shape.base, shape.radius, p, on, n);
}

/// Where a line meets the plane of all p with normal · p = offset; false if it is parallel.
GLINT_FN truth line_meets_plane(dvec3 o, dvec3 d, dvec3 normal, double offset, GLINT_OUT(real64) t) {
    real64 fall = dot(normal, d);
    t = (offset - dot(normal, o)) / fall;
    return fall != 0.0;
}

/// The point of a plane nearest to p; `squared` is normal · normal.
GLINT_FN dvec3 foot_on_plane(dvec3 normal, real64 squared, double offset, dvec3 p) {
    return p + normal * ((offset - dot(normal, p)) / squared);
}

/// The same, and the unit normal.
GLINT_FN void point_of_plane(dvec3 normal, double offset, dvec3 p, GLINT_OUT(dvec3) on, GLINT_OUT(dvec3) n) {
    real64 squared = dot(normal, normal);
    on = foot_on_plane(normal, squared, offset, p);
    n = normal / sqrt(squared);
}

GLINT_SHARED_END
#endif
