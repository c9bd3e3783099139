// The vocabulary of the shared headers (math/shared.h) for vectors of rays, for every SIMD target: namespace
// lanes in single precision, double_lanes in double. A real holds one number for each of several rays, an
// integer one int, a vec3 three reals. Lane by lane all operations have the bits of those on plain numbers,
// of GLM's functions too.

#include "math/shared.h"

#include <concepts>
#include <cstddef>

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

namespace hn = hwy::HWY_NAMESPACE;

template <class Tag>
struct IntegerLanes;
template <class Tag>
struct RealLanes;
template <class Tag>
struct Vec3Lanes;

/// One bool a ray. && and || compute both sides.
template <class Tag>
struct TruthLanes {
    using Integer = IntegerLanes<Tag>;
    using Real = RealLanes<Tag>;
    using Vec3 = Vec3Lanes<Tag>;

    hn::Mask<Tag> m;

    HWY_INLINE TruthLanes(hn::Mask<Tag> x) : m(x) {}

    friend HWY_INLINE TruthLanes operator!(TruthLanes a) { return hn::Not(a.m); }
    friend HWY_INLINE TruthLanes operator&&(TruthLanes a, TruthLanes b) { return hn::And(a.m, b.m); }
    friend HWY_INLINE TruthLanes operator||(TruthLanes a, TruthLanes b) { return hn::Or(a.m, b.m); }
    friend HWY_INLINE bool any_lane(TruthLanes a) { return !hn::AllFalse(Tag(), a.m); }
    friend HWY_INLINE bool all_lanes(TruthLanes a) { return hn::AllTrue(Tag(), a.m); }

    friend HWY_INLINE Integer pick(TruthLanes t, Integer one, Integer other) {
        return hn::IfThenElse(hn::RebindMask(hn::RebindToSigned<Tag>(), t.m), one.v, other.v);
    }
    friend HWY_INLINE Real pick(TruthLanes t, Real one, Real other) {
        return hn::IfThenElse(t.m, one.v, other.v);
    }
    friend HWY_INLINE Vec3 pick(TruthLanes t, const Vec3& one, const Vec3& other) {
        return {pick(t, one.x, other.x), pick(t, one.y, other.y), pick(t, one.z, other.z)};
    }
};

template <class Tag>
struct IntegerLanes {
    using IntegerTag = hn::RebindToSigned<Tag>;
    using Real = RealLanes<Tag>;
    using Truth = TruthLanes<Tag>;

    hn::Vec<IntegerTag> v;

    IntegerLanes() = default;
    HWY_INLINE IntegerLanes(hn::Vec<IntegerTag> x) : v(x) {}
    HWY_INLINE IntegerLanes(std::same_as<int> auto x) : v(hn::Set(IntegerTag(), x)) {}
    HWY_INLINE explicit IntegerLanes(Real x) : v(hn::ConvertTo(IntegerTag(), x.v)) {}

    friend HWY_INLINE IntegerLanes operator+(IntegerLanes a, IntegerLanes b) { return hn::Add(a.v, b.v); }
    friend HWY_INLINE IntegerLanes operator-(IntegerLanes a, IntegerLanes b) { return hn::Sub(a.v, b.v); }
    friend HWY_INLINE IntegerLanes operator&(IntegerLanes a, IntegerLanes b) { return hn::And(a.v, b.v); }
    friend HWY_INLINE IntegerLanes operator|(IntegerLanes a, IntegerLanes b) { return hn::Or(a.v, b.v); }
    friend HWY_INLINE IntegerLanes operator^(IntegerLanes a, IntegerLanes b) { return hn::Xor(a.v, b.v); }
    friend HWY_INLINE IntegerLanes operator<<(IntegerLanes a, int n) { return hn::ShiftLeftSame(a.v, n); }
    friend HWY_INLINE IntegerLanes operator>>(IntegerLanes a, int n) { return hn::ShiftRightSame(a.v, n); }
    friend HWY_INLINE Truth operator==(IntegerLanes a, IntegerLanes b) {
        return hn::RebindMask(Tag(), hn::Eq(a.v, b.v));
    }
    friend HWY_INLINE Real intBitsToFloat(IntegerLanes a) { return hn::BitCast(Tag(), a.v); }
};

template <class Tag>
struct RealLanes {
    using Integer = IntegerLanes<Tag>;
    using Truth = TruthLanes<Tag>;

    hn::Vec<Tag> v;

    RealLanes() = default;
    HWY_INLINE RealLanes(hn::Vec<Tag> x) : v(x) {}
    HWY_INLINE RealLanes(std::same_as<hn::TFromD<Tag>> auto x) : v(hn::Set(Tag(), x)) {}
    HWY_INLINE explicit RealLanes(Integer x) : v(hn::ConvertTo(Tag(), x.v)) {}

    friend HWY_INLINE RealLanes operator-(RealLanes a) { return hn::Neg(a.v); }
    friend HWY_INLINE RealLanes operator+(RealLanes a, RealLanes b) { return hn::Add(a.v, b.v); }
    friend HWY_INLINE RealLanes operator-(RealLanes a, RealLanes b) { return hn::Sub(a.v, b.v); }
    friend HWY_INLINE RealLanes operator*(RealLanes a, RealLanes b) { return hn::Mul(a.v, b.v); }
    friend HWY_INLINE RealLanes operator/(RealLanes a, RealLanes b) { return hn::Div(a.v, b.v); }

