#pragma once
// What lets one header be C++ and GLSL 4.5 alike. A shared header (*.shared.h) holds plain functions over
// float, int, uint, bool and vectors: no namespaces but GLINT_SHARED_BEGIN/END, no references but GLINT_OUT,
// no templates, no recursion, constructors in the form T(a, b), float literals with the suffix f, and none of
// GLSL's reserved words as names (sample, input, output, half, active, common, partition, smooth, flat,
// precise …). Only + - * / sqrt floor reach the machine: everything else is computed by ourselves, with the
// same bits anywhere.

#ifndef GLINT_GLSL

#include "math/vec.h"

#include <cmath>
#include <cstdint>
#include <cstring>

#define GLINT_SHARED_BEGIN namespace glint {
#define GLINT_SHARED_END }
#define GLINT_FN inline
#define GLINT_OUT(type) type&

namespace glint {

using uint = std::uint32_t;
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

} // namespace glint

#else

#define GLINT_SHARED_BEGIN
#define GLINT_SHARED_END
#define GLINT_FN
#define GLINT_OUT(type) out type

#endif
