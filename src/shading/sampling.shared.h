#ifndef GLINT_SHADING_SAMPLING_SHARED_H
#define GLINT_SHADING_SAMPLING_SHARED_H
#include "math/shared.h"

// Directions from pairs of random numbers in [0, 1), without rejection.

GLINT_SHARED_BEGIN

/// sin x for |x| ≤ π/4, by its series; relative error below 2^-23.
GLINT_FN real sin_of_eighth(real x) {
    real y = x * x;
    return x *
           (1.0f - y * (1.0f / 6.0f - y * (1.0f / 120.0f - y * (1.0f / 5040.0f - y * (1.0f / 362880.0f)))));
}

/// cos x for |x| ≤ π/4, by its series; error below 2^-24.
GLINT_FN real cos_of_eighth(real x) {
    real y = x * x;
    return 1.0f - y * (0.5f - y * (1.0f / 24.0f - y * (1.0f / 720.0f - y * (1.0f / 40320.0f))));
}

/// Cosine and sine of an angle in 0 … 2π, error below 2e-7.
GLINT_FN vec2 cos_sin_of(real angle) {
    real quarter = floor(angle * 0.636619772f + 0.5f);
    real rest = angle - quarter * 1.57079633f;
    vec2 at = vec2(cos_of_eighth(rest), sin_of_eighth(rest));
    real odd = quarter - 2.0f * floor(quarter * 0.5f);
    vec2 turned = odd == 1.0f ? vec2(-at.y, at.x) : at;
    return quarter >= 2.0f && quarter < 4.0f ? -turned : turned;
}

/// A point of the unit disk, z = 0, uniform by area. Concentric squares become concentric circles. (P.
/// Shirley and K. Chiu, "A Low Distortion Map Between Disk and Square", Journal of Graphics Tools 2 (3),
/// 1997.)
GLINT_FN vec3 disk_sample(real u, real v) {
    real a = 2.0f * u - 1.0f;
    real b = 2.0f * v - 1.0f;
    truth wide = abs(a) > abs(b);
    real radius = pick(wide, a, b);
    real other = pick(wide, b, a);
    real angle = pick(radius == 0.0f, 0.0f, other / pick(radius == 0.0f, 1.0f, radius)) * 0.785398163f; // π/4
    real along = radius * cos_of_eighth(angle);
    real across = radius * sin_of_eighth(angle);
    return vec3(pick(wide, along, across), pick(wide, across, along), 0.0f);
}

/// A unit direction of the hemisphere about +z with density cos θ / π. (Malley's method.)
GLINT_FN vec3 cosine_sample(real u, real v) {
    vec3 p = disk_sample(u, v);
    return vec3(p.x, p.y, sqrt(max(0.0f, 1.0f - p.x * p.x - p.y * p.y)));
}

/// An orthonormal basis.
struct Basis {
    vec3 s;
    vec3 t;
    vec3 n;
};

/// About the unit vector n. (T. Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6 (1), 2017.)
GLINT_FN Basis basis_about(vec3 n) {
    real sign = pick(n.z < 0.0f, -1.0f, 1.0f);
    real a = -1.0f / (sign + n.z);
    real b = n.x * n.y * a;
    Basis basis;
    basis.s = vec3(1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x);
    basis.t = vec3(b, sign + n.y * n.y * a, -n.y);
    basis.n = n;
    return basis;
}

GLINT_FN vec3 from_basis(GLINT_IN(Basis) basis, vec3 d) {
    return basis.s * d.x + basis.t * d.y + basis.n * d.z;
}

GLINT_FN vec3 to_basis(GLINT_IN(Basis) basis, vec3 d) {
    return vec3(dot(basis.s, d), dot(basis.t, d), dot(basis.n, d));
}

/// A direction given about +z, turned to be about the unit vector n.
GLINT_FN vec3 turned_to(vec3 n, vec3 d) { return from_basis(basis_about(n), d); }

GLINT_SHARED_END
#endif
