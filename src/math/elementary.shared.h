#ifndef GLINT_MATH_ELEMENTARY_SHARED_H
#define GLINT_MATH_ELEMENTARY_SHARED_H
#include "math/shared.h"

// log2, exp2 and functions derived from them in float, from + - * / and floor only: results of the C library
// vary between machines.

GLINT_SHARED_BEGIN

/// log2 x for finite x > 0. Relative error below 4e-7 everywhere, also near x = 1: the mantissa m is brought
/// into [√½, √2), and log m = 2 atanh((m − 1)/(m + 1)) is summed as an odd series, in which m − 1 is exact.
GLINT_FN real log2_of(real x) {
    real scale = pick(x < 1.17549435e-38f, -24.0f, 0.0f);
    integer bits = floatBitsToInt(pick(x < 1.17549435e-38f, x * 16777216.0f, x));
    integer exponent = (bits >> 23) - 127;
    real m = intBitsToFloat((bits & 0x007fffff) | 0x3f800000);
    exponent = pick(m > 1.41421356f, exponent + 1, exponent);
    m = pick(m > 1.41421356f, m * 0.5f, m);
    real s = (m - 1.0f) / (m + 1.0f);
    real z = s * s;
    real series = 1.0f / 11.0f;
    series = series * z + 1.0f / 9.0f;
    series = series * z + 1.0f / 7.0f;
    series = series * z + 1.0f / 5.0f;
    series = series * z + 1.0f / 3.0f;
    real ln_m = 2.0f * s + 2.0f * s * z * series;
    return (real(exponent) + scale) + ln_m * 1.44269504f;
}

/// 2^x; 0 below −149, infinite from 128 on. The fraction in [−½, ½] is evaluated by the exponential series.
GLINT_FN real exp2_of(real power) {
    real x = pick(power > -150.0f, pick(power < 128.0f, power, 128.0f), -150.0f);
    real rounded = floor(x + 0.5f);
    real f = (x - rounded) * 0.693147181f;
    real series = 1.0f / 5040.0f;
    series = series * f + 1.0f / 720.0f;
    series = series * f + 1.0f / 120.0f;
    series = series * f + 1.0f / 24.0f;
    series = series * f + 1.0f / 6.0f;
    series = series * f + 0.5f;
    series = series * f + 1.0f;
    series = series * f + 1.0f;
    // Scale by two factors, so that subnormal results are rounded once, by the last product.
    integer e = integer(rounded);
    integer first = e >> 1;
    real a = intBitsToFloat((first + 127) << 23);
    real b = intBitsToFloat((e - first + 127) << 23);
    real result = series * a * b;
    return pick(power >= 128.0f, intBitsToFloat(0x7f800000), pick(power > -150.0f, result, 0.0f));
}

/// e^x.
GLINT_FN real exp_of(real x) { return exp2_of(x * 1.44269504f); }

/// x^y for x ≥ 0, y ≥ 0; 0^0 = 1.
GLINT_FN real pow_of(real x, real y) {
    real power = exp2_of(y * log2_of(x));
    return pick(y == 0.0f, 1.0f, pick(x <= 0.0f, 0.0f, power));
}

/// The angle in 0 … π of the vector (x, y) to +x, for y ≥ 0; 0 for the zero vector. Error below 4e-7. The odd
/// series of atan, within a quarter of a right angle of the nearest axis or diagonal.
GLINT_FN real angle_of(real x, real y) {
    real across = abs(x);
    real low = min(across, y);
    real high = max(across, y);
    real ratio = pick(high > 0.0f, low / pick(high > 0.0f, high, 1.0f), 0.0f);
    truth steep = ratio > 0.414213562f; // tan π/8
    real t = pick(steep, (ratio - 1.0f) / (ratio + 1.0f), ratio);
    real z = t * t;
    real series = -1.0f / 15.0f;
    series = series * z + 1.0f / 13.0f;
    series = series * z - 1.0f / 11.0f;
    series = series * z + 1.0f / 9.0f;
    series = series * z - 1.0f / 7.0f;
    series = series * z + 1.0f / 5.0f;
    series = series * z - 1.0f / 3.0f;
    real angle = pick(steep, 0.785398163f, 0.0f) + (t + t * z * series);
    angle = pick(y > across, 1.57079633f - angle, angle);
    return pick(x < 0.0f, 3.14159265f - angle, angle);
}

GLINT_SHARED_END
#endif
