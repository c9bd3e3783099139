#ifndef GLINT_SHADING_EMITTER_SHARED_H
#define GLINT_SHADING_EMITTER_SHARED_H
#include "math/elementary.shared.h"
#include "math/offset.shared.h"
#include "math/shared.h"
#include "shading/sampling.shared.h"

// Points on surfaces that emit light, as path tracers sample them: their densities over solid angle, seen
// from a point x.

GLINT_SHARED_BEGIN

const float two_pi = 6.28318531f;

// EmitterRecord::kind
const int emitter_none = 0; ///< found by the directions that materials sample, alone
const int emitter_triangle = 1;
const int emitter_rectangle = 2; ///< or another parallelogram
const int emitter_disk = 3;
const int emitter_sphere = 4;

/// One surface that emits: a triangle of a mesh, a rectangle, a disk, a sphere.
struct EmitterRecord {
    vec3 base; ///< a corner; the centre of a disk or sphere
    int kind;
    vec3 u; ///< edges from the corner; of a disk, two perpendicular radii
    float area;
    vec3 v;
    float radius;
    vec3 n;      ///< unit normal of flat ones, as the object has it: outward for closed shapes
    uint object; ///< in file order
};

/// A point of an emitter.
struct EmitterSample {
    vec3 p;
    vec3 n;         ///< unit, as the object has it
    vec3 direction; ///< from x, unit
    float distance;
    float pdf; ///< over solid angle; 0: no point
};

/// Density over solid angle of a point at `to` from x that is uniform by area.
GLINT_FN float pdf_by_area(GLINT_IN(EmitterRecord) e, vec3 to, vec3 n) {
    float squared = dot(to, to);
    float cosine = abs(dot(n, to)) / sqrt(squared);
    return cosine > 0.0f ? squared / (cosine * e.area) : 0.0f;
}

/// 1 − cos of half the angle of the cone in which a sphere is seen from outside. (1 − cos θ = sin² θ / (1 +
/// cos θ) has no cancellation for far spheres.)
GLINT_FN float cone_height(float radius, float squared_distance) {
    float sine_squared = radius * radius / squared_distance;
    return sine_squared / (1.0f + sqrt(max(0.0f, 1.0f - sine_squared)));
}

/// The solid angle of a triangle whose corners are at these places from x. (A. Van Oosterom and J. Strackee,
/// "The Solid Angle of a Plane Triangle", IEEE Transactions on Biomedical Engineering 30 (2), 1983. The
/// triple product of a corner and edges has no cancellation.)
GLINT_FN float solid_angle(vec3 a, vec3 b, vec3 c) {
    float la = length(a);
    float lb = length(b);
    float lc = length(c);
    float volume = abs(dot(a, cross(b - a, c - a)));
    return 2.0f * angle_of(la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la, volume);
}

/// The halves of a rectangle, or a triangle alone.
struct EmitterAngles {
    float first;  ///< solid angle of base, base + u and base + v (a triangle) or base + u + v
    float second; ///< of base, base + u + v and base + v; 0 for a triangle
};

GLINT_FN EmitterAngles emitter_angles(GLINT_IN(EmitterRecord) e, vec3 x) {
    vec3 base = e.base - x;
    EmitterAngles angles;
    angles.second = 0.0f;
    if (e.kind == emitter_triangle) {
        angles.first = solid_angle(base, base + e.u, base + e.v);
        return angles;
    }
    vec3 across = base + e.u + e.v;
    angles.first = solid_angle(base, base + e.u, across);
    angles.second = solid_angle(base, across, base + e.v);
    return angles;
}

/// True where sampling by solid angle is better than by area, and exact enough: not for what is seen small,
/// nor from points in its plane.
GLINT_FN bool is_seen_wide(GLINT_IN(EmitterAngles) angles) {
    float angle = angles.first + angles.second;
    return angle > 3e-4f && angle < 6.2f;
}

GLINT_FN bool is_flat_with_corners(GLINT_IN(EmitterRecord) e) {
    return e.kind == emitter_triangle || e.kind == emitter_rectangle;
}

