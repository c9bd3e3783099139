#ifndef GLINT_GEOMETRY_QUADRIC_SHARED_H
#define GLINT_GEOMETRY_QUADRIC_SHARED_H
#include "math/shared.h"

// All that depends on the kind of a quadric, in double: bounds, intersection with lines, points and normals;
// also the equations of planes. Compiled as C++ (geometry/quadric.h), for vectors of rays
// (trace/simd/quadric_lanes-inl.h) and as GLSL. Other code tests the kind only for speed.
//
// Roots after Haines et al., "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems (2019),
// chapter 7. Sums are ordered such that mirroring a scene, exchanging x and y, and scaling by 2^k keep the
// bits.

// Shapes are the same for all rays of a vector.
#ifndef GLINT_LANES

GLINT_SHARED_BEGIN

const int quadric_sphere = 0;   // base: the centre
const int quadric_cylinder = 1; // solid, with both caps; from base along axis
const int quadric_disk = 2;     // thin: base is the centre, axis the normal
const int quadric_cone = 3;     // solid, with its cap; from base along axis to the apex
const int quadric_kinds = 4;

/// Members that a kind does not use are 0, except that the axis is always a unit vector.
struct QuadricShape {
    int kind;
    dvec3 base;
    dvec3 axis;
    double height;
    double radius;
};

/// Errors of double arithmetic relative to the largest number in it, with a wide margin: 2^-45.
const double surface_error = 1.0 / 35184372088832.0;

/// How far rays start from the edges of faces, in errors of their start points: see "Away from edges" in
/// geometry/surface.shared.h.
const double edge_margin = 32.0;
/// That distance where no coordinate is larger than `size`: 2^-24 of it is half a float's spacing.
GLINT_FN double margin_at_rim(double size) { return edge_margin * size * (1.0 / 16777216.0); }

/// Bound on the numbers from which a point of the surface is computed.
GLINT_FN double size_of_quadric(GLINT_IN(QuadricShape) shape) {
    dvec3 base = abs(shape.base);
    return max(max(base.x, base.y), base.z) + shape.radius + shape.height;
}

/// Range of g · p over all points p of the quadric: a sphere, or the hull of two parallel circles.
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

/// The part of a line inside a convex solid, enter <= t <= leave, and the parts of the surface where it
/// enters and leaves: 0 the side, 1 the base cap, 2 the top cap. A tangent has enter == leave.
struct SolidSpan {
    real64 enter;
    real64 leave;
    integer enter_part;
    integer leave_part;
};

/// The component of v perpendicular to a unit axis.
GLINT_FN dvec3 perpendicular_to(dvec3 axis, dvec3 v) { return v - axis * dot(axis, v); }

/// The part of the line f + t d with |f + t d| <= r. False if there is none; the results are unspecified
/// then.
GLINT_FN truth line_in_ball(dvec3 f, dvec3 d, double r, GLINT_OUT(real64) enter, GLINT_OUT(real64) leave) {
    enter = -infinite_double();
    leave = infinite_double();
    real64 a = dot(d, d);
    truth is_point = a == 0.0; // d = 0: the whole line is inside or outside

    // The discriminant from the point of the line nearest to the centre avoids a difference of large squares.
    // NaN if d = 0.
    real64 b = -dot(f, d);
    dvec3 nearest = f + d * (b / a);
    real64 delta = r * r - dot(nearest, nearest);
    real64 squared = dot(f, f);
    truth met = (is_point && squared <= r * r) || delta >= 0.0;
    if (!any_lane(met)) return met;

    // Both roots without a difference of nearly equal numbers.
    real64 root = sqrt(a * delta);
    real64 q = pick(b >= 0.0, b + root, b - root);
    real64 one = q / a;
    real64 other = pick(q == 0.0, 0.0, (squared - r * r) / q);
    truth ordered = one < other;
    enter = pick(is_point, enter, pick(ordered, one, other));
    leave = pick(is_point, leave, pick(ordered, other, one));
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

    // Convex: the line enters and leaves once, at the rim as well.
    truth enter_side = side_enter > cap_enter;
    truth leave_side = side_leave < cap_leave;
    span.enter = pick(enter_side, side_enter, cap_enter);
    span.leave = pick(leave_side, side_leave, cap_leave);
    span.enter_part = pick(enter_side, 0, pick(reversed, 2, 1));
    span.leave_part = pick(leave_side, 0, pick(reversed, 1, 2));
    truth outside = level && !(h >= 0.0 && h <= height);
    return !outside && span.enter <= span.leave;
}

