#ifndef GLINT_GEOMETRY_TRIANGLE_SHARED_H
#define GLINT_GEOMETRY_TRIANGLE_SHARED_H
#include "math/shared.h"

// The triangle test after the shear, and the point that was hit; geometry/triangle.h explains the method.

GLINT_SHARED_BEGIN

/// Result of the test; valid only if it returned true.
struct TriangleHit {
    float t;       ///< rounded from double
    float u;       ///< weight of vertex 1
    float v;       ///< weight of vertex 2
    bool on_edge;  ///< exactly through an edge or a vertex
    bool positive; ///< the sign of the sheared area: equal for triangles of one facing along one ray
};

/// Whether both signs occur among the three; NaN has none. Branchless, as the facing of triangles is
/// unpredictable.
GLINT_FN bool mixed_signs(float a, float b, float c) {
    int below = int(a < 0.0f) | int(b < 0.0f) | int(c < 0.0f);
    int above = int(a > 0.0f) | int(b > 0.0f) | int(c > 0.0f);
    return (below & above) != 0;
}
GLINT_FN bool mixed_signs(double a, double b, double c) {
    int below = int(a < 0.0) | int(b < 0.0) | int(c < 0.0);
    int above = int(a > 0.0) | int(b > 0.0) | int(c > 0.0);
    return (below & above) != 0;
}

/// A vertex relative to a sheared ray: x and y across it, z = v[kz] − o[kz] before its scaling by sz.
struct ShearedVertex {
    float x;
    float y;
    float z;
};

/// Rounding is monotone: a float difference of products never has the wrong sign, it can only be 0. So exact
/// arithmetic also rejects whatever this rejects.
GLINT_FN bool surely_outside(ShearedVertex a, ShearedVertex b, ShearedVertex c) {
    GLINT_PRECISE float u = c.x * b.y - c.y * b.x;
    GLINT_PRECISE float v = a.x * c.y - a.y * c.x;
    GLINT_PRECISE float w = b.x * a.y - b.y * a.x;
    return mixed_signs(u, v, w);
}

/// Completes a hit at t by its areas to the edges, if t is wanted.
GLINT_FN bool accept_hit(double t, double u, double v, double w, double det, float tmin, float limit,
                         GLINT_OUT(TriangleHit) hit) {
    hit.t = float(t);
    if (!(t > double(tmin) && hit.t <= limit)) return false;
    hit.u = float(v / det);
    hit.v = float(w / det);
    hit.on_edge = u == 0.0 || v == 0.0 || w == 0.0;
    hit.positive = det > 0.0;
    return true;
}

/// The exact part of the test, for triangles that are not surely outside.
GLINT_FN bool intersect_sheared(ShearedVertex a, ShearedVertex b, ShearedVertex c, float sz, float tmin,
                                float limit, GLINT_OUT(TriangleHit) hit) {
    // Products of floats are exact in double, so that these signs are exact.
    double u = double(c.x) * double(b.y) - double(c.y) * double(b.x);
    double v = double(a.x) * double(c.y) - double(a.y) * double(c.x);
    double w = double(b.x) * double(a.y) - double(b.y) * double(a.x);
    if (mixed_signs(u, v, w)) return false;
    double det = u + v + w;
    if (det == 0.0) return false;

    double az = double(sz * a.z);
    double bz = double(sz * b.z);
    double cz = double(sz * c.z);
    return accept_hit((u * az + v * bz + w * cz) / det, u, v, w, det, tmin, limit, hit);
}

/// The test of a wide triangle; z of its corners is already scaled.
GLINT_FN bool intersect_in_double(dvec3 a, dvec3 b, dvec3 c, float tmin, float limit,
                                  GLINT_OUT(TriangleHit) hit) {
    // Rounding is monotone: no difference of products has the wrong sign, it can only be 0.
    GLINT_PRECISE double u = c.x * b.y - c.y * b.x;
    GLINT_PRECISE double v = a.x * c.y - a.y * c.x;
    GLINT_PRECISE double w = b.x * a.y - b.y * a.x;
    if (mixed_signs(u, v, w)) return false;
    double det = u + v + w;
    if (det == 0.0) return false;
    return accept_hit((u * a.z + v * b.z + w * c.z) / det, u, v, w, det, tmin, limit, hit);
}

/// A corner of a wide triangle for intersect_in_double(): `v` relative to the ray's origin, with its axes
/// permuted; `shear` is d[kx]/d[kz], d[ky]/d[kz], 1/d[kz].
GLINT_FN dvec3 sheared_in_double(dvec3 v, dvec3 shear) {
    GLINT_PRECISE double x = v.x - shear.x * v.z;
    GLINT_PRECISE double y = v.y - shear.y * v.z;
    return dvec3(x, y, shear.z * v.z);
}

/// The point with weights u and v of vertices b and c, and the unit normal by the winding. Where the triangle
/// has no area, any unit normal facing `seen_along` (not zero).
GLINT_FN void point_of_triangle(vec3 a, vec3 b, vec3 c, double u, double v, dvec3 seen_along,
                                GLINT_OUT(dvec3) p, GLINT_OUT(dvec3) n) {
    dvec3 origin = dvec3(a);
    dvec3 e1 = dvec3(b) - origin;
    dvec3 e2 = dvec3(c) - origin;
    dvec3 normal = cross(e1, e2);
    if (dot(normal, normal) == 0.0) normal = -seen_along;
    p = origin + e1 * u + e2 * v;
    n = normal / sqrt(dot(normal, normal));
}

/// A bound, per axis, on the distance of p (rounded to float) from its triangle plus the displacement of the
/// triangle by the test of a ray that starts there: an origin moved off the plane by it never hits that
/// triangle again. Half a float's spacing of p, and 8 u S for the displacement (geometry/triangle.h), where S
/// is the largest |coordinate| of v - p. GLSL needs 2^-24 and 2^-21 written out.
GLINT_FN vec3 error_of_triangle(vec3 a, vec3 b, vec3 c, vec3 p) {
    vec3 far = max(max(abs(a - p), abs(b - p)), abs(c - p));
    float reach = max(max(far.x, far.y), far.z);
    return abs(p) * (1.0f / 16777216.0f) + vec3(reach * (1.0f / 2097152.0f));
}

GLINT_SHARED_END
#endif
