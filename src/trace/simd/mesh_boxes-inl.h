// Tests of a group of rays against the eight boxes of a node, for every SIMD target.

#include "trace/mesh/tree.h"

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "trace/simd/mesh_group-inl.h"

#if defined(GLINT_TRACE_SIMD_MESH_BOXES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SIMD_MESH_BOXES_INL_H
#undef GLINT_TRACE_SIMD_MESH_BOXES_INL_H
#else
#define GLINT_TRACE_SIMD_MESH_BOXES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace glint::trace {
namespace HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR
namespace {

/// The six planes of one or more boxes, grown by the group's pad.
template <class V>
struct GrownPlanes {
    V near[3];
    V far[3];

    HWY_INLINE GrownPlanes(const Group& group, const V (&n)[3], const V (&f)[3]) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const V grow = hn::Set(hn::DFromV<V>(), group.grow[axis]);
            near[axis] = hn::Sub(n[axis], grow);
            far[axis] = hn::Add(f[axis], grow);
        }
    }
};

/// Slab test: narrows [entry, exit] of one ray for many boxes or of many rays for one box. For mixed rays
/// either plane of an axis may be the near one.
template <bool is_mixed, class V>
HWY_INLINE void clip(const GrownPlanes<V>& planes, const V (&inverse)[3], const V (&offset)[3], V& entry,
                     V& exit) {
    V near[3], far[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        near[axis] = hn::MulAdd(planes.near[axis], inverse[axis], offset[axis]);
        far[axis] = hn::MulAdd(planes.far[axis], inverse[axis], offset[axis]);
        if constexpr (is_mixed) {
            const V nearest = hn::Min(near[axis], far[axis]);
            far[axis] = hn::Max(near[axis], far[axis]);
            near[axis] = nearest;
        }
    }
    entry = hn::Max(hn::Max(near[0], near[1]), hn::Max(near[2], entry));
    exit = hn::Min(hn::Min(far[0], far[1]), hn::Min(far[2], exit));
}

/// The rays that enter each child.
struct Entered {
    std::uint32_t children = 0; ///< bit set of children entered by any ray
    alignas(32) float key[wide_children];
    alignas(64) std::uint64_t mask[wide_children]; ///< valid for these children only
};

/// Gathers one bit of each of 64 bytes.
HWY_INLINE std::uint64_t column(const std::uint8_t* rows, std::uint32_t bit) {
#if HWY_TARGET == HWY_AVX3
    const hn::ScalableTag<std::uint8_t> d8;
    return hn::TestBit(hn::Load(d8, rows), hn::Set(d8, static_cast<std::uint8_t>(1u << bit))).raw;
#else
    const hn::CappedTag<std::uint16_t, 16> d16;
    const hn::Repartition<std::int8_t, decltype(d16)> d8;
    constexpr std::size_t bytes = hn::MaxLanes(d8);
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < group_rays; i += bytes) {
        const auto row = hn::Load(d16, reinterpret_cast<const std::uint16_t*>(rows + i));
        const auto shifted = hn::BitCast(d8, hn::ShiftLeftSame(row, static_cast<int>(7 - bit)));
#if HWY_TARGET == HWY_AVX2
        const auto bits = static_cast<std::uint32_t>(_mm256_movemask_epi8(shifted.raw));
#elif HWY_TARGET == HWY_SSE4
        const auto bits = static_cast<std::uint32_t>(_mm_movemask_epi8(shifted.raw));
#else
        std::uint8_t stored[8] = {};
        hn::StoreMaskBits(d8, hn::Lt(shifted, hn::Zero(d8)), stored);
        const std::uint32_t bits = stored[0] | std::uint32_t{stored[1]} << 8;
#endif
        all |= std::uint64_t{bits} << i;
    }
    return all;
#endif
}