    friend HWY_INLINE Truth operator<(RealLanes a, RealLanes b) { return hn::Lt(a.v, b.v); }
    friend HWY_INLINE Truth operator>(RealLanes a, RealLanes b) { return hn::Lt(b.v, a.v); }
    friend HWY_INLINE Truth operator<=(RealLanes a, RealLanes b) { return hn::Le(a.v, b.v); }
    friend HWY_INLINE Truth operator>=(RealLanes a, RealLanes b) { return hn::Le(b.v, a.v); }
    friend HWY_INLINE Truth operator==(RealLanes a, RealLanes b) { return hn::Eq(a.v, b.v); }
    friend HWY_INLINE Truth operator!=(RealLanes a, RealLanes b) { return hn::Ne(a.v, b.v); }

    // For NaN and equal zeros the results of GLM.
    friend HWY_INLINE RealLanes min(RealLanes a, RealLanes b) { return pick(b < a, b, a); }
    friend HWY_INLINE RealLanes max(RealLanes a, RealLanes b) { return pick(a < b, b, a); }
    // The machine's: if one of them is NaN, the result may be either.
    friend HWY_INLINE RealLanes fast_min(RealLanes a, RealLanes b) { return hn::Min(a.v, b.v); }
    friend HWY_INLINE RealLanes fast_max(RealLanes a, RealLanes b) { return hn::Max(a.v, b.v); }
    friend HWY_INLINE RealLanes abs(RealLanes a) { return hn::Abs(a.v); }
    friend HWY_INLINE RealLanes sqrt(RealLanes a) { return hn::Sqrt(a.v); }
    friend HWY_INLINE RealLanes floor(RealLanes a) { return hn::Floor(a.v); }
    friend HWY_INLINE Integer floatBitsToInt(RealLanes a) {
        return hn::BitCast(typename Integer::IntegerTag(), a.v);
    }
};

template <class Tag>
struct Vec3Lanes {
    using Real = RealLanes<Tag>;

    Real x, y, z;

    Vec3Lanes() = default;
    HWY_INLINE explicit Vec3Lanes(Real all) : x(all), y(all), z(all) {}
    HWY_INLINE Vec3Lanes(Real x_, Real y_, Real z_) : x(x_), y(y_), z(z_) {}
    /// The same for all rays.
    HWY_INLINE Vec3Lanes(const glm::vec<3, hn::TFromD<Tag>>& a) : x(a.x), y(a.y), z(a.z) {}

    friend HWY_INLINE Vec3Lanes operator-(const Vec3Lanes& a) { return {-a.x, -a.y, -a.z}; }
    friend HWY_INLINE Vec3Lanes operator+(const Vec3Lanes& a, const Vec3Lanes& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend HWY_INLINE Vec3Lanes operator-(const Vec3Lanes& a, const Vec3Lanes& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend HWY_INLINE Vec3Lanes operator*(const Vec3Lanes& a, const Vec3Lanes& b) {
        return {a.x * b.x, a.y * b.y, a.z * b.z};
    }
    friend HWY_INLINE Vec3Lanes operator*(const Vec3Lanes& a, Real s) { return {a.x * s, a.y * s, a.z * s}; }
    friend HWY_INLINE Vec3Lanes operator/(const Vec3Lanes& a, Real s) { return {a.x / s, a.y / s, a.z / s}; }

    friend HWY_INLINE Vec3Lanes min(const Vec3Lanes& a, const Vec3Lanes& b) {
        return {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)};
    }
    friend HWY_INLINE Vec3Lanes abs(const Vec3Lanes& a) { return {abs(a.x), abs(a.y), abs(a.z)}; }
    friend HWY_INLINE Real dot(const Vec3Lanes& a, const Vec3Lanes& b) {
        return a.x * b.x + a.y * b.y + a.z * b.z;
    }
    friend HWY_INLINE Vec3Lanes cross(const Vec3Lanes& a, const Vec3Lanes& b) {
        return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
    }
    friend HWY_INLINE Vec3Lanes normalize(const Vec3Lanes& a) {
        return a * (Real(hn::TFromD<Tag>(1)) / sqrt(dot(a, a)));
    }
    /// The largest |coordinate|.
    friend HWY_INLINE Real largest(const Vec3Lanes& a) {
        return fast_max(abs(a.x), fast_max(abs(a.y), abs(a.z)));
    }
};

namespace lanes {

using RealTag = hn::CappedTag<float, 16>;
using IntegerTag = hn::RebindToSigned<RealTag>;
inline constexpr std::size_t lane_count = hn::MaxLanes(RealTag());

using truth = TruthLanes<RealTag>;
using integer = IntegerLanes<RealTag>;
using real = RealLanes<RealTag>;
using vec3 = Vec3Lanes<RealTag>;

/// Loads and stores adjacent floats.
HWY_INLINE real load(const float* from) { return hn::LoadU(RealTag(), from); }
HWY_INLINE void store(real x, float* to) { hn::StoreU(x.v, RealTag(), to); }

} // namespace lanes

namespace double_lanes {

using Real64Tag = hn::CappedTag<double, 8>;
inline constexpr std::size_t lane_count = hn::MaxLanes(Real64Tag());

using truth = TruthLanes<Real64Tag>;
using integer = IntegerLanes<Real64Tag>;
using real64 = RealLanes<Real64Tag>;
using dvec3 = Vec3Lanes<Real64Tag>;

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