/// True where a sphere is sampled by the cone in which it is seen: not from inside, nor from its surface.
GLINT_FN bool is_seen_in_cone(float radius, float squared_distance) {
    return squared_distance > radius * radius * 1.001f;
}

/// Density over solid angle of sample_emitter() at the point p, where its normal is n.
GLINT_FN float emitter_pdf(GLINT_IN(EmitterRecord) e, vec3 x, vec3 p, vec3 n) {
    if (e.kind == emitter_sphere) {
        vec3 to_center = e.base - x;
        float squared = dot(to_center, to_center);
        if (is_seen_in_cone(e.radius, squared)) return 1.0f / (two_pi * cone_height(e.radius, squared));
    }
    if (is_flat_with_corners(e)) {
        EmitterAngles angles = emitter_angles(e, x);
        if (is_seen_wide(angles)) return 1.0f / (angles.first + angles.second);
    }
    return pdf_by_area(e, p - x, n);
}

/// A point uniform by area: of a triangle by P. Shirley and C. Wang's map, "Direct Lighting Calculation by
/// Monte Carlo Integration", 1991.
GLINT_FN vec3 point_by_area(GLINT_IN(EmitterRecord) e, float u, float v, GLINT_OUT(vec3) n) {
    n = e.n;
    if (e.kind == emitter_triangle) {
        float root = sqrt(u);
        return e.base + e.u * (1.0f - root) + e.v * (v * root);
    }
    if (e.kind == emitter_rectangle) return e.base + e.u * u + e.v * v;
    if (e.kind == emitter_disk) {
        vec3 d = disk_sample(u, v);
        return e.base + e.u * d.x + e.v * d.y;
    }
    // A disk becomes a hemisphere of twice the area by lifting; the half of it is chosen by u.
    float side = u < 0.5f ? 1.0f : -1.0f;
    vec3 d = disk_sample(u < 0.5f ? 2.0f * u : 2.0f * u - 1.0f, v);
    float squared = d.x * d.x + d.y * d.y;
    float scale = sqrt(max(0.0f, 2.0f - squared));
    n = vec3(d.x * scale, d.y * scale, side * (1.0f - squared));
    return e.base + n * e.radius;
}

/// The part of v that is perpendicular to the unit vector n, as a unit vector.
GLINT_FN vec3 unit_across(vec3 v, vec3 n) { return normalize(v - n * dot(v, n)); }

/// A direction uniform over the solid angle of a triangle, whose corners are in these unit directions. (J.
/// Arvo, "Stratified Sampling of Spherical Triangles", SIGGRAPH 1995.)
GLINT_FN vec3 direction_to_triangle(vec3 a, vec3 b, vec3 c, float angle, float u, float v) {
    vec3 to_b = unit_across(b, a);
    vec3 to_c = unit_across(c, a);
    // At a, whose angle is α, a part of the triangle is cut off that has a share u of its solid angle.
    float cos_alpha = dot(to_b, to_c);
    float sin_alpha = sqrt(max(0.0f, 1.0f - cos_alpha * cos_alpha));
    vec2 part = cos_sin_of(u * angle);
    float sine = part.y * cos_alpha - part.x * sin_alpha;
    float cosine = part.x * cos_alpha + part.y * sin_alpha;
    float k1 = cosine - cos_alpha;
    float k2 = sine + sin_alpha * dot(a, b);
    float below = (k2 * sine + k1 * cosine) * sin_alpha;
    float along = below != 0.0f ? ((k2 * cosine - k1 * sine) * cos_alpha - k2) / below : 1.0f;
    along = clamp(along, -1.0f, 1.0f);
    vec3 corner = a * along + to_c * sqrt(max(0.0f, 1.0f - along * along));
    // On the arc from b to that corner.
    float height = 1.0f - v * (1.0f - dot(corner, b));
    return b * height + unit_across(corner, b) * sqrt(max(0.0f, 1.0f - height * height));
}

