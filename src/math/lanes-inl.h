// The vocabulary of the shared headers for vectors of rays, for every SIMD target: a `real` holds one float
// for each of several rays, an `integer` one int, a vec3 three reals. Lane by lane all operations have the
// bits of those on plain floats, of GLM's functions too.

#include "math/shared.h"

#include <concepts>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#if defined(GLINT_MATH_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_MATH_LANES_INL_H
#undef GLINT_MATH_LANES_INL_H
#else
#define GLINT_MATH_LANES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {
namespace lanes {

namespace hn = hwy::HWY_NAMESPACE;

using RealTag = hn::CappedTag<float, 16>;
using IntegerTag = hn::Rebind<std::int32_t, RealTag>;
inline constexpr std::size_t lane_count = hn::MaxLanes(RealTag());

struct integer {
    hn::Vec<IntegerTag> v;

    integer() = default;
    HWY_INLINE integer(hn::Vec<IntegerTag> x) : v(x) {}
    HWY_INLINE integer(std::same_as<int> auto x) : v(hn::Set(IntegerTag(), x)) {}
    template <class Real>
    requires requires(Real r) { hn::ConvertTo(IntegerTag(), r.v); }
    HWY_INLINE explicit integer(Real x) : v(hn::ConvertTo(IntegerTag(), x.v)) {}

    friend HWY_INLINE integer operator+(integer a, integer b) { return hn::Add(a.v, b.v); }
    friend HWY_INLINE integer operator-(integer a, integer b) { return hn::Sub(a.v, b.v); }
    friend HWY_INLINE integer operator&(integer a, integer b) { return hn::And(a.v, b.v); }
    friend HWY_INLINE integer operator|(integer a, integer b) { return hn::Or(a.v, b.v); }
    friend HWY_INLINE integer operator^(integer a, integer b) { return hn::Xor(a.v, b.v); }
    friend HWY_INLINE integer operator<<(integer a, int bits) { return hn::ShiftLeftSame(a.v, bits); }
    friend HWY_INLINE integer operator>>(integer a, int bits) { return hn::ShiftRightSame(a.v, bits); }
};

struct real {
    hn::Vec<RealTag> v;

    real() = default;
    HWY_INLINE real(hn::Vec<RealTag> x) : v(x) {}
    HWY_INLINE real(std::same_as<float> auto x) : v(hn::Set(RealTag(), x)) {}
    HWY_INLINE explicit real(integer x) : v(hn::ConvertTo(RealTag(), x.v)) {}

    friend HWY_INLINE real operator-(real a) { return hn::Neg(a.v); }
    friend HWY_INLINE real operator+(real a, real b) { return hn::Add(a.v, b.v); }
    friend HWY_INLINE real operator-(real a, real b) { return hn::Sub(a.v, b.v); }
    friend HWY_INLINE real operator*(real a, real b) { return hn::Mul(a.v, b.v); }
    friend HWY_INLINE real operator/(real a, real b) { return hn::Div(a.v, b.v); }
};

/// One bool a ray.
struct truth {
    hn::Mask<RealTag> m;

    HWY_INLINE truth(hn::Mask<RealTag> x) : m(x) {}

    friend HWY_INLINE truth operator!(truth a) { return hn::Not(a.m); }
    friend HWY_INLINE truth operator&(truth a, truth b) { return hn::And(a.m, b.m); }
    friend HWY_INLINE truth operator|(truth a, truth b) { return hn::Or(a.m, b.m); }
    // As in text shared with GLSL, but both sides are computed.
    friend HWY_INLINE truth operator&&(truth a, truth b) { return a & b; }
    friend HWY_INLINE truth operator||(truth a, truth b) { return a | b; }
};

HWY_INLINE truth operator<(real a, real b) { return hn::Lt(a.v, b.v); }
HWY_INLINE truth operator>(real a, real b) { return hn::Lt(b.v, a.v); }
HWY_INLINE truth operator<=(real a, real b) { return hn::Le(a.v, b.v); }
HWY_INLINE truth operator>=(real a, real b) { return hn::Le(b.v, a.v); }
HWY_INLINE truth operator==(real a, real b) { return hn::Eq(a.v, b.v); }
HWY_INLINE bool any(truth t) { return !hn::AllFalse(RealTag(), t.m); }
HWY_INLINE bool any_lane(truth t) { return any(t); }

HWY_INLINE real pick(truth t, real one, real other) { return hn::IfThenElse(t.m, one.v, other.v); }
HWY_INLINE integer pick(truth t, integer one, integer other) {
    return hn::IfThenElse(hn::RebindMask(IntegerTag(), t.m), one.v, other.v);
}
HWY_INLINE integer floatBitsToInt(real x) { return hn::BitCast(IntegerTag(), x.v); }
HWY_INLINE real intBitsToFloat(integer x) { return hn::BitCast(RealTag(), x.v); }

// What GLM gives for NaN and equal zeros.
HWY_INLINE real min(real a, real b) { return pick(b < a, b, a); }
HWY_INLINE real max(real a, real b) { return pick(a < b, b, a); }
HWY_INLINE real abs(real a) { return hn::Abs(a.v); }
HWY_INLINE real sqrt(real a) { return hn::Sqrt(a.v); }
HWY_INLINE real floor(real a) { return hn::Floor(a.v); }

struct vec3 {
    real x, y, z;

    vec3() = default;
    HWY_INLINE explicit vec3(real all) : x(all), y(all), z(all) {}
    HWY_INLINE vec3(real x_, real y_, real z_) : x(x_), y(y_), z(z_) {}
    HWY_INLINE explicit vec3(const glm::vec3& a) : x(a.x), y(a.y), z(a.z) {}

    friend HWY_INLINE vec3 operator-(const vec3& a) { return {-a.x, -a.y, -a.z}; }
    friend HWY_INLINE vec3 operator+(const vec3& a, const vec3& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend HWY_INLINE vec3 operator-(const vec3& a, const vec3& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend HWY_INLINE vec3 operator*(const vec3& a, const vec3& b) {
        return {a.x * b.x, a.y * b.y, a.z * b.z};
    }
    friend HWY_INLINE vec3 operator*(const vec3& a, real s) { return {a.x * s, a.y * s, a.z * s}; }
    friend HWY_INLINE vec3 operator/(const vec3& a, real s) { return {a.x / s, a.y / s, a.z / s}; }
};

HWY_INLINE vec3 pick(truth t, const vec3& one, const vec3& other) {
    return {pick(t, one.x, other.x), pick(t, one.y, other.y), pick(t, one.z, other.z)};
}
HWY_INLINE vec3 min(const vec3& a, const vec3& b) { return {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)}; }
HWY_INLINE vec3 abs(const vec3& a) { return {abs(a.x), abs(a.y), abs(a.z)}; }
HWY_INLINE real dot(const vec3& a, const vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
HWY_INLINE vec3 normalize(const vec3& a) { return a * (real(1.0f) / sqrt(dot(a, a))); }

// Loading and storing what lies side by side.

HWY_INLINE real load(const float* from) { return hn::LoadU(RealTag(), from); }
HWY_INLINE void store(real x, float* to) { hn::StoreU(x.v, RealTag(), to); }

} // namespace lanes
} // namespace HWY_NAMESPACE
} // namespace glint
HWY_AFTER_NAMESPACE();

#endif
