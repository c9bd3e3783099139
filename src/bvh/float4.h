#pragma once
// Two or four floats in one register (vector extension of g++ and clang++), and boxes made of four, for
// builders.

#include "math/bounds.h"

#include <cstdint>
#include <limits>

namespace glint::bvh {

using float2 = float __attribute__((vector_size(8)));
using float4 = float __attribute__((vector_size(16)));
using int4 = std::int32_t __attribute__((vector_size(16)));

inline float4 min4(float4 a, float4 b) { return a < b ? a : b; }
inline float4 max4(float4 a, float4 b) { return a > b ? a : b; }
inline float4 splat(float x) { return float4{x, x, x, x}; }
inline float4 to_float4(const vec3& v) { return float4{v.x, v.y, v.z, 0.0f}; }
/// Clears lane 3.
inline float4 without_w(float4 q) { return float4(int4(q) & int4{-1, -1, -1, 0}); }
inline vec3 to_vec3(float4 q) { return {q[0], q[1], q[2]}; }

/// An axis-aligned box in lanes 0 to 2; lane 3 is ignored. Initially empty.
struct SimdBounds {
    float4 lo = splat(std::numeric_limits<float>::infinity());
    float4 hi = splat(-std::numeric_limits<float>::infinity());

    void grow(const SimdBounds& b) {
        lo = min4(lo, b.lo);
        hi = max4(hi, b.hi);
    }
    void grow(float4 p) {
        lo = min4(lo, p);
        hi = max4(hi, p);
    }
    void intersect(const SimdBounds& b) {
        lo = max4(lo, b.lo);
        hi = min4(hi, b.hi);
    }
    Bounds bounds() const { return {to_vec3(lo), to_vec3(hi)}; }
};

/// Half the surface area of a box whose coordinates are multiplied by `scale`, a power of two that keeps
/// sides and products finite. Clears lane 3 first: a PrimRef stores a small integer there, which is a
/// denormal float, and multiplying denormals takes a hundred cycles on some processors.
inline float half_area(const SimdBounds& box, float scale) {
    const float4 d = without_w(box.hi) * splat(scale) - without_w(box.lo) * splat(scale);
    return d[0] * d[1] + (d[0] + d[1]) * d[2];
}

/// The power of two that scales a box's largest coordinate to about 1.
float area_scale(const SimdBounds& box);

} // namespace glint::bvh
