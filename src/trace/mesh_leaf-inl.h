// A leaf of a MeshTree against one ray, for every SIMD target. Included once a target by the kernels, with
// Highway's toggled guard.

#include "geometry/triangle.h"
#include "math/offset.shared.h"
#include "trace/mesh_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <hwy/highway.h>

#if defined(GLINT_TRACE_MESH_LEAF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_MESH_LEAF_INL_H
#undef GLINT_TRACE_MESH_LEAF_INL_H
#else
#define GLINT_TRACE_MESH_LEAF_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr float infinity = std::numeric_limits<float>::infinity();
/// Directions are taken as no smaller than this, against their largest component …
constexpr float least_direction = 1e-18f;
/// … and this, against the largest coordinate: so that origin · 1/direction stays finite.
constexpr float least_of_scale = 1e-37f;

const hn::CappedTag<float, 8> df;
using Floats = hn::Vec<decltype(df)>;
constexpr std::size_t lanes = hn::MaxLanes(df);

template <class M>
std::uint32_t bits_of(M mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(df, mask, bits);
    return bits[0];
}

/// Where a leaf's words are.
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
    std::uint32_t corner_word(std::uint32_t i) const { return corners[i / 2] >> (16 * (i % 2)) & 0xffffu; }
};

/// One ray as a leaf sees it, with what it has found.
struct Probe {
    std::size_t kx, ky, kz;
    float ox, oy, oz, sx, sy, sz;
    float tmin;
    float limit; ///< the greatest t still wanted, inclusive
    float u = 0, v = 0;
    std::uint32_t triangle = no_triangle;
};

/// Triangles of a leaf that the probe may hit, as bits: vertices are sheared eight at a time, triangles
/// tested eight at a time. x, y and z receive the sheared vertices.
std::uint32_t candidates_of(const Leaf& leaf, const Probe& probe, float* x, float* y, float* z) {
    const Floats ox = hn::Set(df, probe.ox), oy = hn::Set(df, probe.oy), oz = hn::Set(df, probe.oz);
    const Floats sx = hn::Set(df, probe.sx), sy = hn::Set(df, probe.sy);
    std::uint32_t candidates = (1u << leaf.count) - 1u;
    for (std::size_t i = 0; i < 8; i += lanes) {
        const Floats vz = hn::Sub(hn::LoadU(df, leaf.axis[probe.kz] + i), oz);
        const Floats vx = hn::Sub(hn::Sub(hn::LoadU(df, leaf.axis[probe.kx] + i), ox), hn::Mul(sx, vz));
        const Floats vy = hn::Sub(hn::Sub(hn::LoadU(df, leaf.axis[probe.ky] + i), oy), hn::Mul(sy, vz));
        hn::Store(vx, df, x + i);
        hn::Store(vy, df, y + i);
        hn::Store(vz, df, z + i);
        if constexpr (lanes == 8) {
            const hn::RebindToSigned<decltype(df)> di;
            const hn::Rebind<std::uint16_t, decltype(df)> d16;
            const auto words =
                hn::PromoteTo(di, hn::LoadU(d16, reinterpret_cast<const std::uint16_t*>(leaf.corners)));
            const auto seven = hn::Set(di, 7);
            const auto ia = hn::IndicesFromVec(df, hn::And(words, seven));
            const auto ib = hn::IndicesFromVec(df, hn::And(hn::ShiftRight<3>(words), seven));
            const auto ic = hn::IndicesFromVec(df, hn::ShiftRight<6>(words));
            const Floats ax = hn::TableLookupLanes(vx, ia), ay = hn::TableLookupLanes(vy, ia);
            const Floats bx = hn::TableLookupLanes(vx, ib), by = hn::TableLookupLanes(vy, ib);
            const Floats cx = hn::TableLookupLanes(vx, ic), cy = hn::TableLookupLanes(vy, ic);
            const Floats u = hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx));
            const Floats v = hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx));
            const Floats w = hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax));
            const auto below = hn::Lt(hn::Min(u, hn::Min(v, w)), hn::Zero(df));
            const auto above = hn::Gt(hn::Max(u, hn::Max(v, w)), hn::Zero(df));
            candidates &= ~bits_of(hn::And(below, above));
        }
    }
    return candidates;
}

/// One ray against a whole leaf. Returns whether it hit; closest hits are recorded.
template <bool any>
bool test_ray(const Leaf& leaf, Probe& probe) {
    alignas(32) float x[8], y[8], z[8];
    bool found = false;
    for (std::uint32_t rest = candidates_of(leaf, probe, x, y, z); rest != 0; rest &= rest - 1) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(rest));
        const std::uint32_t word = leaf.corner_word(i);
        const std::uint32_t ka = word & 7u, kb = word >> 3 & 7u, kc = word >> 6 & 7u;
        const ShearedVertex a{x[ka], y[ka], z[ka]};
        const ShearedVertex b{x[kb], y[kb], z[kb]};
        const ShearedVertex c{x[kc], y[kc], z[kc]};
        if (lanes != 8 && surely_outside(a, b, c)) continue;
        TriangleHit hit;
        if (!intersect_sheared(a, b, c, probe.sz, probe.tmin, probe.limit, hit)) continue;
        if (any) return true;
        if (hit.t == probe.limit && leaf.triangles[i] > probe.triangle) continue;
        probe.limit = hit.t;
        probe.u = hit.u;
        probe.v = hit.v;
        probe.triangle = leaf.triangles[i];
        found = true;
    }
    return found;
}

} // namespace
#endif
} // namespace HWY_NAMESPACE
} // namespace glint
HWY_AFTER_NAMESPACE();

#endif