/// A point of a flat emitter with corners, uniform over its solid angle.
GLINT_FN vec3 point_by_angle(GLINT_IN(EmitterRecord) e, vec3 x, GLINT_IN(EmitterAngles) angles, float u,
                             float v) {
    vec3 base = e.base - x;
    vec3 second = base + e.u;
    vec3 third = base + e.v;
    float share = angles.first / (angles.first + angles.second);
    bool in_first = u < share;
    float angle = in_first ? angles.first : angles.second;
    float rest = in_first ? u / share : (u - share) / (1.0f - share);
    if (e.kind == emitter_rectangle) {
        second = in_first ? second : base + e.u + e.v;
        third = in_first ? base + e.u + e.v : third;
    }
    vec3 d = direction_to_triangle(normalize(base), normalize(second), normalize(third), angle, rest, v);
    return x + d * (dot(base, e.n) / dot(d, e.n));
}

/// The point of a sphere at which a direction within the cone about its centre, `to_center` from x, meets it
/// first; uniform over the cone.
GLINT_FN vec3 point_in_cone(vec3 to_center, float squared, float radius, float u, float v,
                            GLINT_OUT(vec3) n) {
    // Of the angle θ to the axis: a uniform disk with r² = (1 − cos θ) / (1 − cos θ_max).
    vec3 d = disk_sample(u, v);
    float cap = cone_height(radius, squared);
    float height = cap * (d.x * d.x + d.y * d.y); // 1 − cos θ
    float sine_squared = height * (2.0f - height);
    // By the law of sines the triangle of x, centre and point has the angle β − θ at the centre, with sin β =
    // sin θ · distance / radius.
    float ratio = sqrt(squared) / radius;
    float cos_beta = sqrt(max(0.0f, 1.0f - sine_squared * (ratio * ratio)));
    float cosine = (1.0f - height) * cos_beta + sine_squared * ratio;
    float scale = sqrt(cap * (2.0f - height)) * (ratio * (1.0f - height) - cos_beta);
    n = normalize(turned_to(to_center / -sqrt(squared), vec3(d.x * scale, d.y * scale, cosine)));
    return to_center + n * radius;
}

/// The point p of an emitter as seen from x; `pdf` with which it was chosen.
GLINT_FN EmitterSample emitter_sample(vec3 x, vec3 p, vec3 n, float pdf) {
    EmitterSample s;
    vec3 to = p - x;
    s.p = p;
    s.n = n;
    s.distance = length(to);
    s.direction = s.distance > 0.0f ? to / s.distance : vec3(0.0f);
    s.pdf = s.distance > 0.0f ? pdf : 0.0f;
    return s;
}

/// A point of the emitter, by two numbers in [0, 1).
GLINT_FN EmitterSample sample_emitter(GLINT_IN(EmitterRecord) e, vec3 x, float u, float v) {
    vec3 n = e.n;
    if (e.kind == emitter_sphere) {
        vec3 to_center = e.base - x;
        float squared = dot(to_center, to_center);
        if (is_seen_in_cone(e.radius, squared)) {
            vec3 to = point_in_cone(to_center, squared, e.radius, u, v, n);
            return emitter_sample(x, x + to, n, 1.0f / (two_pi * cone_height(e.radius, squared)));
        }
    }
    if (is_flat_with_corners(e)) {
        EmitterAngles angles = emitter_angles(e, x);
        if (is_seen_wide(angles))
            return emitter_sample(x, point_by_angle(e, x, angles, u, v), n,
                                  1.0f / (angles.first + angles.second));
    }
    vec3 p = point_by_area(e, u, v, n);
    return emitter_sample(x, p, n, pdf_by_area(e, p - x, n));
}

/// Where a shadow ray to the point ends: on x's side of the emitter, beyond the rounding of the point and of
/// a ray of that length.
GLINT_FN vec3 end_before(GLINT_IN(EmitterRecord) e, GLINT_IN(EmitterSample) s) {
    vec3 size = abs(e.base) + abs(e.u) + abs(e.v) + vec3(e.radius + s.distance);
    return offset_ray_origin(s.p, size * (1.0f / 4194304.0f), s.n, -s.direction);
}

GLINT_SHARED_END
#endif
