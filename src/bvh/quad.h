#pragma once
// Four floats in one register, as g++ and clang++ have them on every machine: the boxes of builders.

#include "math/bounds.h"

#include <cstdint>
#include <limits>

namespace glint {

using Quad = float __attribute__((vector_size(16)));
using QuadInts = std::int32_t __attribute__((vector_size(16)));

inline Quad lesser(Quad a, Quad b) { return a < b ? a : b; }
inline Quad greater(Quad a, Quad b) { return a > b ? a : b; }
inline Quad quad(float x) { return Quad{x, x, x, x}; }
inline Quad quad(const vec3& v) { return Quad{v.x, v.y, v.z, 0.0f}; }
/// The first three, the fourth 0.
inline Quad without_last(Quad q) { return Quad(QuadInts(q) & QuadInts{-1, -1, -1, 0}); }
inline vec3 vector(Quad q) { return {q[0], q[1], q[2]}; }

/// An axis-aligned box in lanes 0 to 2; what stands in lane 3 means nothing. Empty when made.
struct QuadBox {
    Quad lo = quad(std::numeric_limits<float>::infinity());
    Quad hi = quad(-std::numeric_limits<float>::infinity());

    void grow(const QuadBox& b) {
        lo = lesser(lo, b.lo);
        hi = greater(hi, b.hi);
    }
    void grow(Quad p) {
        lo = lesser(lo, p);
        hi = greater(hi, p);
    }
    void intersect(const QuadBox& b) {
        lo = greater(lo, b.lo);
        hi = lesser(hi, b.hi);
    }
    Bounds bounds() const { return {vector(lo), vector(hi)}; }
};

/// Half the surface of a box, its coordinates multiplied by `scale`: a power of two that keeps sides and
/// products finite. Lane 3 is cleared first: small integers there, as Ref has them, are denormal floats,
/// whose products take some processors a hundred cycles.
inline float half_area(const QuadBox& box, float scale) {
    const Quad d = without_last(box.hi) * quad(scale) - without_last(box.lo) * quad(scale);
    return d[0] * d[1] + (d[0] + d[1]) * d[2];
}

/// The power of two that makes a box's coordinates about 1.
float area_scale(const QuadBox& box);

} // namespace glint
