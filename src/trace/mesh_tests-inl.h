// A group's rays against the triangles of a leaf, for every SIMD target.

#include "trace/mesh_tree.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <hwy/highway.h>

#include "trace/mesh_shaft-inl.h"

#if defined(GLINT_TRACE_MESH_TESTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_MESH_TESTS_INL_H
#undef GLINT_TRACE_MESH_TESTS_INL_H
#else
#define GLINT_TRACE_MESH_TESTS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR
namespace {

const hn::Half<decltype(df)> dfh;
const hn::Repartition<double, decltype(df)> dd;
using HalfFloats = hn::Vec<decltype(dfh)>;
using Doubles = hn::Vec<decltype(dd)>;
constexpr std::size_t half_lanes = lanes / 2;
constexpr std::uint32_t half_mask = (1u << half_lanes) - 1u;

/// The rays of a mask, one by one, against those triangles whose bits are set in `wanted`. Returns the rays
/// that hit; closest hits are recorded.
template <bool any>
HWY_INLINE std::uint64_t test_rays(const Leaf& leaf, Group& group, std::size_t kz, std::uint64_t mask,
                                   const LeafVectors& vertices, std::uint32_t wanted) {
    const std::size_t kx = (kz + 1) % 3, ky = (kz + 2) % 3;
    std::uint64_t hits = 0;
    for (; mask != 0; mask &= mask - 1) {
        const std::size_t r = first_bit(mask);
        Probe probe{group.origin[kx][r],
                    group.origin[ky][r],
                    group.origin[kz][r],
                    group.shear_x[r],
                    group.shear_y[r],
                    group.shear_z[r],
                    group.tmin[r],
                    group.limit[r],
                    0.0f,
                    0.0f,
                    group.triangle[r]};
        if (!test_ray<any>(leaf, vertices, wanted, probe)) continue;
        hits |= std::uint64_t{1} << r;
        if (any) continue;
        group.limit[r] = probe.limit;
        group.u[r] = probe.u;
        group.v[r] = probe.v;
        group.triangle[r] = probe.triangle;
    }
    return hits;
}

/// A triangle's vertex for half a vector of rays.
struct HalfVertex {
    HalfFloats x, y, z;
};

/// The exact part of the test, operation by operation intersect_sheared(), for half a vector of rays from
/// `first` on. Returns the rays that hit; closest hits are recorded, of equal ones the lower number.
template <bool any>
HWY_INLINE std::uint32_t intersect_half(const HalfVertex& a, const HalfVertex& b, const HalfVertex& c,
                                        std::uint32_t triangle, Group& group, std::size_t first) {
    const Doubles ax = hn::PromoteTo(dd, a.x), ay = hn::PromoteTo(dd, a.y);
    const Doubles bx = hn::PromoteTo(dd, b.x), by = hn::PromoteTo(dd, b.y);
    const Doubles cx = hn::PromoteTo(dd, c.x), cy = hn::PromoteTo(dd, c.y);
    const Doubles u = hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx));
    const Doubles v = hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx));
    const Doubles w = hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax));
    const Doubles zero = hn::Zero(dd);
    const auto mixed =
        hn::And(hn::Lt(hn::Min(u, hn::Min(v, w)), zero), hn::Gt(hn::Max(u, hn::Max(v, w)), zero));
    const Doubles det = hn::Add(hn::Add(u, v), w);
    const HalfFloats sz = hn::Load(dfh, group.shear_z + first);
    const Doubles az = hn::PromoteTo(dd, hn::Mul(sz, a.z));
    const Doubles bz = hn::PromoteTo(dd, hn::Mul(sz, b.z));
    const Doubles cz = hn::PromoteTo(dd, hn::Mul(sz, c.z));
    const Doubles exact = hn::Div(hn::Add(hn::Add(hn::Mul(u, az), hn::Mul(v, bz)), hn::Mul(w, cz)), det);
    const Doubles tmin = hn::PromoteTo(dd, hn::Load(dfh, group.tmin + first));
    // Where det is 0, t is NaN or infinite. What rounds to infinity is left out before: without vectors
    // Highway would take it to the greatest float.
    const auto good =
        hn::AndNot(mixed, hn::And(hn::Gt(exact, tmin), hn::Lt(exact, hn::Set(dd, 0x1.ffffffp127))));
    const Doubles none = hn::Set(dd, std::numeric_limits<double>::quiet_NaN());
    const HalfFloats t = hn::DemoteTo(dfh, hn::IfThenElse(good, exact, none));
    const HalfFloats limit = hn::Load(dfh, group.limit + first);
    if (any) return bits_of(dfh, hn::Le(t, limit));

    const hn::RebindToUnsigned<decltype(dfh)> duh;
    const auto number = hn::Set(duh, triangle);
    const auto least = hn::Load(duh, group.triangle + first);
    const auto lower = hn::RebindMask(dfh, hn::Eq(hn::Min(number, least), number));
    const auto closer = hn::Or(hn::Lt(t, limit), hn::And(hn::Eq(t, limit), lower));
    const std::uint32_t hits = bits_of(dfh, closer);
    if (hits == 0) return 0;
    const auto put = [&](HalfFloats value, float* to) {
        hn::Store(hn::IfThenElse(closer, value, hn::Load(dfh, to)), dfh, to);
    };
    put(t, group.limit + first);
    put(hn::DemoteTo(dfh, hn::Div(v, det)), group.u + first);
    put(hn::DemoteTo(dfh, hn::Div(w, det)), group.v + first);
    hn::Store(hn::IfThenElse(hn::RebindMask(duh, closer), number, least), duh, group.triangle + first);
    return hits;
}

