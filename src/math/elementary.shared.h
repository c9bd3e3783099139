#ifndef GLINT_MATH_ELEMENTARY_SHARED_H
#define GLINT_MATH_ELEMENTARY_SHARED_H
#include "math/shared.h"

// log2, exp2 and what follows from them, in float, from + - * / floor alone: the C library's change with the
// CPU.

GLINT_SHARED_BEGIN

/// log2 x for finite x > 0. Relative error below 4e-7 everywhere, near x = 1 too: the mantissa is brought
/// into [√½, √2) and log m = 2 atanh((m − 1)/(m + 1)) is summed as an odd series, in which m − 1 is exact.
GLINT_FN float log2_of(float x) {
    float scale = 0.0f;
    if (x < 1.17549435e-38f) {
        x = x * 16777216.0f;
        scale = -24.0f;
    }
    int bits = floatBitsToInt(x);
    int exponent = (bits >> 23) - 127;
    float m = intBitsToFloat((bits & 0x007fffff) | 0x3f800000);
    if (m > 1.41421356f) {
        m = m * 0.5f;
        exponent = exponent + 1;
    }
    float s = (m - 1.0f) / (m + 1.0f);
    float z = s * s;
    float series = 1.0f / 11.0f;
    series = series * z + 1.0f / 9.0f;
    series = series * z + 1.0f / 7.0f;
    series = series * z + 1.0f / 5.0f;
    series = series * z + 1.0f / 3.0f;
    float ln_m = 2.0f * s + 2.0f * s * z * series;
    return (float(exponent) + scale) + ln_m * 1.44269504f;
}

/// 2^x; 0 below −149, infinite from 128. The fraction in [−½, ½] goes through the exponential series.
GLINT_FN float exp2_of(float x) {
    if (x >= 128.0f) return intBitsToFloat(0x7f800000);
    if (!(x > -150.0f)) return 0.0f;
    float whole = floor(x + 0.5f);
    float f = (x - whole) * 0.693147181f;
    float series = 1.0f / 5040.0f;
    series = series * f + 1.0f / 720.0f;
    series = series * f + 1.0f / 120.0f;
    series = series * f + 1.0f / 24.0f;
    series = series * f + 1.0f / 6.0f;
    series = series * f + 0.5f;
    series = series * f + 1.0f;
    series = series * f + 1.0f;
    // Two factors, so that results below the normal range are rounded once, by the last product.
    int e = int(whole);
    int first = e / 2;
    float a = intBitsToFloat((first + 127) << 23);
    float b = intBitsToFloat((e - first + 127) << 23);
    return series * a * b;
}

/// e^x.
GLINT_FN float exp_of(float x) { return exp2_of(x * 1.44269504f); }

/// x^y for x ≥ 0, y ≥ 0; 0^0 = 1.
GLINT_FN float pow_of(float x, float y) {
    if (y == 0.0f) return 1.0f;
    if (x <= 0.0f) return 0.0f;
    return exp2_of(y * log2_of(x));
}

GLINT_SHARED_END
#endif
