// Tests of a group of rays against the triangles of a leaf, for every SIMD target.

#include "trace/mesh/tree.h"

#include <bit>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "trace/simd/mesh_rays-inl.h"
#include "trace/simd/mesh_shaft-inl.h"

#if defined(GLINT_TRACE_SIMD_MESH_TESTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SIMD_MESH_TESTS_INL_H
#undef GLINT_TRACE_SIMD_MESH_TESTS_INL_H
#else
#define GLINT_TRACE_SIMD_MESH_TESTS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace glint::trace {
namespace HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR
namespace {

/// Tests one triangle against a vector of rays starting at `first`. Returns the rays that hit; records
/// closest hits unless `any`, at equal t the lower triangle index.
template <bool any>
HWY_INLINE std::uint32_t intersect(const Exact& exact, std::uint32_t triangle, Group& group,
                                   std::size_t first) {
    const ExactFloats limit = hn::Load(dfe, group.limit + first);
    if (any) return bits_of(dfe, hn::Le(exact.t, limit));

    const hn::RebindToUnsigned<decltype(dfe)> du;
    const auto number = hn::Set(du, triangle);
    const auto best = hn::Load(du, group.triangle + first);
    const auto lower = hn::RebindMask(dfe, hn::Eq(hn::Min(number, best), number));
    const auto closer = hn::Or(hn::Lt(exact.t, limit), hn::And(hn::Eq(exact.t, limit), lower));
    const std::uint32_t hits = bits_of(dfe, closer);
    if (hits == 0) return 0;
    const auto put = [&](ExactFloats value, float* to) {
        hn::Store(hn::IfThenElse(closer, value, hn::Load(dfe, to)), dfe, to);
    };
    put(exact.t, group.limit + first);
    put(exact.weight_1(), group.u + first);
    put(exact.weight_2(), group.v + first);
    hn::Store(hn::IfThenElse(hn::RebindMask(du, closer), number, best), du, group.triangle + first);
    return hits;
}

/// Tests one vector of rays against the triangles in `wanted`: each vertex in `used` is sheared once, each
/// triangle tested for all rays. Inactive rays of the vector are tested too, which is harmless: their hits
/// are valid.
template <bool any>
HWY_INLINE std::uint32_t test_vector(const Leaf& leaf, const Shaft& shaft, std::uint32_t wanted,
                                     std::uint32_t used, Group& group, std::size_t first) {
    alignas(64) float x[8][ray_lanes], y[8][ray_lanes], z[8][ray_lanes];
    const RayFloats ox = hn::Load(dr, group.origin[shaft.kx] + first);
    const RayFloats oy = hn::Load(dr, group.origin[shaft.ky] + first);
    const RayFloats oz = hn::Load(dr, group.origin[shaft.kz] + first);
    const RayFloats sx = hn::Load(dr, group.shear_x + first);
    const RayFloats sy = hn::Load(dr, group.shear_y + first);
    const RayFloats sz = hn::Load(dr, group.shear_z + first);
    const float* const px = leaf.axis[shaft.kx];
    const float* const py = leaf.axis[shaft.ky];
    const float* const pz = leaf.axis[shaft.kz];
    for (; used != 0; used &= used - 1) {
        const std::size_t i = first_bit(used);
        const RayFloats vz = hn::Sub(hn::Set(dr, pz[i]), oz);
        hn::Store(hn::Sub(hn::Sub(hn::Set(dr, px[i]), ox), hn::Mul(sx, vz)), dr, x[i]);
        hn::Store(hn::Sub(hn::Sub(hn::Set(dr, py[i]), oy), hn::Mul(sy, vz)), dr, y[i]);
        hn::Store(hn::Mul(sz, vz), dr, z[i]);
    }
    std::uint32_t hits = 0;
    for (; wanted != 0; wanted &= wanted - 1) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(wanted));
        tally(&TraceCounters::vectors, 1);
        const std::uint32_t word = leaf.corner_word(i);
        const std::uint32_t ka = word & 7u, kb = word >> 3 & 7u, kc = word >> 6 & 7u;
        const RayFloats ax = hn::Load(dr, x[ka]), ay = hn::Load(dr, y[ka]);
        const RayFloats bx = hn::Load(dr, x[kb]), by = hn::Load(dr, y[kb]);
        const RayFloats cx = hn::Load(dr, x[kc]), cy = hn::Load(dr, y[kc]);
        const std::uint32_t candidates = ~bits_of(dr, outside(hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx)),
                                                              hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx)),
                                                              hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax)))) &
                                         ray_lane_mask;
        if (candidates == 0) continue;
        for (std::size_t h = 0; h < ray_lanes; h += exact_lanes) {
            if ((candidates >> h & exact_mask) == 0) continue;
            tally(&TraceCounters::exact, 1);
            const auto vertex = [&](std::size_t k) {
                return ExactVertex{hn::Load(dfe, x[k] + h), hn::Load(dfe, y[k] + h), hn::Load(dfe, z[k] + h)};
            };
            const Exact exact(vertex(ka), vertex(kb), vertex(kc), hn::Load(dfe, group.tmin + first + h));
            hits |= intersect<any>(exact, leaf.triangles[i], group, first + h) << h;
        }
    }
    return hits;
}

