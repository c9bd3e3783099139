// Tests of single rays against a leaf of a MeshTree, for every SIMD target. Included once a target by the
// kernels, with Highway's toggled guard.

#include "geometry/triangle.h"
#include "math/offset.shared.h"
#include "trace/mesh/tree.h"
#include "trace/simd/counters.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include <hwy/highway.h>

#if defined(GLINT_TRACE_SIMD_MESH_LEAF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SIMD_MESH_LEAF_INL_H
#undef GLINT_TRACE_SIMD_MESH_LEAF_INL_H
#else
#define GLINT_TRACE_SIMD_MESH_LEAF_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace glint::trace {
namespace HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr float infinity = std::numeric_limits<float>::infinity();
/// Direction components are clamped to this times the largest one …
constexpr float min_direction_ratio = 1e-18f;
/// … and to this times the largest coordinate, which keeps origin · 1/direction finite.
constexpr float min_scale_ratio = 1e-37f;

const hn::CappedTag<float, 8> df;
const hn::RebindToSigned<decltype(df)> di;
using Floats = hn::Vec<decltype(df)>;
using Integers = hn::Vec<decltype(di)>;
using Lanes = hn::Mask<decltype(df)>;
constexpr std::size_t lanes = hn::MaxLanes(df);
/// Number of vectors for eight floats.
constexpr std::size_t parts = 8 / lanes;
/// Cyclic successor and predecessor of an axis: cheaper than a remainder.
constexpr std::size_t axis_after[3] = {1, 2, 0};
constexpr std::size_t axis_before[3] = {2, 0, 1};

/// Converts a lane mask to bits; Highway's own conversion goes through memory.
template <class D, class M>
HWY_INLINE std::uint32_t bits_of(D d, M mask) {
#if HWY_TARGET == HWY_AVX3
    // g++ 12 otherwise stores one byte of the mask and loads four.
    std::uint32_t bits;
    if constexpr (hn::MaxLanes(D()) == 16) {
        asm("kmovw %1, %0" : "=r"(bits) : "k"(mask.raw));
        return bits;
    } else {
        asm("kmovb %1, %0" : "=r"(bits) : "k"(mask.raw));
        return hn::MaxLanes(D()) == 8 ? bits : bits & ((1u << hn::MaxLanes(d)) - 1u);
    }
#elif HWY_TARGET == HWY_AVX2
    if constexpr (hn::MaxLanes(D()) == 8) {
        return static_cast<std::uint32_t>(_mm256_movemask_ps(mask.raw));
    } else {
        return static_cast<std::uint32_t>(_mm_movemask_ps(mask.raw)) & ((1u << hn::MaxLanes(d)) - 1u);
    }
#elif HWY_TARGET == HWY_SSE4
    return static_cast<std::uint32_t>(_mm_movemask_ps(mask.raw)) & ((1u << hn::MaxLanes(d)) - 1u);
#else
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, mask, bits);
    return bits[0];
#endif
}
HWY_INLINE std::uint32_t bits_of(Lanes mask) { return bits_of(df, mask); }

/// Index of the lowest set bit.
HWY_INLINE std::size_t first_bit(std::uint64_t mask) {
    return static_cast<std::size_t>(std::countr_zero(mask));
}

/// Pointers to the parts of a leaf.
struct Leaf {
    const std::uint32_t* corners;
    const float* axis[3];
    const std::uint32_t* triangles;
    std::uint32_t count;
    std::uint32_t vertices;

    Leaf(const MeshTree& tree, LeafCode code)
        : corners(tree.leaf_words.data() + code.word()), count(code.triangles()), vertices(code.vertices()) {
        const auto* floats = reinterpret_cast<const float*>(corners + 4);
        for (std::uint32_t k = 0; k < 3; ++k) axis[k] = floats + k * vertices;
        triangles = corners + 4 + 3 * vertices;
    }
    std::uint32_t corner_word(std::uint32_t i) const {
        std::uint16_t word;
        std::memcpy(&word, reinterpret_cast<const char*>(corners) + sizeof word * i, sizeof word);
        return word;
    }
    std::uint32_t all() const { return (1u << count) - 1u; }
};

/// Corner words of eight triangles, one triangle a lane.
HWY_INLINE Integers corner_words(const Leaf& leaf, std::size_t first) {
    const hn::Rebind<std::uint16_t, decltype(df)> d16;
    return hn::PromoteTo(di, hn::LoadU(d16, reinterpret_cast<const std::uint16_t*>(leaf.corners) + first));
}

/// The vertices of a leaf with axes permuted for a ray. Lanes beyond the last vertex are arbitrary in x and y
/// but 0 in z, which is multiplied: triangle indices may follow there, which are denormal floats, and
/// multiplying those takes a hundred cycles on some processors.
struct LeafVectors {
    Floats x[parts], y[parts], z[parts];

    HWY_INLINE LeafVectors(const Leaf& leaf, std::size_t kx, std::size_t ky, std::size_t kz) {
        for (std::size_t i = 0; i < parts; ++i) {
            const std::size_t at = i * lanes;
            x[i] = hn::LoadU(df, leaf.axis[kx] + at);
            y[i] = hn::LoadU(df, leaf.axis[ky] + at);
            z[i] = hn::IfThenElseZero(hn::FirstN(df, leaf.vertices > at ? leaf.vertices - at : 0),
                                      hn::LoadU(df, leaf.axis[kz] + at));
        }
    }
};

