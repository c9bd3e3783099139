// The vocabulary of the shared headers in double precision for vectors of rays, for every SIMD target: a
// real64 holds one double for each of several rays, a dvec3 three of them. Lane by lane all operations have
// the bits of those on plain doubles.

#include "math/shared.h"

#include <concepts>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#if defined(GLINT_MATH_DOUBLE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_MATH_DOUBLE_LANES_INL_H
#undef GLINT_MATH_DOUBLE_LANES_INL_H
#else
#define GLINT_MATH_DOUBLE_LANES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {
namespace double_lanes {

namespace hn = hwy::HWY_NAMESPACE;

using Real64Tag = hn::CappedTag<double, 8>;
using Integer64Tag = hn::RebindToSigned<Real64Tag>;
inline constexpr std::size_t lane_count = hn::MaxLanes(Real64Tag());

struct real64 {
    hn::Vec<Real64Tag> v;

    real64() = default;
    HWY_INLINE real64(hn::Vec<Real64Tag> x) : v(x) {}
    HWY_INLINE real64(std::same_as<double> auto x) : v(hn::Set(Real64Tag(), x)) {}

    friend HWY_INLINE real64 operator-(real64 a) { return hn::Neg(a.v); }
    friend HWY_INLINE real64 operator+(real64 a, real64 b) { return hn::Add(a.v, b.v); }
    friend HWY_INLINE real64 operator-(real64 a, real64 b) { return hn::Sub(a.v, b.v); }
    friend HWY_INLINE real64 operator*(real64 a, real64 b) { return hn::Mul(a.v, b.v); }
    friend HWY_INLINE real64 operator/(real64 a, real64 b) { return hn::Div(a.v, b.v); }
};

/// One small integer for each ray: the number of a part or the like.
struct integer {
    hn::Vec<Integer64Tag> v;

    integer() = default;
    HWY_INLINE integer(hn::Vec<Integer64Tag> x) : v(x) {}
    HWY_INLINE integer(std::same_as<int> auto x) : v(hn::Set(Integer64Tag(), x)) {}
};

/// One bool for each ray. && and || compute both sides.
struct truth {
    hn::Mask<Real64Tag> m;

    HWY_INLINE truth(hn::Mask<Real64Tag> x) : m(x) {}

    friend HWY_INLINE truth operator!(truth a) { return hn::Not(a.m); }
    friend HWY_INLINE truth operator&&(truth a, truth b) { return hn::And(a.m, b.m); }
    friend HWY_INLINE truth operator||(truth a, truth b) { return hn::Or(a.m, b.m); }
};

HWY_INLINE truth operator<(real64 a, real64 b) { return hn::Lt(a.v, b.v); }
HWY_INLINE truth operator>(real64 a, real64 b) { return hn::Lt(b.v, a.v); }
HWY_INLINE truth operator<=(real64 a, real64 b) { return hn::Le(a.v, b.v); }
HWY_INLINE truth operator>=(real64 a, real64 b) { return hn::Le(b.v, a.v); }
HWY_INLINE truth operator==(real64 a, real64 b) { return hn::Eq(a.v, b.v); }
HWY_INLINE truth operator!=(real64 a, real64 b) { return hn::Ne(a.v, b.v); }
HWY_INLINE truth operator==(integer a, integer b) { return hn::RebindMask(Real64Tag(), hn::Eq(a.v, b.v)); }
HWY_INLINE bool any_lane(truth t) { return !hn::AllFalse(Real64Tag(), t.m); }
HWY_INLINE bool all_lanes(truth t) { return hn::AllTrue(Real64Tag(), t.m); }

HWY_INLINE real64 pick(truth t, real64 one, real64 other) { return hn::IfThenElse(t.m, one.v, other.v); }
HWY_INLINE integer pick(truth t, integer one, integer other) {
    return hn::IfThenElse(hn::RebindMask(Integer64Tag(), t.m), one.v, other.v);
}

HWY_INLINE real64 abs(real64 a) { return hn::Abs(a.v); }
HWY_INLINE real64 sqrt(real64 a) { return hn::Sqrt(a.v); }
// The machine's own: where one of them is NaN, either may come.
HWY_INLINE real64 lesser(real64 a, real64 b) { return hn::Min(a.v, b.v); }
HWY_INLINE real64 greater(real64 a, real64 b) { return hn::Max(a.v, b.v); }

struct dvec3 {
    real64 x, y, z;

    dvec3() = default;
    HWY_INLINE dvec3(real64 x_, real64 y_, real64 z_) : x(x_), y(y_), z(z_) {}
    HWY_INLINE dvec3(const glm::dvec3& a) : x(a.x), y(a.y), z(a.z) {} ///< the same for all rays

    friend HWY_INLINE dvec3 operator-(const dvec3& a) { return {-a.x, -a.y, -a.z}; }
    friend HWY_INLINE dvec3 operator+(const dvec3& a, const dvec3& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend HWY_INLINE dvec3 operator-(const dvec3& a, const dvec3& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend HWY_INLINE dvec3 operator*(const dvec3& a, real64 s) { return {a.x * s, a.y * s, a.z * s}; }
    friend HWY_INLINE dvec3 operator/(const dvec3& a, real64 s) { return {a.x / s, a.y / s, a.z / s}; }
};

HWY_INLINE dvec3 pick(truth t, const dvec3& one, const dvec3& other) {
    return {pick(t, one.x, other.x), pick(t, one.y, other.y), pick(t, one.z, other.z)};
}
HWY_INLINE dvec3 cross(const dvec3& a, const dvec3& b) {
    return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}
HWY_INLINE real64 dot(const dvec3& a, const dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
/// The largest |coordinate|.
HWY_INLINE real64 largest(const dvec3& a) { return greater(abs(a.x), greater(abs(a.y), abs(a.z))); }
/// m · a.
HWY_INLINE dvec3 transformed(const glm::dmat3& m, const dvec3& a) {
    const auto row = [&](int i) {
        return real64(m[0][i]) * a.x + real64(m[1][i]) * a.y + real64(m[2][i]) * a.z;
    };
    return {row(0), row(1), row(2)};
}

} // namespace double_lanes
} // namespace HWY_NAMESPACE
} // namespace glint
HWY_AFTER_NAMESPACE();

#endif
