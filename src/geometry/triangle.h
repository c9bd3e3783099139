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
// Boxes must be conservative (bvh/traverse.h) and spawned rays be offset (error_of_triangle) against that.
//
// Wide triangles, whose errors would exceed those of points near them by far, are sheared in double too. The
// displacement is then a few units of 2^-53 S. Edge functions of neighbours are opposite numbers, and never
// have the wrong sign, so the test is as watertight.

#include "geometry/triangle.shared.h"
#include "math/ray.h"
#include "math/vec.h"

#include <array>
#include <cstddef>

namespace glint::geometry {

/// Per-ray constants of the triangle test. The direction must be finite and not zero.
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

/// The same for wide triangles, in double.
struct DoubleShearedRay {
    std::size_t kx, ky, kz;
    dvec3 origin; ///< permuted
    dvec3 shear;

    explicit DoubleShearedRay(const Ray& ray) {
        const ShearedRay in_float(ray);
        kx = in_float.kx;
        ky = in_float.ky;
        kz = in_float.kz;
        const std::array<float, 3> d{ray.direction.x, ray.direction.y, ray.direction.z};
        const double dz = d[kz];
        origin = dvec3(in_float.ox, in_float.oy, in_float.oz);
        shear = dvec3(d[kx] / dz, d[ky] / dz, 1.0 / dz);
    }
};

/// Three vertices, x y z each.
using TriangleVertices = std::array<std::array<float, 3>, 3>;

inline ShearedVertex shear(const ShearedRay& ray, const std::array<float, 3>& v) {
    const float z = v[ray.kz] - ray.oz;
    return {(v[ray.kx] - ray.ox) - ray.sx * z, (v[ray.ky] - ray.oy) - ray.sy * z, z};
}

/// Hit with tmin < t (in double) and t (rounded to float) <= limit, from either side. A ray with a NaN hits
/// nothing. Edges belong to both adjacent triangles.
inline bool intersect_triangle(const ShearedRay& ray, const TriangleVertices& vertices, float tmin,
                               float limit, TriangleHit& hit) {
    const ShearedVertex a = shear(ray, vertices[0]);
    const ShearedVertex b = shear(ray, vertices[1]);
    const ShearedVertex c = shear(ray, vertices[2]);
    return !surely_outside(a, b, c) && intersect_sheared(a, b, c, ray.sz, tmin, limit, hit);
}

inline dvec3 shear(const DoubleShearedRay& ray, const std::array<float, 3>& v) {
    return sheared_in_double(dvec3(v[ray.kx], v[ray.ky], v[ray.kz]) - ray.origin, ray.shear);
}

inline bool intersect_triangle(const DoubleShearedRay& ray, const TriangleVertices& vertices, float tmin,
                               float limit, TriangleHit& hit) {
    return intersect_in_double(shear(ray, vertices[0]), shear(ray, vertices[1]), shear(ray, vertices[2]),
                               tmin, limit, hit);
}

} // namespace glint::geometry
