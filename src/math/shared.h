#pragma once
// Makes a header compile both as C++ and as GLSL 4.5. A shared header (*.shared.h) holds plain functions over
// float, int, uint, bool, vectors and structs of these: no namespaces but GLINT_SHARED_BEGIN/END, no
// references but GLINT_IN (a struct that is read) and GLINT_OUT, no templates, no recursion, no default
// member values, constructors in the form T(a, b), float literals with the suffix f, and none of GLSL's
// reserved words as names (sample, input, output, half, active, common, partition, smooth, flat, precise …).
// Only + - * / sqrt and floor of the machine are used, so that results have the same bits everywhere.
// GLINT_PRECISE marks values that a shader's compiler must not fuse.
//
// Values that differ between rays have the types real, integer, truth and vec3, in double real64 and dvec3.
// pick(condition, one, other) chooses between such values and computes both. So the same functions can be
// compiled for vectors of rays (math/lanes-inl.h), where a real holds one float for each ray, with
// GLINT_LANES defined. any_lane(t) lets a function return early if t holds for no ray. Values that are the
// same for all rays of a vector (of a light, a shape) are float, double, int or bool, and `if` may depend on
// them.

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

/// `one` if the condition holds, otherwise `other`.
inline float pick(bool condition, float one, float other) { return condition ? one : other; }
inline int pick(bool condition, int one, int other) { return condition ? one : other; }
inline double pick(bool condition, double one, double other) { return condition ? one : other; }
inline vec3 pick(bool condition, const vec3& one, const vec3& other) { return condition ? one : other; }
inline dvec3 pick(bool condition, const dvec3& one, const dvec3& other) { return condition ? one : other; }

/// Whether t holds for any ray of a vector.
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
