#pragma once
// What lets one header be C++ and GLSL 4.5 alike. A shared header (*.shared.h) holds plain functions over
// float, int, uint, bool and vectors: no namespaces but GLINT_SHARED_BEGIN/END, no references but GLINT_OUT,
// no templates, no recursion, constructors in the form T(a, b), float literals with the suffix f, and none of
// GLSL's reserved words as names (sample, input, output, half, active, common, partition, smooth, flat,
// precise …). Only + - * / sqrt floor reach the machine: everything else is computed by ourselves, with the
// same bits anywhere. GLINT_PRECISE marks values that a shader's compiler must not fuse.
//
// What differs from ray to ray is `real`, `integer` or vec3, and choices between such values are made by
// pick(condition, one, other), which computes both: so the same functions serve vectors of rays
// (math/lanes-inl.h). There a `real` holds one float for each of several rays.

#ifndef GLINT_GLSL

#include "math/vec.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#define GLINT_SHARED_BEGIN namespace glint {
#define GLINT_SHARED_END }
#define GLINT_FN inline
#define GLINT_OUT(type) type&
#define GLINT_PRECISE

namespace glint {

using uint = std::uint32_t;
using real = float;
using integer = int;
using glm::abs;
using glm::clamp;
using glm::cross;
using glm::dot;
using glm::floor;
using glm::length;
using glm::max;
using glm::min;
using glm::normalize;
using std::sqrt;

/// `one` where the condition holds, else `other`.
inline float pick(bool condition, float one, float other) { return condition ? one : other; }
inline int pick(bool condition, int one, int other) { return condition ? one : other; }
inline vec3 pick(bool condition, const vec3& one, const vec3& other) { return condition ? one : other; }

inline int floatBitsToInt(float x) {
    int bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}
inline float intBitsToFloat(int bits) {
    float x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}
inline double infinite_double() { return std::numeric_limits<double>::infinity(); }

} // namespace glint

#else

#define GLINT_SHARED_BEGIN
#define GLINT_SHARED_END
#define GLINT_FN
#define GLINT_OUT(type) out type
#define real float
#define integer int
#define pick(condition, one, other) ((condition) ? (one) : (other))
#define GLINT_PRECISE precise

double infinite_double() { return packDouble2x32(uvec2(0u, 0x7ff00000u)); }

#endif
