// Tests of the rays of a group, one after another, against the triangles of a leaf, for every SIMD target.

#include "trace/mesh/tree.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <hwy/highway.h>

#include "trace/simd/mesh_group-inl.h"

#if defined(GLINT_TRACE_SIMD_MESH_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SIMD_MESH_RAYS_INL_H
#undef GLINT_TRACE_SIMD_MESH_RAYS_INL_H
#else
#define GLINT_TRACE_SIMD_MESH_RAYS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace glint::trace {
namespace HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR
namespace {

/// Vectors of up to eight doubles, and floats of the same count.
const hn::CappedTag<double, 8> dd;
const hn::Rebind<float, decltype(dd)> dfe;
using ExactFloats = hn::Vec<decltype(dfe)>;
using Doubles = hn::Vec<decltype(dd)>;
constexpr std::size_t exact_lanes = hn::MaxLanes(dd);
constexpr std::uint32_t exact_mask = (1u << exact_lanes) - 1u;

/// Sheared and scaled vertices, one triangle a lane.
struct ExactVertex {
    ExactFloats x, y, z;
};

/// The double-precision part of the triangle test for one (ray, triangle) pair a lane: the operations of
/// intersect_sheared().
struct Exact {
    Doubles v, w, det;
    ExactFloats t; ///< NaN if the ray does not hit within (tmin, infinity)

    HWY_INLINE Exact(const ExactVertex& a, const ExactVertex& b, const ExactVertex& c, ExactFloats min_t) {
        const Doubles ax = hn::PromoteTo(dd, a.x), ay = hn::PromoteTo(dd, a.y);
        const Doubles bx = hn::PromoteTo(dd, b.x), by = hn::PromoteTo(dd, b.y);
        const Doubles cx = hn::PromoteTo(dd, c.x), cy = hn::PromoteTo(dd, c.y);
        const Doubles u = hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx));
        v = hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx));
        w = hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax));
        const Doubles zero = hn::Zero(dd);
        const auto mixed =
            hn::And(hn::Lt(hn::Min(u, hn::Min(v, w)), zero), hn::Gt(hn::Max(u, hn::Max(v, w)), zero));
        det = hn::Add(hn::Add(u, v), w);
        const Doubles az = hn::PromoteTo(dd, a.z);
        const Doubles bz = hn::PromoteTo(dd, b.z);
        const Doubles cz = hn::PromoteTo(dd, c.z);
        const Doubles exact = hn::Div(hn::Add(hn::Add(hn::Mul(u, az), hn::Mul(v, bz)), hn::Mul(w, cz)), det);
        const Doubles tmin = hn::PromoteTo(dd, min_t);
        // If det is 0, t is NaN or infinite. Values that would round to infinity are excluded before: without
        // SIMD Highway converts them to the largest float.
        const auto good =
            hn::AndNot(mixed, hn::And(hn::Gt(exact, tmin), hn::Lt(exact, hn::Set(dd, 0x1.ffffffp127))));
        const Doubles none = hn::Set(dd, std::numeric_limits<double>::quiet_NaN());
        t = hn::DemoteTo(dfe, hn::IfThenElse(good, exact, none));
    }
    HWY_INLINE ExactFloats weight_1() const { return hn::DemoteTo(dfe, hn::Div(v, det)); }
    HWY_INLINE ExactFloats weight_2() const { return hn::DemoteTo(dfe, hn::Div(w, det)); }
};