/// The part of a line in a solid cylinder; o is the line's origin relative to the base.
GLINT_FN truth line_in_cylinder(dvec3 o, dvec3 d, dvec3 axis, double height, double radius,
                                GLINT_OUT(SolidSpan) span) {
    real64 side_enter;
    real64 side_leave;
    truth met =
        line_in_ball(perpendicular_to(axis, o), perpendicular_to(axis, d), radius, side_enter, side_leave);
    if (!any_lane(met)) return met;
    return clip_to_caps(dot(axis, o), dot(axis, d), height, side_enter, side_leave, span) && met;
}

/// Where a line crosses a disk; o is the line's origin relative to the centre. There is one root: leave is
/// -infinity, before any ray starts.
GLINT_FN truth line_meets_disk(dvec3 o, dvec3 d, dvec3 normal, double radius, GLINT_OUT(SolidSpan) span) {
    // Parallel to the disk t is infinite or NaN, and p NaN: no hit.
    real64 t = -dot(normal, o) / dot(normal, d);
    dvec3 p = perpendicular_to(normal, o + d * t);
    span.enter = t;
    span.leave = -infinite_double();
    span.enter_part = 0;
    span.leave_part = 0;
    return dot(p, p) <= radius * radius;
}

/// The part of a line in a solid cone; o is the line's origin relative to the base. Inside the double cone
/// about the apex a t^2 - 2 b t + c <= 0.
GLINT_FN truth line_in_cone(dvec3 o, dvec3 d, dvec3 axis, double height, double radius,
                            GLINT_OUT(SolidSpan) span) {
    // t is measured from the point of the line nearest to the apex, to avoid a difference of large squares.
    dvec3 from_apex = o - axis * height;
    real64 shift = -dot(from_apex, d) / dot(d, d);
    dvec3 f = from_apex + d * shift;

    double slope = radius / height;
    double slope2 = slope * slope;
    real64 down = -dot(axis, f);
    real64 fall = -dot(axis, d);
    dvec3 f_across = perpendicular_to(axis, f);
    dvec3 d_across = perpendicular_to(axis, d);
    real64 a = dot(d_across, d_across) - slope2 * (fall * fall);
    real64 b = slope2 * (down * fall) - dot(f_across, d_across);
    real64 c = dot(f_across, f_across) - slope2 * (down * down);

    // b^2 - a c with its large terms cancelled analytically. A line steeper than the side always meets the
    // double cone.
    dvec3 along = d_across * down - f_across * fall;
    dvec3 around = cross(f_across, d_across);
    real64 delta = slope2 * dot(along, along) - dot(around, around);
    truth steep = a < 0.0;
    truth met = steep || delta >= 0.0;
    if (!any_lane(met)) return met;

    // Delta may round to 0 for a steep line outside the double cone, where b^2 - a c does not cancel.
    real64 uncancelled = pick(steep && c > 0.0, b * b - a * c, 0.0);
    real64 root = sqrt(pick(delta > 0.0, delta, uncancelled));
    real64 q = pick(b >= 0.0, b + root, b - root);
    // Only c is not 0: the line is parallel to the side and misses it.
    truth misses = q == 0.0 && c > 0.0;
    real64 one = pick(q == 0.0, 0.0, q / a); // infinite where the line is parallel to the side
    real64 other = pick(q == 0.0, 0.0, c / q);
    truth ordered = one < other;
    real64 first = pick(ordered, one, other);
    real64 second = pick(ordered, other, one);

    // Steep lines are inside before the first root and after the second; one of these parts is below the
    // apex.
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

/// x, but at least `low` and at most `high`.
GLINT_FN real64 limited(real64 x, real64 low, real64 high) {
    return pick(x < low, low, pick(x > high, high, x));
}

/// The part of a cap's point across the axis, off the rim.
GLINT_FN dvec3 off_rim(dvec3 radial, real64 distance, double radius, real64 margin) {
    return radial * pick(distance > radius - margin, (radius - margin) / distance, 1.0);
}

/// Likewise for one part of a cylinder's surface.
GLINT_FN void point_of_cylinder(dvec3 base, dvec3 axis, double height, double radius, integer part, dvec3 p,
                                double margin, GLINT_OUT(dvec3) on, GLINT_OUT(dvec3) n) {
    dvec3 v = p - base;
    dvec3 radial = perpendicular_to(axis, v);
    real64 distance = sqrt(dot(radial, radial));
    dvec3 out_of_side = radial / distance;
    truth on_base = part == 1;
    truth on_top = part == 2;
    dvec3 on_side = base + axis * limited(dot(axis, v), margin, height - margin) + out_of_side * radius;
    dvec3 on_cap = off_rim(radial, distance, radius, margin);
    n = pick(on_base, -axis, pick(on_top, axis, out_of_side));
    on = pick(on_base, base + on_cap, pick(on_top, base + axis * height + on_cap, on_side));
}

/// Likewise for one part of a cone's surface. At the apex the normal is the axis.
GLINT_FN void point_of_cone(dvec3 base, dvec3 axis, double height, double radius, integer part, dvec3 p,
                            double margin, GLINT_OUT(dvec3) on, GLINT_OUT(dvec3) n) {
    dvec3 v = p - base;
    dvec3 radial = perpendicular_to(axis, v);
    real64 distance = sqrt(dot(radial, radial));
    real64 slant = sqrt(height * height + radius * radius);
    dvec3 outward = radial / distance;
    dvec3 out_of_side = outward * (height / slant) + axis * (radius / slant);
    truth on_base = part == 1;
    n = pick(on_base, -axis, pick(distance > 0.0, out_of_side, axis));
    // Height of p above the side, and of its foot above the base.
    real64 along = dot(axis, v);
    real64 above = ((distance - radius) * height + along * radius) / slant;
    real64 foot = along - above * (radius / slant);
    // Along the side to where it is off the rim and the apex.
    real64 shift = limited(foot, margin, height - margin) - foot;
    dvec3 down_side = axis - outward * (radius / height);
    dvec3 on_side = v - n * above + pick(distance > 0.0, down_side * shift, v * 0.0);
    on = base + pick(on_base, off_rim(radial, distance, radius, margin), on_side);
}

/// The point of one part of a quadric's surface nearest to p, and the outward normal there. Of the points
/// less than `margin` from the part's rim or apex none is taken: see "Away from edges" in
/// geometry/surface.shared.h. Cones with a sharper rim or apex than 15° keep more.
GLINT_FN void point_of_quadric(GLINT_IN(QuadricShape) shape, integer part, dvec3 p, double margin,
                               GLINT_OUT(dvec3) on, GLINT_OUT(dvec3) n) {
    double slenderness = max(shape.height / shape.radius, shape.radius / shape.height);
    double sharpness = shape.kind == quadric_cone ? min(max(slenderness / 4.0, 1.0), 16.0) : 1.0;
    double kept = min(margin * sharpness, min(shape.height, shape.radius) / 16.0);
    if (shape.kind == quadric_cylinder)
        point_of_cylinder(shape.base, shape.axis, shape.height, shape.radius, part, p, kept, on, n);
    else if (shape.kind == quadric_cone)
        point_of_cone(shape.base, shape.axis, shape.height, shape.radius, part, p, kept, on, n);
    else if (shape.kind == quadric_disk) {
        dvec3 axis = shape.axis;
        on = shape.base + perpendicular_to(axis, p - shape.base);
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
GLINT_FN dvec3 project_onto_plane(dvec3 normal, real64 squared, double offset, dvec3 p) {
    return p + normal * ((offset - dot(normal, p)) / squared);
}

/// The same, and the unit normal.
GLINT_FN void point_of_plane(dvec3 normal, double offset, dvec3 p, GLINT_OUT(dvec3) on, GLINT_OUT(dvec3) n) {
    real64 squared = dot(normal, normal);
    on = project_onto_plane(normal, squared, offset, p);
    n = normal / sqrt(squared);
}

GLINT_SHARED_END
#endif