/// Lanes whose edge functions exclude a hit, as in surely_outside(): the product of the least and the
/// greatest is negative (or underflows) if both signs occur.
template <class V>
HWY_INLINE hn::Mask<hn::DFromV<V>> outside(V u, V v, V w) {
    const V low = hn::Min(u, hn::Min(v, w));
    const V high = hn::Max(u, hn::Max(v, w));
    return hn::Lt(hn::Mul(low, high), hn::Zero(hn::DFromV<V>()));
}
HWY_INLINE std::uint32_t candidates_of(Floats u, Floats v, Floats w) { return ~bits_of(outside(u, v, w)); }

/// One ray in sheared coordinates, and its closest hit so far.
struct LeafRay {
    float ox, oy, oz, sx, sy, sz;
    float tmin;
    float limit; ///< the greatest t still wanted, inclusive
    float u = 0, v = 0;
    std::uint32_t triangle = invalid_index;
};

/// Tests the triangles in `candidates` against one ray by their sheared vertices. Returns whether any was
/// hit; records the closest hit unless `any`.
template <bool any>
HWY_INLINE bool test_candidates(const Leaf& leaf, std::uint32_t candidates, const float* x, const float* y,
                                const float* z, LeafRay& leaf_ray) {
    bool found = false;
    for (; candidates != 0; candidates &= candidates - 1) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(candidates));
        const std::uint32_t word = leaf.corner_word(i);
        const std::uint32_t ka = word & 7u, kb = word >> 3 & 7u, kc = word >> 6 & 7u;
        const ShearedVertex a{x[ka], y[ka], z[ka]};
        const ShearedVertex b{x[kb], y[kb], z[kb]};
        const ShearedVertex c{x[kc], y[kc], z[kc]};
        if (lanes != 8 && surely_outside(a, b, c)) continue;
        tally(&TraceCounters::exact, 1);
        TriangleHit hit;
        if (!intersect_sheared(a, b, c, leaf_ray.sz, leaf_ray.tmin, leaf_ray.limit, hit)) continue;
        if (any) return true;
        if (hit.t == leaf_ray.limit && leaf.triangles[i] > leaf_ray.triangle) continue;
        leaf_ray.limit = hit.t;
        leaf_ray.u = hit.u;
        leaf_ray.v = hit.v;
        leaf_ray.triangle = leaf.triangles[i];
        found = true;
    }
    return found;
}

/// Tests one ray against the triangles in `wanted`, shearing eight vertices and testing eight triangles at
/// once.
template <bool any>
HWY_INLINE bool test_ray(const Leaf& leaf, const LeafVectors& vertices, std::uint32_t wanted,
                         LeafRay& leaf_ray) {
    tally(&TraceCounters::ray_leaves, 1);
    const Floats ox = hn::Set(df, leaf_ray.ox), oy = hn::Set(df, leaf_ray.oy), oz = hn::Set(df, leaf_ray.oz);
    const Floats sx = hn::Set(df, leaf_ray.sx), sy = hn::Set(df, leaf_ray.sy);
    Floats vx[parts], vy[parts], vz[parts];
    for (std::size_t i = 0; i < parts; ++i) {
        vz[i] = hn::Sub(vertices.z[i], oz);
        vx[i] = hn::Sub(hn::Sub(vertices.x[i], ox), hn::Mul(sx, vz[i]));
        vy[i] = hn::Sub(hn::Sub(vertices.y[i], oy), hn::Mul(sy, vz[i]));
    }
    std::uint32_t candidates = wanted;
    if constexpr (lanes == 8) {
        const Integers words = corner_words(leaf, 0);
        const Integers seven = hn::Set(di, 7);
        const auto ia = hn::IndicesFromVec(df, hn::And(words, seven));
        const auto ib = hn::IndicesFromVec(df, hn::And(hn::ShiftRight<3>(words), seven));
        const auto ic = hn::IndicesFromVec(df, hn::ShiftRight<6>(words));
        const Floats ax = hn::TableLookupLanes(vx[0], ia), ay = hn::TableLookupLanes(vy[0], ia);
        const Floats bx = hn::TableLookupLanes(vx[0], ib), by = hn::TableLookupLanes(vy[0], ib);
        const Floats cx = hn::TableLookupLanes(vx[0], ic), cy = hn::TableLookupLanes(vy[0], ic);
        candidates &= candidates_of(hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx)),
                                    hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx)),
                                    hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax)));
        if (candidates == 0) return false;
    }
    alignas(32) float x[8], y[8], z[8];
    for (std::size_t i = 0; i < parts; ++i) {
        hn::Store(vx[i], df, x + i * lanes);
        hn::Store(vy[i], df, y + i * lanes);
        hn::Store(vz[i], df, z + i * lanes);
    }
    return test_candidates<any>(leaf, candidates, x, y, z, leaf_ray);
}

} // namespace
#endif
} // namespace HWY_NAMESPACE
} // namespace glint::trace
HWY_AFTER_NAMESPACE();

#endif
