#pragma once
// What lets one header be C++ and GLSL 4.5 alike. A shared header (*.shared.h) holds plain functions over
// float, int, uint, bool, vectors and structs of these: no namespaces but GLINT_SHARED_BEGIN/END, no
// references but GLINT_IN (a struct that is read) and GLINT_OUT, no templates, no recursion, no default
// member values, constructors in the form T(a, b), float literals with the suffix f, and none of GLSL's
// reserved words as names (sample, input, output, half, active, common, partition, smooth, flat, precise …).
// Only + - * / sqrt floor reach the machine: everything else is computed by ourselves, with the same bits
// anywhere. GLINT_PRECISE marks values that a shader's compiler must not fuse.
//
// What differs from ray to ray is `real`, `integer`, `truth` or vec3, in double `real64` or dvec3, and
// choices between such values are made by pick(condition, one, other), which computes both: so the same
// functions serve vectors of rays (math/lanes-inl.h in single precision, math/double_lanes-inl.h in double).
// There a `real` holds one float for each of several rays. any_lane(t) lets a function return early where a
// truth holds for none of them. What is the same for all rays of a vector (a light, a shape) is float,
// double, int or bool, and `if` may ask for it; where the rays are vectors, GLINT_LANES is defined.

#ifndef GLINT_GLSL

#include "math/vec.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#define GLINT_SHARED_BEGIN namespace glint {
#define GLINT_SHARED_END }
#define GLINT_FN inline
#define GLINT_IN(type) const type&
#define GLINT_OUT(type) type&
#define GLINT_PRECISE

namespace glint {

using uint = std::uint32_t;
using real = float;
using real64 = double;
using integer = int;
using truth = bool;
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
inline double pick(bool condition, double one, double other) { return condition ? one : other; }
inline vec3 pick(bool condition, const vec3& one, const vec3& other) { return condition ? one : other; }
inline dvec3 pick(bool condition, const dvec3& one, const dvec3& other) { return condition ? one : other; }

/// Does it hold for any ray of a vector? For one ray: for that.
inline bool any_lane(bool t) { return t; }

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
#define GLINT_IN(type) type
#define GLINT_OUT(type) out type
#define real float
#define real64 double
#define integer int
#define truth bool
#define pick(condition, one, other) ((condition) ? (one) : (other))
#define any_lane(t) (t)
#define GLINT_PRECISE precise

double infinite_double() { return packDouble2x32(uvec2(0u, 0x7ff00000u)); }

#endif