/// One vector of rays against those triangles of a leaf whose bits are set: each vertex is sheared once, each
/// triangle tested for all rays. All rays of the vector are tested: what any of them hits is a hit of its.
template <bool any>
HWY_INLINE std::uint32_t test_vector(const Leaf& leaf, const Shaft& shaft, std::uint32_t wanted,
                                     std::uint32_t used, Group& group, std::size_t first) {
    alignas(32) float x[8][lanes], y[8][lanes], z[8][lanes];
    const Floats ox = hn::Load(df, group.origin[shaft.kx] + first);
    const Floats oy = hn::Load(df, group.origin[shaft.ky] + first);
    const Floats oz = hn::Load(df, group.origin[shaft.kz] + first);
    const Floats sx = hn::Load(df, group.shear_x + first);
    const Floats sy = hn::Load(df, group.shear_y + first);
    const float* const px = leaf.axis[shaft.kx];
    const float* const py = leaf.axis[shaft.ky];
    const float* const pz = leaf.axis[shaft.kz];
    for (; used != 0; used &= used - 1) {
        const std::size_t i = first_bit(used);
        const Floats vz = hn::Sub(hn::Set(df, pz[i]), oz);
        hn::Store(hn::Sub(hn::Sub(hn::Set(df, px[i]), ox), hn::Mul(sx, vz)), df, x[i]);
        hn::Store(hn::Sub(hn::Sub(hn::Set(df, py[i]), oy), hn::Mul(sy, vz)), df, y[i]);
        hn::Store(vz, df, z[i]);
    }
    std::uint32_t hits = 0;
    for (; wanted != 0; wanted &= wanted - 1) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(wanted));
        tally(&TraceCounters::vectors, 1);
        const std::uint32_t word = leaf.corner_word(i);
        const std::uint32_t ka = word & 7u, kb = word >> 3 & 7u, kc = word >> 6 & 7u;
        const Floats ax = hn::Load(df, x[ka]), ay = hn::Load(df, y[ka]);
        const Floats bx = hn::Load(df, x[kb]), by = hn::Load(df, y[kb]);
        const Floats cx = hn::Load(df, x[kc]), cy = hn::Load(df, y[kc]);
        const std::uint32_t candidates =
            not_outside(hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx)), hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx)),
                        hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax))) &
            lane_mask;
        if (candidates == 0) continue;
        for (std::size_t h = 0; h < lanes; h += half_lanes) {
            if ((candidates >> h & half_mask) == 0) continue;
            tally(&TraceCounters::exact, 1);
            const HalfVertex a{hn::Load(dfh, x[ka] + h), hn::Load(dfh, y[ka] + h), hn::Load(dfh, z[ka] + h)};
            const HalfVertex b{hn::Load(dfh, x[kb] + h), hn::Load(dfh, y[kb] + h), hn::Load(dfh, z[kb] + h)};
            const HalfVertex c{hn::Load(dfh, x[kc] + h), hn::Load(dfh, y[kc] + h), hn::Load(dfh, z[kc] + h)};
            hits |= intersect_half<any>(a, b, c, leaf.triangles[i], group, first + h) << h;
        }
    }
    return hits;
}

/// The vertices of those triangles whose bits are set, as bits.
HWY_INLINE std::uint32_t vertices_of(const Leaf& leaf, std::uint32_t wanted) {
    std::uint32_t used = 0;
    for (; wanted != 0; wanted &= wanted - 1) {
        const std::uint32_t word = leaf.corner_word(static_cast<std::uint32_t>(std::countr_zero(wanted)));
        used |= 1u << (word & 7u) | 1u << (word >> 3 & 7u) | 1u << (word >> 6 & 7u);
    }
    return used;
}

/// A leaf for the rays of a mask within a shaft; returns those that hit.
template <bool any>
HWY_INLINE std::uint64_t test_in_shaft(const Leaf& leaf, const Shaft& shaft, Group& group,
                                       std::uint64_t mask) {
    const LeafVectors vertices(leaf, shaft.kx, shaft.ky, shaft.kz);
    const std::uint32_t wanted = shaft.keeps(leaf, vertices);
    if (wanted == 0) return 0;
    const std::uint32_t used = vertices_of(leaf, wanted);
    std::uint64_t hits = 0;
    std::uint64_t sparse = 0;
    for (std::uint64_t rest = vectors_of(mask); rest != 0; rest &= rest - 1) {
        const std::size_t first = first_bit(rest);
        const auto live = static_cast<std::uint32_t>(mask >> first) & lane_mask;
        // A vector costs about as much as three lone rays.
        if (std::popcount(live) <= 2) {
            sparse |= std::uint64_t{live} << first;
            continue;
        }
        hits |= std::uint64_t{test_vector<any>(leaf, shaft, wanted, used, group, first)} << first;
    }
    return hits | test_rays<any>(leaf, group, shaft.kz, sparse, vertices, wanted);
}

/// A leaf for the rays of a mask one by one, each in the order of its axes.
template <bool any>
HWY_INLINE std::uint64_t test_one_by_one(const Leaf& leaf, Group& group, std::uint64_t mask) {
    std::uint64_t hits = 0;
    for (std::size_t kz = 0; kz < 3; ++kz) {
        const std::uint64_t rays = mask & group.axis_rays[kz];
        if (rays == 0) continue;
        const LeafVectors vertices(leaf, (kz + 1) % 3, (kz + 2) % 3, kz);
        hits |= test_rays<any>(leaf, group, kz, rays, vertices, leaf.all());
    }
    return hits;
}

} // namespace
#endif
} // namespace HWY_NAMESPACE
} // namespace glint
HWY_AFTER_NAMESPACE();

#endif