/// Tests the rays in `mask` one by one against the triangles in `wanted`. Returns the rays that hit; records
/// closest hits unless `any`.
template <bool any>
HWY_INLINE std::uint64_t test_each(const Leaf& leaf, Group& group, std::size_t kz, std::uint64_t mask,
                                   const LeafVectors& vertices, std::uint32_t wanted) {
    const std::size_t kx = axis_after[kz], ky = axis_before[kz];
    std::uint64_t hits = 0;
    for (; mask != 0; mask &= mask - 1) {
        const std::size_t r = first_bit(mask);
        LeafRay leaf_ray{group.origin[kx][r],
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
        if (!test_ray<any>(leaf, vertices, wanted, leaf_ray)) continue;
        hits |= std::uint64_t{1} << r;
        if (any) continue;
        group.limit[r] = leaf_ray.limit;
        group.u[r] = leaf_ray.u;
        group.v[r] = leaf_ray.v;
        group.triangle[r] = leaf_ray.triangle;
    }
    return hits;
}

#if HWY_TARGET == HWY_AVX3

/// Up to eight (ray, triangle) pairs that passed the float test and await the exact one, one pair a lane.
struct Pairs {
    ExactVertex a, b, c;
    Floats tmin, limit;
    Integers ray;      ///< index in the group
    Integers triangle; ///< triangle index
    std::uint32_t count = 0;
};

/// Tests and clears all pairs. Returns the rays that hit; records closest hits unless `any`.
template <bool any>
HWY_INLINE std::uint64_t test_pairs(Pairs& pairs, Group& group) {
    tally(&TraceCounters::exact, 1);
    const Exact exact(pairs.a, pairs.b, pairs.c, pairs.tmin);
    std::uint32_t found = bits_of(hn::Le(exact.t, pairs.limit)) & ((1u << pairs.count) - 1u);
    pairs.count = 0;
    std::uint64_t hits = 0;
    if (found == 0) return hits;
    alignas(32) std::int32_t ray[lanes];
    hn::Store(pairs.ray, di, ray);
    if (any) {
        for (; found != 0; found &= found - 1) hits |= std::uint64_t{1} << ray[first_bit(found)];
        return hits;
    }
    alignas(32) std::int32_t triangles[lanes];
    alignas(32) float t[lanes], u[lanes], v[lanes];
    hn::Store(pairs.triangle, di, triangles);
    hn::Store(exact.t, df, t);
    hn::Store(exact.weight_1(), df, u);
    hn::Store(exact.weight_2(), df, v);
    for (; found != 0; found &= found - 1) {
        const std::size_t k = first_bit(found);
        const auto r = static_cast<std::size_t>(ray[k]);
        const auto triangle = static_cast<std::uint32_t>(triangles[k]);
        if (t[k] > group.limit[r] || (t[k] == group.limit[r] && triangle > group.triangle[r])) continue;
        hits |= std::uint64_t{1} << r;
        group.limit[r] = t[k];
        group.u[r] = u[k];
        group.v[r] = v[k];
        group.triangle[r] = triangle;
    }
    return hits;
}

/// Like test_each(). About half of the rays have candidates, unpredictably, so no branch depends on it:
/// candidates of several rays are collected in registers and tested eight at a time.
template <bool any>
HWY_INLINE std::uint64_t test_together(const Leaf& leaf, Group& group, std::size_t kz, std::uint64_t mask,
                                       const LeafVectors& vertices, std::uint32_t wanted) {
    const std::size_t kx = axis_after[kz], ky = axis_before[kz];
    const Lanes asked = Lanes{static_cast<__mmask8>(wanted)};
    const Integers seven = hn::Set(di, 7);
    // Bits 9 and up hold the triangle's position in the leaf.
    const Integers words = hn::Or(corner_words(leaf, 0), hn::ShiftLeft<9>(hn::Iota(di, 0)));
    const Integers numbers = hn::LoadU(di, reinterpret_cast<const std::int32_t*>(leaf.triangles));
    const auto ia = hn::IndicesFromVec(df, hn::And(words, seven));
    const auto ib = hn::IndicesFromVec(df, hn::And(hn::ShiftRight<3>(words), seven));
    const auto ic = hn::IndicesFromVec(df, hn::And(hn::ShiftRight<6>(words), seven));
    Pairs pairs;
    const Floats none = hn::Zero(df);
    pairs.a = pairs.b = pairs.c = {none, none, none};
    pairs.tmin = pairs.limit = none;
    pairs.ray = pairs.triangle = hn::Zero(di);
    std::uint64_t hits = 0;
    for (; mask != 0; mask &= mask - 1) {
        const std::size_t r = first_bit(mask);
        tally(&TraceCounters::ray_leaves, 1);
        const Floats z = hn::Sub(vertices.z[0], hn::Set(df, group.origin[kz][r]));
        const Floats x = hn::Sub(hn::Sub(vertices.x[0], hn::Set(df, group.origin[kx][r])),
                                 hn::Mul(hn::Set(df, group.shear_x[r]), z));
        const Floats y = hn::Sub(hn::Sub(vertices.y[0], hn::Set(df, group.origin[ky][r])),
                                 hn::Mul(hn::Set(df, group.shear_y[r]), z));
        const Floats scaled = hn::Mul(hn::Set(df, group.shear_z[r]), z);
        const Floats ax = hn::TableLookupLanes(x, ia), ay = hn::TableLookupLanes(y, ia);
        const Floats bx = hn::TableLookupLanes(x, ib), by = hn::TableLookupLanes(y, ib);
        const Floats cx = hn::TableLookupLanes(x, ic), cy = hn::TableLookupLanes(y, ic);
        const Lanes left = hn::AndNot(outside(hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx)),
                                              hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx)),
                                              hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax))),
                                      asked);
        const auto more = static_cast<std::uint32_t>(std::popcount(bits_of(left)));
        if (pairs.count + more > lanes) hits |= test_pairs<any>(pairs, group);
        const auto there = static_cast<std::int32_t>(pairs.count);
        const Lanes to = Lanes{static_cast<__mmask8>(((1u << more) - 1u) << there)};
        // Append the candidates to the pairs: compress their corner words, rotate them behind the existing
        // pairs, and look up the vertices.
        const Integers front = hn::Compress(words, hn::RebindMask(di, left));
        const Integers from = hn::And(hn::Sub(hn::Iota(di, 0), hn::Set(di, there)), seven);
        const Integers moved = hn::TableLookupLanes(front, hn::IndicesFromVec(di, from));
        const auto take = [&](Integers slots, Floats values, Floats& lanes_of) {
            lanes_of = hn::IfThenElse(
                to, hn::TableLookupLanes(values, hn::IndicesFromVec(df, hn::And(slots, seven))), lanes_of);
        };
        const auto take_vertex = [&](Integers slots, ExactVertex& vertex) {
            take(slots, x, vertex.x);
            take(slots, y, vertex.y);
            take(slots, scaled, vertex.z);
        };
        take_vertex(moved, pairs.a);
        take_vertex(hn::ShiftRight<3>(moved), pairs.b);
        take_vertex(hn::ShiftRight<6>(moved), pairs.c);
        pairs.tmin = hn::IfThenElse(to, hn::Set(df, group.tmin[r]), pairs.tmin);
        pairs.limit = hn::IfThenElse(to, hn::Set(df, group.limit[r]), pairs.limit);
        const auto to_int = hn::RebindMask(di, to);
        pairs.ray = hn::IfThenElse(to_int, hn::Set(di, static_cast<std::int32_t>(r)), pairs.ray);
        if (!any)
            pairs.triangle =
                hn::IfThenElse(to_int,
                               hn::TableLookupLanes(
                                   numbers, hn::IndicesFromVec(di, hn::And(hn::ShiftRight<9>(moved), seven))),
                               pairs.triangle);
        pairs.count += more;
    }
    return pairs.count != 0 ? hits | test_pairs<any>(pairs, group) : hits;
}

#endif

/// Chooses the faster of the two. AVX2 has too few registers for test_together().
template <bool any>
HWY_INLINE std::uint64_t test_rays(const Leaf& leaf, Group& group, std::size_t kz, std::uint64_t mask,
                                   const LeafVectors& vertices, std::uint32_t wanted) {
#if HWY_TARGET == HWY_AVX3
    if (std::popcount(mask) > 1) return test_together<any>(leaf, group, kz, mask, vertices, wanted);
#endif
    return test_each<any>(leaf, group, kz, mask, vertices, wanted);
}

} // namespace
#endif
} // namespace HWY_NAMESPACE
} // namespace glint::trace
HWY_AFTER_NAMESPACE();

#endif