/// The vertices of the triangles in `wanted` as bits.
HWY_INLINE std::uint32_t vertices_of(const Leaf& leaf, std::uint32_t wanted) {
    std::uint32_t used = 0;
    for (; wanted != 0; wanted &= wanted - 1) {
        const std::uint32_t word = leaf.corner_word(static_cast<std::uint32_t>(std::countr_zero(wanted)));
        used |= 1u << (word & 7u) | 1u << (word >> 3 & 7u) | 1u << (word >> 6 & 7u);
    }
    return used;
}

/// Tests the rays in `mask` against a leaf, culling triangles by the shaft; returns the rays that hit.
template <bool any>
HWY_INLINE std::uint64_t test_in_shaft(const Leaf& leaf, const Shaft& shaft, Group& group,
                                       std::uint64_t mask) {
    const LeafVectors vertices(leaf, shaft.kx, shaft.ky, shaft.kz);
    const std::uint32_t wanted = shaft.candidates(leaf, vertices);
    if (wanted == 0) return 0;
    const std::uint32_t used = vertices_of(leaf, wanted);
    std::uint64_t hits = 0;
    std::uint64_t sparse = 0;
    for (std::uint64_t rest = vectors_of(mask); rest != 0; rest &= rest - 1) {
        const std::size_t first = first_bit(rest);
        const auto live = static_cast<std::uint32_t>(mask >> first) & ray_lane_mask;
        // A vector costs about as much as three single rays.
        if (std::popcount(live) <= 2) {
            sparse |= std::uint64_t{live} << first;
            continue;
        }
        hits |= std::uint64_t{test_vector<any>(leaf, shaft, wanted, used, group, first)} << first;
    }
    return hits | test_rays<any>(leaf, group, shaft.kz, sparse, vertices, wanted);
}

/// Tests the rays in `mask` one by one, grouped by dominant axis.
template <bool any>
HWY_INLINE std::uint64_t test_one_by_one(const Leaf& leaf, Group& group, std::uint64_t mask) {
    std::uint64_t hits = 0;
    for (std::size_t kz = 0; kz < 3; ++kz) {
        const std::uint64_t rays = mask & group.axis_rays[kz];
        if (rays == 0) continue;
        const LeafVectors vertices(leaf, axis_after[kz], axis_before[kz], kz);
        hits |= test_rays<any>(leaf, group, kz, rays, vertices, leaf.all());
    }
    return hits;
}

} // namespace
#endif
} // namespace HWY_NAMESPACE
} // namespace glint::trace
HWY_AFTER_NAMESPACE();

#endif