/// Tests ray by ray, eight boxes at once. `with_keys` computes the nearest entry into each child.
template <bool with_keys, bool is_mixed>
HWY_INLINE void enter_by_ray(const float* node, const Group& group, std::uint64_t mask, Entered& entered) {
    tally(&TraceCounters::ray_nodes, static_cast<std::uint64_t>(std::popcount(mask)));
#if HWY_TARGET == HWY_AVX3
    // A comparison yields a lane mask of children: set the ray's bit in the masks of these children.
    __m512i masks = _mm512_setzero_si512();
#else
    alignas(64) std::uint8_t rows[group_rays] = {};
    std::uint32_t children = 0;
#endif
    for (std::size_t i = 0; i < 8; i += lanes) {
        const Floats near[3] = {hn::Load(df, node + group.near_at[0] + i),
                                hn::Load(df, node + group.near_at[1] + i),
                                hn::Load(df, node + group.near_at[2] + i)};
        const Floats far[3] = {hn::Load(df, node + group.far_at[0] + i),
                               hn::Load(df, node + group.far_at[1] + i),
                               hn::Load(df, node + group.far_at[2] + i)};
        const GrownPlanes<Floats> planes(group, near, far);
        // Ordering planes makes the inverted box of a missing child look real, so mask it out.
        const auto exists = hn::Le(near[0], far[0]);
        Floats key = hn::Set(df, infinity);
        for (std::uint64_t rest = mask; rest != 0; rest &= rest - 1) {
            const std::size_t r = first_bit(rest);
            const Floats inverse[3] = {hn::Set(df, group.inverse[0][r]), hn::Set(df, group.inverse[1][r]),
                                       hn::Set(df, group.inverse[2][r])};
            const Floats offset[3] = {hn::Set(df, group.offset[0][r]), hn::Set(df, group.offset[1][r]),
                                      hn::Set(df, group.offset[2][r])};
            Floats entry = hn::Set(df, group.tmin[r]);
            Floats exit = hn::Set(df, group.limit[r]);
            clip<is_mixed>(planes, inverse, offset, entry, exit);
            auto hit = hn::Le(entry, exit);
            if constexpr (is_mixed) hit = hn::And(hit, exists);
            if (with_keys) key = hn::Min(key, hn::IfThenElse(hit, entry, hn::Set(df, infinity)));
#if HWY_TARGET == HWY_AVX3
            const __m512i bit = _mm512_set1_epi64(static_cast<long long>(rest & (0 - rest)));
            masks = _mm512_mask_or_epi64(masks, hit.raw, masks, bit);
#else
            const std::uint32_t bits = bits_of(hit) << i;
            children |= bits;
            rows[r] = static_cast<std::uint8_t>(lanes == 8 ? bits : rows[r] | bits);
#endif
        }
        if (with_keys) hn::Store(key, df, entered.key + i);
    }
#if HWY_TARGET == HWY_AVX3
    entered.children = _mm512_test_epi64_mask(masks, masks);
    _mm512_store_si512(entered.mask, masks);
#else
    entered.children = children;
    for (; children != 0; children &= children - 1) {
        const auto child = static_cast<std::uint32_t>(std::countr_zero(children));
        entered.mask[child] = column(rows, child);
    }
#endif
}

/// Returns the rays that enter one box, testing the vectors whose first bit is set. `with_key` computes the
/// nearest entry.
template <bool with_key, bool is_mixed>
HWY_INLINE std::uint64_t enter_box(const float* node, std::size_t child, const Group& group,
                                   std::uint64_t vectors, float& key) {
    const RayFloats near[3] = {hn::Set(dr, node[group.near_at[0] + child]),
                               hn::Set(dr, node[group.near_at[1] + child]),
                               hn::Set(dr, node[group.near_at[2] + child])};
    const RayFloats far[3] = {hn::Set(dr, node[group.far_at[0] + child]),
                              hn::Set(dr, node[group.far_at[1] + child]),
                              hn::Set(dr, node[group.far_at[2] + child])};
    const GrownPlanes<RayFloats> planes(group, near, far);
    std::uint64_t inside = 0;
    RayFloats nearest = hn::Set(dr, infinity);
    for (; vectors != 0; vectors &= vectors - 1) {
        const std::size_t i = first_bit(vectors);
        tally(&TraceCounters::boxes, 1);
        const RayFloats inverse[3] = {hn::Load(dr, group.inverse[0] + i), hn::Load(dr, group.inverse[1] + i),
                                      hn::Load(dr, group.inverse[2] + i)};
        const RayFloats offset[3] = {hn::Load(dr, group.offset[0] + i), hn::Load(dr, group.offset[1] + i),
                                     hn::Load(dr, group.offset[2] + i)};
        RayFloats entry = hn::Load(dr, group.tmin + i);
        RayFloats exit = hn::Load(dr, group.limit + i);
        clip<is_mixed>(planes, inverse, offset, entry, exit);
        const auto hit = hn::Le(entry, exit);
        if (with_key) nearest = hn::Min(nearest, hn::IfThenElse(hit, entry, hn::Set(dr, infinity)));
        inside |= std::uint64_t{bits_of(dr, hit)} << i;
    }
    if (with_key) key = hn::GetLane(hn::MinOfLanes(dr, nearest));
    return inside;
}

/// Tests the children in `met` one box at a time, for the rays in `mask`; with mixed rays, `met` must not
/// contain missing children. Without keys entered.key is not written.
template <bool with_keys, bool is_mixed>
HWY_INLINE void enter_boxes(const float* node, std::uint32_t met, const Group& group, std::uint64_t vectors,
                            std::uint64_t mask, Entered& entered) {
    for (; met != 0; met &= met - 1) {
        const auto child = static_cast<std::size_t>(std::countr_zero(met));
        entered.mask[child] =
            enter_box<with_keys, is_mixed>(node, child, group, vectors, entered.key[child]) & mask;
        if (entered.mask[child] != 0) entered.children |= 1u << child;
    }
}

} // namespace
#endif
} // namespace HWY_NAMESPACE
} // namespace glint::trace
HWY_AFTER_NAMESPACE();

#endif
