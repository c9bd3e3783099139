#ifndef GLINT_MATH_OFFSET_SHARED_H
#define GLINT_MATH_OFFSET_SHARED_H
#include "math/shared.h"

GLINT_SHARED_BEGIN

/// The next float from x in the direction of the sign of `toward`; from 0, the smallest subnormal.
GLINT_FN real next_float(real x, real toward) {
    // +1 away from 0, −1 toward it, computed from signs without an unpredictable branch.
    integer bits = floatBitsToInt(x);
    integer step = 1 | ((bits ^ floatBitsToInt(toward)) >> 31);
    integer smallest = pick(toward > 0.0f, 1, int(0x80000001u));
    return intBitsToFloat(pick(x == 0.0f, smallest, bits + step));
}

/// The next float from x in the direction of w; x if w is 0.
GLINT_FN real step_toward(real x, real w) { return pick(w == 0.0f, x, next_float(x, w)); }

/// Origin of a ray leaving p in direction w (any length): on w's side of the surface with unit normal n,
/// beyond the error bound of p. All lengths in one unit. After Pharr, Jakob, Humphreys, "Physically Based
/// Rendering", section 6.8.6.
GLINT_FN vec3 offset_ray_origin(vec3 p, vec3 p_error, vec3 n, vec3 w) {
    real distance = dot(abs(n), p_error);
    vec3 shift = n * pick(dot(n, w) < 0.0f, -distance, distance);
    vec3 origin = p + shift;
    return vec3(step_toward(origin.x, shift.x), step_toward(origin.y, shift.y),
                step_toward(origin.z, shift.z));
}

GLINT_SHARED_END
#endif
