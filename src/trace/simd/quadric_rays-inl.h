// Vectors of rays in double for every SIMD target.

#include "trace/world/data.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include <hwy/highway.h>

#include "trace/simd/quadric_lanes-inl.h"

#if defined(GLINT_TRACE_SIMD_QUADRIC_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SIMD_QUADRIC_RAYS_INL_H
#undef GLINT_TRACE_SIMD_QUADRIC_RAYS_INL_H
#else
#define GLINT_TRACE_SIMD_QUADRIC_RAYS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace glint::trace {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using namespace glint::HWY_NAMESPACE::double_lanes;
using glint::HWY_NAMESPACE::double_lanes::real64;
using glint::HWY_NAMESPACE::double_lanes::SolidSpan;
using glint::HWY_NAMESPACE::double_lanes::truth;
using Vec = glint::HWY_NAMESPACE::double_lanes::dvec3;

const Real64Tag dd;
const hn::Rebind<float, decltype(dd)> df;
constexpr std::size_t lanes = lane_count;
constexpr double infinity = std::numeric_limits<double>::infinity();

HWY_INLINE real64 rounded(real64 x) {
    const real64 finite = hn::PromoteTo(dd, hn::DemoteTo(df, x.v));
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128
    // Values that round to infinity: without SIMD Highway converts them to the largest float.
    return pick(abs(x) >= 0x1.ffffffp127, x * infinity, finite);
#else
    return finite;
#endif
}

struct Lines {
    Vec origin, direction;
};

#if HWY_TARGET != HWY_SCALAR
/// Two floats of each ray.
const hn::Twice<decltype(df)> halves;
using Halves = hn::Vec<decltype(halves)>;
#endif

/// A vector of rays.
struct LoadedRays {
    Lines line;
    real64 tmin, tmax;

#if HWY_TARGET == HWY_SCALAR
    HWY_INLINE explicit LoadedRays(const Ray* ray) {
        line = {glm::dvec3(ray->origin), glm::dvec3(ray->direction)};
        tmin = double(ray->tmin);
        tmax = double(ray->tmax);
    }
#else
    // Each ray consists of two groups of four numbers: origin and tmin, direction and tmax.
    HWY_INLINE explicit LoadedRays(const Ray* rays) {
        Halves x, y, z, t;
        hn::LoadInterleaved4(halves, &rays->origin.x, x, y, z, t);
        line = {{first(x), first(y), first(z)}, {second(x), second(y), second(z)}};
        tmin = first(t);
        tmax = second(t);
    }

  private:
    static HWY_INLINE real64 first(Halves v) {
        return hn::PromoteTo(dd, hn::LowerHalf(df, hn::ConcatEven(halves, v, v)));
    }
    static HWY_INLINE real64 second(Halves v) {
        return hn::PromoteTo(dd, hn::LowerHalf(df, hn::ConcatOdd(halves, v, v)));
    }
#endif
};

/// A vector of rays to trace. Rays that cannot hit anything get an empty interval.
struct Rays : LoadedRays {
    // Hits satisfy tmin < t, and t < tmax after rounding.
    HWY_INLINE explicit Rays(const Ray* rays) : LoadedRays(rays) {
        // Each product is 0, or NaN where a value is not finite.
        const real64 zero = 0.0;
        const Vec none = line.origin * zero + line.direction * zero;
        const truth traceable = none.x + (none.y + none.z) == zero && largest(line.direction) > zero;
        tmax = pick(traceable, tmax, -infinity);
    }
};

/// Calls use(first, count, rays) for each vector of rays; the last vector is padded with the last ray.
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
} // namespace glint::trace
HWY_AFTER_NAMESPACE();

#endif
