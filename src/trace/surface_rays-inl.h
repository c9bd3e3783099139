// Rays in double side by side, as many as fit into a vector, and where they are inside a ball; for every SIMD
// target. The bits are those of geometry/quadric.h.

#include "trace/world_data.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include <hwy/highway.h>

#if defined(GLINT_TRACE_SURFACE_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SURFACE_RAYS_INL_H
#undef GLINT_TRACE_SURFACE_RAYS_INL_H
#else
#define GLINT_TRACE_SURFACE_RAYS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

const hn::CappedTag<double, 8> dd;
const hn::Rebind<float, decltype(dd)> df;
using Doubles = hn::Vec<decltype(dd)>;
using Mask = hn::Mask<decltype(dd)>;
constexpr std::size_t lanes = hn::MaxLanes(dd);

HWY_INLINE Doubles all(double x) { return hn::Set(dd, x); }
HWY_INLINE Doubles rounded(Doubles x) {
    const Doubles finite = hn::PromoteTo(dd, hn::DemoteTo(df, x));
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128
    // What rounds to infinity: without the machine's vectors Highway would take it to the greatest float.
    const Mask infinite = hn::Ge(hn::Abs(x), all(0x1.ffffffp127));
    return hn::IfThenElse(infinite, hn::Mul(x, all(std::numeric_limits<double>::infinity())), finite);
#else
    return finite;
#endif
}

struct Vec {
    Doubles x, y, z;
};

HWY_INLINE Vec all(const dvec3& v) { return {all(v.x), all(v.y), all(v.z)}; }
HWY_INLINE Vec operator+(const Vec& a, const Vec& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Vec operator-(const Vec& a, const Vec& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Vec operator*(const Vec& a, Doubles s) {
    return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}
HWY_INLINE Doubles dot(const Vec& a, const Vec& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Vec transformed(const dmat3& m, const Vec& v) {
    const auto row = [&](int i) {
        return hn::Add(hn::Add(hn::Mul(all(m[0][i]), v.x), hn::Mul(all(m[1][i]), v.y)),
                       hn::Mul(all(m[2][i]), v.z));
    };
    return {row(0), row(1), row(2)};
}

struct Lines {
    Vec origin, direction;
};

#if HWY_TARGET != HWY_SCALAR
/// Two floats of each ray.
const hn::Twice<decltype(df)> halves;
using Halves = hn::Vec<decltype(halves)>;
#endif

/// Rays side by side, as they are.
struct LoadedRays {
    Lines line;
    Doubles tmin, tmax;

#if HWY_TARGET == HWY_SCALAR
    HWY_INLINE explicit LoadedRays(const Ray* ray) {
        line = {all(dvec3(ray->origin)), all(dvec3(ray->direction))};
        tmin = all(double(ray->tmin));
        tmax = all(double(ray->tmax));
    }
#else
    // Of each ray there are two groups of four numbers: origin and tmin, direction and tmax.
    HWY_INLINE explicit LoadedRays(const Ray* rays) {
        Halves x, y, z, t;
        hn::LoadInterleaved4(halves, &rays->origin.x, x, y, z, t);
        line = {{first(x), first(y), first(z)}, {second(x), second(y), second(z)}};
        tmin = first(t);
        tmax = second(t);
    }

  private:
    static HWY_INLINE Doubles first(Halves v) {
        return hn::PromoteTo(dd, hn::LowerHalf(df, hn::ConcatEven(halves, v, v)));
    }
    static HWY_INLINE Doubles second(Halves v) {
        return hn::PromoteTo(dd, hn::LowerHalf(df, hn::ConcatOdd(halves, v, v)));
    }
#endif
};

/// Rays side by side, to be traced. One that can hit nothing has an empty interval.
struct Rays : LoadedRays {
    // A hit has tmin < t, and t < tmax when it is rounded.
    HWY_INLINE explicit Rays(const Ray* rays) : LoadedRays(rays) {
        // Each product is 0, or NaN where a value is not finite.
        const Doubles zero = hn::Zero(dd);
        const Vec none = line.origin * zero + line.direction * zero;
        const Vec& d = line.direction;
        const Doubles most = hn::Max(hn::Abs(d.x), hn::Max(hn::Abs(d.y), hn::Abs(d.z)));
        const Mask traceable =
            hn::And(hn::Eq(hn::Add(none.x, hn::Add(none.y, none.z)), zero), hn::Gt(most, zero));
        tmax = hn::IfThenElse(traceable, tmax, all(-std::numeric_limits<double>::infinity()));
    }
};

/// Where lines are inside a convex solid, and which are.
struct Inside {
    Doubles enter, leave;
    Mask met;
};

/// line_in_ball of geometry/quadric.shared.h. False if all lines miss.
HWY_INLINE bool in_ball(const Vec& f, const Vec& d, double radius, Inside& in) {
    const Doubles zero = hn::Zero(dd);
    const Doubles squared = all(radius * radius);
    const Doubles a = dot(d, d);
    const Doubles b = hn::Neg(dot(f, d));
    const Vec nearest = f + d * hn::Div(b, a);
    const Doubles delta = hn::Sub(squared, dot(nearest, nearest));
    const Mask still = hn::Eq(a, zero);
    const Doubles ff = dot(f, f);
    in.met = hn::Or(hn::And(still, hn::Le(ff, squared)), hn::AndNot(still, hn::Ge(delta, zero)));
    if (hn::AllFalse(dd, in.met)) return false;

    const Doubles root = hn::Sqrt(hn::Mul(a, delta));
    const Doubles q = hn::IfThenElse(hn::Ge(b, zero), hn::Add(b, root), hn::Sub(b, root));
    const Doubles one = hn::Div(q, a);
    const Doubles other = hn::IfThenElse(hn::Eq(q, zero), zero, hn::Div(hn::Sub(ff, squared), q));
    const Mask ordered = hn::Lt(one, other);
    const Doubles infinity = all(std::numeric_limits<double>::infinity());
    in.enter = hn::IfThenElse(still, hn::Sub(zero, infinity), hn::IfThenElse(ordered, one, other));
    in.leave = hn::IfThenElse(still, infinity, hn::IfThenElse(ordered, other, one));
    return true;
}

/// Calls use(first, count, rays) for each vector of rays; the last ray fills what is left of the last vector.
template <class Use>
HWY_INLINE void for_vectors(const Ray* rays, std::size_t count, Use&& use) {
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) use(i, lanes, rays + i);
    if (i == count) return;
    Ray last[lanes];
    for (std::size_t k = 0; k < lanes; ++k) last[k] = rays[std::min(i + k, count - 1)];
    use(i, count - i, last);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace glint
HWY_AFTER_NAMESPACE();

#endif
