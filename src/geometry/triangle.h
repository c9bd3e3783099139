#pragma once
// The triangle test that decides every bit of a triangle's hit: watertight after Woop, Benthin, Wald,
// "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013, with exact edge signs.
//
// The ray is sheared so that it runs along +z through the origin. Up to there all is float; from there on all
// is exact to double. A computed hit is therefore the exact hit of a triangle whose vertices are slightly
// displaced, and each vertex is displaced alike in all triangles that share it. How far, with u = 2^-24, S
// the largest |coordinate| of v - o, s = d[kx]/d[kz], |s| <= 1, to first order in u:
//
// - depth, Az = Sz·(v-o)[kz]: rounding of v-o, of 1/d[kz] and of the product, u S each. In all 3 u S.
// - lateral, Ax = (v-o)[kx] - Sx·(v-o)[kz]: rounding of (v-o)[kx], u S, and of the difference, 2 u S. Sx, its
//   product, Sz and its product in Az stretch one and the same depth, 4 u S. In all 7 u S.
//
// Boxes must be conservative (bvh/traverse.h) and spawned rays be offset (triangle_point_error) against that.

#include "geometry/quadric.h"
#include "math/ray.h"
#include "math/vec.h"

#include <array>
#include <cstddef>

namespace glint {

/// A ray as the triangle test wants it, made once a ray. Direction finite and not zero.
struct ShearedRay {
    /// kz is the first of the axes with the largest |direction|; kx and ky follow cyclically.
    std::size_t kx, ky, kz;
    float ox, oy, oz; ///< origin[kx], origin[ky], origin[kz]
    float sx, sy, sz; ///< d[kx]/d[kz], d[ky]/d[kz], 1/d[kz]

    explicit ShearedRay(const Ray& ray) {
        const std::array<float, 3> o{ray.origin.x, ray.origin.y, ray.origin.z};
        const std::array<float, 3> d{ray.direction.x, ray.direction.y, ray.direction.z};
        const vec3 a = glm::abs(ray.direction);
        kz = a.x >= a.y ? (a.x >= a.z ? 0 : 2) : (a.y >= a.z ? 1 : 2);
        kx = kz == 2 ? 0 : kz + 1;
        ky = kx == 2 ? 0 : kx + 1;
        ox = o[kx];
        oy = o[ky];
        oz = o[kz];
        sx = d[kx] / d[kz];
        sy = d[ky] / d[kz];
        sz = 1.0f / d[kz];
    }
};

/// Three vertices, x y z each.
using TriangleVertices = std::array<std::array<float, 3>, 3>;

/// What the test finds; valid only where it returned true.
struct TriangleHit {
    float t, u, v; ///< u, v: weights of vertices 1 and 2
    bool on_edge;  ///< exactly through an edge or a vertex
    bool positive; ///< the sign of the sheared area: equal for triangles of one facing along one ray
};

/// Is there a sign both above and below zero among the three? NaN has none.
template <class T>
inline bool mixed_signs(T a, T b, T c) {
    return (a < T(0) || b < T(0) || c < T(0)) && (a > T(0) || b > T(0) || c > T(0));
}

/// Hit with tmin < t (in double) and t (rounded to float) <= limit. Both orientations count. A ray with a NaN
/// hits nothing. Edges belong to both their triangles.
inline bool intersect_triangle(const ShearedRay& ray, const TriangleVertices& vertices, float tmin,
                               float limit, TriangleHit& hit) {
    const auto& [v0, v1, v2] = vertices;
    const float a = v0[ray.kz] - ray.oz;
    const float b = v1[ray.kz] - ray.oz;
    const float c = v2[ray.kz] - ray.oz;
    const float ax = (v0[ray.kx] - ray.ox) - ray.sx * a;
    const float ay = (v0[ray.ky] - ray.oy) - ray.sy * a;
    const float bx = (v1[ray.kx] - ray.ox) - ray.sx * b;
    const float by = (v1[ray.ky] - ray.oy) - ray.sy * b;
    const float cx = (v2[ray.kx] - ray.ox) - ray.sx * c;
    const float cy = (v2[ray.ky] - ray.oy) - ray.sy * c;

    // Rounding is monotone: a float difference of products never has the wrong sign, it can only be 0.
    if (mixed_signs(cx * by - cy * bx, ax * cy - ay * cx, bx * ay - by * ax)) return false;

    // Products of floats are exact in double, so that these signs are exact.
    const double u = double(cx) * by - double(cy) * bx;
    const double v = double(ax) * cy - double(ay) * cx;
    const double w = double(bx) * ay - double(by) * ax;
    if (mixed_signs(u, v, w)) return false;
    const double det = u + v + w;
    if (det == 0.0) return false;

    const double az = ray.sz * a;
    const double bz = ray.sz * b;
    const double cz = ray.sz * c;
    const double t = (u * az + v * bz + w * cz) / det;
    hit.t = static_cast<float>(t);
    if (!(t > tmin && hit.t <= limit)) return false;
    hit.u = static_cast<float>(v / det);
    hit.v = static_cast<float>(w / det);
    hit.on_edge = u == 0.0 || v == 0.0 || w == 0.0;
    hit.positive = det > 0.0;
    return true;
}

/// The point with weights u and v of vertices 1 and 2, the normal by the winding. Where the triangle has no
/// area, any unit normal facing `seen_along` (not zero).
ExactPoint triangle_point(const TriangleVertices& vertices, double u, double v, const dvec3& seen_along);

/// A bound, per axis, of what separates `p` (rounded to float) from its triangle, and of what the test of a
/// ray that starts there can displace the triangle by: an origin moved off the plane by it never hits that
/// triangle again. Half a float's spacing of p, and 8 u S of the displacement above, S being the largest
/// |coordinate| of v - p.
vec3 triangle_point_error(const TriangleVertices& vertices, const vec3& p);

} // namespace glint
