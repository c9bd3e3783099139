// Batches of rays through a MeshTree, for every SIMD target: groups of up to 64 rays of one octant and
// dominant axis go down together, a 64-bit mask for each node telling which of them are there.
//
// Coherent groups are bounded by a shaft that culls eight children at once before any ray is looked at (after
// Reshetov, Soupikov, Hurley 2005 and Boulos, Wald, Benthin 2008); incoherent ones filter ray by ray, each
// node fetched once for all (Barringer and Akenine-Möller, "Dynamic Ray Stream Traversal", 2014). The answer
// is the least (t, triangle), so neither order nor kernel nor vector width shows in it. Box tests only have
// to be conservative and may fuse multiply-adds; the triangle test is that of geometry/triangle.h, operation
// by operation.

#include "geometry/triangle.h"
#include "math/offset.shared.h"
#include "trace/mesh_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/mesh_kernels.cpp"
#include <hwy/foreach_target.h> // IWYU pragma: keep

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void closest_batch(const MeshTree& tree, const Ray* rays, TriangleRecord* records, std::size_t count,
                   RayHint) {
    for (std::size_t i = 0; i < count; ++i) records[i] = closest_scalar(tree, rays[i]);
}
void occluded_batch(const MeshTree& tree, const Ray* rays, std::uint8_t* blocked, std::size_t count,
                    RayHint) {
    for (std::size_t i = 0; i < count; ++i) blocked[i] = occluded_scalar(tree, rays[i]) ? 1 : 0;
}
TriangleRecord closest_lone(const MeshTree& tree, const Ray& ray) { return closest_scalar(tree, ray); }
bool occluded_lone(const MeshTree& tree, const Ray& ray) { return occluded_scalar(tree, ray); }

#else

namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t group_rays = 64;
constexpr float infinity = std::numeric_limits<float>::infinity();

const hn::CappedTag<float, 8> df;
using Floats = hn::Vec<decltype(df)>;
const hn::Half<decltype(df)> dfh;
const hn::Repartition<double, decltype(df)> dd;
using Doubles = hn::Vec<decltype(dd)>;
constexpr std::size_t lanes = hn::MaxLanes(df);
constexpr std::uint32_t lane_mask = (1u << lanes) - 1u;

/// Up to 64 rays of one class, side by side.
struct alignas(64) Group {
    float origin[3][group_rays];
    float inverse[3][group_rays];     ///< 1/direction, never infinite
    float near_offset[3][group_rays]; ///< −origin · inverse − pad · |inverse|
    float far_offset[3][group_rays];  ///< −origin · inverse + pad · |inverse|
    float shear_x[group_rays];
    float shear_y[group_rays];
    float tmin[group_rays];
    float limit[group_rays]; ///< the greatest t still wanted, inclusive
    float u[group_rays];
    float v[group_rays];
    std::uint32_t triangle[group_rays];
    std::uint32_t source[group_rays]; ///< number in the batch
    std::size_t count = 0;
    std::size_t kx = 0, ky = 1, kz = 2;
    bool negative[3] = {false, false, false};
};

template <class M>
std::uint32_t bits_of(M mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(df, mask, bits);
    return bits[0];
}

std::size_t first_bit(std::uint64_t mask) { return static_cast<std::size_t>(std::countr_zero(mask)); }

// ── From rays to groups
// ─────────────────────────────────────────────────────────────────────────────────────

constexpr std::uint32_t class_count = 24;
constexpr std::uint8_t no_class = 255; ///< NaN, infinite or without direction: hits nothing

/// Octant × dominant axis. The dominant axis is the first of the largest, as in ShearedRay.
std::uint8_t class_of(const Ray& ray) {
    const float zero = (ray.origin.x + ray.origin.y + ray.origin.z) * 0.0f +
                       (ray.direction.x + ray.direction.y + ray.direction.z) * 0.0f;
    const float x = std::abs(ray.direction.x);
    const float y = std::abs(ray.direction.y);
    const float z = std::abs(ray.direction.z);
    const float most = std::max(x, std::max(y, z));
    if (!(zero == 0.0f) || !(most > 0.0f)) return no_class;
    const std::uint32_t axis = x == most ? 0u : (y == most ? 1u : 2u);
    const std::uint32_t octant = (std::signbit(ray.direction.x) ? 1u : 0u) |
                                 (std::signbit(ray.direction.y) ? 2u : 0u) |
                                 (std::signbit(ray.direction.z) ? 4u : 0u);
    return static_cast<std::uint8_t>(axis * 8u + octant);
}

/// Copies rays side by side; places beyond the last repeat it and are masked out everywhere.
void gather(Group& group, const Ray* rays, const std::uint32_t* numbers, std::size_t count,
            float (*direction)[64]) {
    group.count = count;
    for (std::size_t i = 0; i < group_rays; ++i) {
        const std::uint32_t number = numbers[std::min(i, count - 1)];
        const Ray& ray = rays[number];
        for (int axis = 0; axis < 3; ++axis) {
            group.origin[axis][i] = ray.origin[axis];
            direction[axis][i] = ray.direction[axis];
        }
        group.tmin[i] = ray.tmin;
        group.limit[i] = ray.tmax;
        group.source[i] = number;
    }
}

void set_up(Group& group, std::uint8_t ray_class, const Bounds& bounds, const float (*direction)[64]) {
    group.kz = ray_class / 8u;
    group.kx = (group.kz + 1) % 3;
    group.ky = (group.kz + 2) % 3;
    for (std::size_t axis = 0; axis < 3; ++axis) group.negative[axis] = (ray_class >> axis & 1u) != 0;
    const vec3 far = glm::max(glm::abs(bounds.lo), glm::abs(bounds.hi));
    const Floats corner = hn::Set(df, std::max(far.x, std::max(far.y, far.z)));
    const Floats huge = hn::Set(df, std::numeric_limits<float>::max());
    for (std::size_t i = 0; i < group_rays; i += lanes) {
        const Floats dz = hn::Load(df, direction[group.kz] + i);
        const Floats least = hn::Mul(hn::Abs(dz), hn::Set(df, 1e-18f));
        Floats reach = hn::Zero(df);
        for (std::size_t axis = 0; axis < 3; ++axis)
            reach = hn::Max(reach, hn::Abs(hn::Load(df, group.origin[axis] + i)));
        const Floats pad = hn::Mul(hn::Set(df, 0x1p-20f), hn::Add(reach, corner));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Floats d = hn::Load(df, direction[axis] + i);
            const Floats clamped = hn::Max(hn::Abs(d), least);
            const Floats size = hn::Min(hn::Div(hn::Set(df, 1.0f), clamped), huge);
            const Floats inverse = hn::CopySign(size, d);
            const Floats shift = hn::Mul(hn::Load(df, group.origin[axis] + i), inverse);
            const Floats slack = hn::Mul(pad, size);
            hn::Store(inverse, df, group.inverse[axis] + i);
            hn::Store(hn::Neg(hn::Add(shift, slack)), df, group.near_offset[axis] + i);
            hn::Store(hn::Sub(slack, shift), df, group.far_offset[axis] + i);
        }
        hn::Store(hn::Div(hn::Load(df, direction[group.kx] + i), dz), df, group.shear_x + i);
        hn::Store(hn::Div(hn::Load(df, direction[group.ky] + i), dz), df, group.shear_y + i);
        hn::Store(hn::Zero(df), df, group.u + i);
        hn::Store(hn::Zero(df), df, group.v + i);
    }
    for (std::size_t i = 0; i < group_rays; ++i) {
        group.limit[i] = next_float(group.limit[i], -1.0f);
        group.triangle[i] = no_triangle;
    }
}

// ── Leaves
// ──────────────────────────────────────────────────────────────────────────────────────────────────

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

/// The same for a ray of a group.
template <bool any>
bool test_member(const Leaf& leaf, Group& group, std::size_t r) {
    Probe probe{group.kx,
                group.ky,
                group.kz,
                group.origin[group.kx][r],
                group.origin[group.ky][r],
                group.origin[group.kz][r],
                group.shear_x[r],
                group.shear_y[r],
                group.inverse[group.kz][r],
                group.tmin[r],
                group.limit[r],
                0.0f,
                0.0f,
                group.triangle[r]};
    if (!test_ray<any>(leaf, probe)) return false;
    group.limit[r] = probe.limit;
    group.u[r] = probe.u;
    group.v[r] = probe.v;
    group.triangle[r] = probe.triangle;
    return true;
}

/// What the exact part finds for one vector of rays, as floats; t is infinite where there is no hit.
struct VectorHit {
    Floats t, u, v;
};

struct HalfHit {
    hn::Vec<decltype(dfh)> t, u, v;
};

HalfHit intersect_half(const hn::Vec<decltype(dfh)> (&c)[9], hn::Vec<decltype(dfh)> tmin) {
    const Doubles ax = hn::PromoteTo(dd, c[0]), ay = hn::PromoteTo(dd, c[1]), az = hn::PromoteTo(dd, c[2]);
    const Doubles bx = hn::PromoteTo(dd, c[3]), by = hn::PromoteTo(dd, c[4]), bz = hn::PromoteTo(dd, c[5]);
    const Doubles cx = hn::PromoteTo(dd, c[6]), cy = hn::PromoteTo(dd, c[7]), cz = hn::PromoteTo(dd, c[8]);
    const Doubles u = hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx));
    const Doubles v = hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx));
    const Doubles w = hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax));
    const Doubles zero = hn::Zero(dd);
    const auto mixed =
        hn::And(hn::Lt(hn::Min(u, hn::Min(v, w)), zero), hn::Gt(hn::Max(u, hn::Max(v, w)), zero));
    const Doubles det = hn::Add(hn::Add(u, v), w);
    const Doubles t = hn::Div(hn::Add(hn::Add(hn::Mul(u, az), hn::Mul(v, bz)), hn::Mul(w, cz)), det);
    // Where det is 0, t is NaN or infinite and no float limit lets it pass.
    const auto good = hn::AndNot(mixed, hn::Gt(t, hn::PromoteTo(dd, tmin)));
    const Doubles far = hn::Set(dd, std::numeric_limits<double>::infinity());
    return {hn::DemoteTo(dfh, hn::IfThenElse(good, t, far)), hn::DemoteTo(dfh, hn::Div(v, det)),
            hn::DemoteTo(dfh, hn::Div(w, det))};
}

/// One vector of rays against a whole leaf: each vertex is sheared once, each triangle tested for all rays.
/// Returns the lanes that hit; for closest hits these are recorded.
template <bool any>
std::uint32_t test_vector(const Leaf& leaf, Group& group, std::size_t first, std::uint32_t live) {
    alignas(32) float x[8][lanes], y[8][lanes], z[8][lanes];
    const Floats ox = hn::Load(df, group.origin[group.kx] + first);
    const Floats oy = hn::Load(df, group.origin[group.ky] + first);
    const Floats oz = hn::Load(df, group.origin[group.kz] + first);
    const Floats sx = hn::Load(df, group.shear_x + first);
    const Floats sy = hn::Load(df, group.shear_y + first);
    const Floats sz = hn::Load(df, group.inverse[group.kz] + first);
    for (std::uint32_t i = 0; i < leaf.vertices; ++i) {
        const Floats vz = hn::Sub(hn::Set(df, leaf.axis[group.kz][i]), oz);
        const Floats vx = hn::Sub(hn::Sub(hn::Set(df, leaf.axis[group.kx][i]), ox), hn::Mul(sx, vz));
        const Floats vy = hn::Sub(hn::Sub(hn::Set(df, leaf.axis[group.ky][i]), oy), hn::Mul(sy, vz));
        hn::Store(vx, df, x[i]);
        hn::Store(vy, df, y[i]);
        hn::Store(hn::Mul(sz, vz), df, z[i]);
    }
    std::uint32_t hits = 0;
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
        const std::uint32_t word = leaf.corner_word(i);
        const std::uint32_t ka = word & 7u, kb = word >> 3 & 7u, kc = word >> 6 & 7u;
        const Floats ax = hn::Load(df, x[ka]), ay = hn::Load(df, y[ka]);
        const Floats bx = hn::Load(df, x[kb]), by = hn::Load(df, y[kb]);
        const Floats cx = hn::Load(df, x[kc]), cy = hn::Load(df, y[kc]);
        const Floats u = hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx));
        const Floats v = hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx));
        const Floats w = hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax));
        const auto below = hn::Lt(hn::Min(u, hn::Min(v, w)), hn::Zero(df));
        const auto above = hn::Gt(hn::Max(u, hn::Max(v, w)), hn::Zero(df));
        if ((~bits_of(hn::And(below, above)) & live) == 0) continue;

        const Floats az = hn::Load(df, z[ka]), bz = hn::Load(df, z[kb]), cz = hn::Load(df, z[kc]);
        const Floats tmin = hn::Load(df, group.tmin + first);
        const hn::Vec<decltype(dfh)> lower[9] = {
            hn::LowerHalf(dfh, ax), hn::LowerHalf(dfh, ay), hn::LowerHalf(dfh, az),
            hn::LowerHalf(dfh, bx), hn::LowerHalf(dfh, by), hn::LowerHalf(dfh, bz),
            hn::LowerHalf(dfh, cx), hn::LowerHalf(dfh, cy), hn::LowerHalf(dfh, cz)};
        const hn::Vec<decltype(dfh)> upper[9] = {
            hn::UpperHalf(dfh, ax), hn::UpperHalf(dfh, ay), hn::UpperHalf(dfh, az),
            hn::UpperHalf(dfh, bx), hn::UpperHalf(dfh, by), hn::UpperHalf(dfh, bz),
            hn::UpperHalf(dfh, cx), hn::UpperHalf(dfh, cy), hn::UpperHalf(dfh, cz)};
        const HalfHit lo = intersect_half(lower, hn::LowerHalf(dfh, tmin));
        const HalfHit hi = intersect_half(upper, hn::UpperHalf(dfh, tmin));
        const Floats t = hn::Combine(df, hi.t, lo.t);
        const Floats limit = hn::Load(df, group.limit + first);
        std::uint32_t found = bits_of(hn::Le(t, limit)) & live;
        if (found == 0) continue;
        if (any) {
            hits |= found;
            live &= ~found;
            if (live == 0) break;
            continue;
        }
        // Equal t: the lower number stays.
        for (std::uint32_t same = bits_of(hn::Eq(t, limit)) & found; same != 0; same &= same - 1) {
            const auto lane = static_cast<std::uint32_t>(std::countr_zero(same));
            if (leaf.triangles[i] > group.triangle[first + lane]) found &= ~(1u << lane);
        }
        const auto bits = static_cast<std::uint8_t>(found);
        const std::uint8_t padded[8] = {bits};
        const auto mask = hn::LoadMaskBits(df, padded);
        const hn::RebindToUnsigned<decltype(df)> du;
        hn::Store(hn::IfThenElse(mask, t, limit), df, group.limit + first);
        hn::BlendedStore(hn::Combine(df, hi.u, lo.u), mask, df, group.u + first);
        hn::BlendedStore(hn::Combine(df, hi.v, lo.v), mask, df, group.v + first);
        hn::BlendedStore(hn::Set(du, leaf.triangles[i]), hn::RebindMask(du, mask), du,
                         group.triangle + first);
        hits |= found;
    }
    return hits;
}

/// A leaf for all rays of a mask; returns those that hit.
template <bool any>
std::uint64_t test_leaf(const MeshTree& tree, std::uint32_t code, Group& group, std::uint64_t mask) {
    const Leaf leaf(tree, LeafCode{code});
    std::uint64_t hits = 0;
    for (std::size_t first = 0; first < group_rays; first += lanes) {
        auto live = static_cast<std::uint32_t>(mask >> first) & lane_mask;
        if (live == 0) continue;
        if (std::popcount(live) > 2) {
            hits |= std::uint64_t{test_vector<any>(leaf, group, first, live)} << first;
            continue;
        }
        for (; live != 0; live &= live - 1) {
            const std::size_t r = first + first_bit(live);
            if (test_member<any>(leaf, group, r)) hits |= std::uint64_t{1} << r;
        }
    }
    return hits;
}

// ── Nodes
// ───────────────────────────────────────────────────────────────────────────────────────────────────

/// What is still to be visited.
struct Entry {
    std::uint32_t code;
    float key; ///< where the rays may enter it: the nearer goes first
    std::uint64_t mask;
};

/// Which rays enter which child.
struct Entered {
    std::uint64_t mask[wide_children];
    alignas(32) float key[wide_children];
};

/// The planes of a node that rays of this group's octant meet first and last.
struct Planes {
    const float* near[3];
    const float* far[3];

    Planes(const WideNode& node, const Group& group) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            near[axis] = group.negative[axis] ? node.hi[axis] : node.lo[axis];
            far[axis] = group.negative[axis] ? node.lo[axis] : node.hi[axis];
        }
    }
};

/// Each ray against eight boxes at once. `keys` asks for the nearest entry of each child.
template <bool with_keys>
void enter_by_ray(const Planes& planes, const Group& group, std::uint64_t mask, Entered& entered) {
    alignas(64) std::uint8_t rows[group_rays] = {};
    for (std::size_t i = 0; i < 8; i += lanes) {
        const Floats nx = hn::Load(df, planes.near[0] + i), fx = hn::Load(df, planes.far[0] + i);
        const Floats ny = hn::Load(df, planes.near[1] + i), fy = hn::Load(df, planes.far[1] + i);
        const Floats nz = hn::Load(df, planes.near[2] + i), fz = hn::Load(df, planes.far[2] + i);
        Floats key = hn::Set(df, infinity);
        for (std::uint64_t rest = mask; rest != 0; rest &= rest - 1) {
            const std::size_t r = first_bit(rest);
            const Floats ix = hn::Set(df, group.inverse[0][r]);
            const Floats iy = hn::Set(df, group.inverse[1][r]);
            const Floats iz = hn::Set(df, group.inverse[2][r]);
            const Floats near = hn::Max(hn::Max(hn::MulAdd(nx, ix, hn::Set(df, group.near_offset[0][r])),
                                                hn::MulAdd(ny, iy, hn::Set(df, group.near_offset[1][r]))),
                                        hn::Max(hn::MulAdd(nz, iz, hn::Set(df, group.near_offset[2][r])),
                                                hn::Set(df, group.tmin[r])));
            const Floats far = hn::Min(hn::Min(hn::MulAdd(fx, ix, hn::Set(df, group.far_offset[0][r])),
                                               hn::MulAdd(fy, iy, hn::Set(df, group.far_offset[1][r]))),
                                       hn::Min(hn::MulAdd(fz, iz, hn::Set(df, group.far_offset[2][r])),
                                               hn::Set(df, group.limit[r])));
            const auto hit = hn::Le(near, far);
            if (with_keys) key = hn::Min(key, hn::IfThenElse(hit, near, hn::Set(df, infinity)));
            rows[r] = static_cast<std::uint8_t>(rows[r] | bits_of(hit) << i);
        }
        if (with_keys) hn::Store(key, df, entered.key + i);
    }

    // Transposed: eight bits of each ray to 64 bits of each child.
    for (int child = 0; child < wide_children; ++child) entered.mask[child] = 0;
    const hn::CappedTag<std::uint16_t, 16> d16;
    const hn::Repartition<std::int8_t, decltype(d16)> d8;
    constexpr std::size_t bytes = hn::MaxLanes(d8);
    for (std::size_t i = 0; i < group_rays; i += bytes) {
        auto row = hn::Load(d16, reinterpret_cast<const std::uint16_t*>(rows + i));
        for (int child = wide_children - 1; child >= 0; --child) {
            std::uint64_t bits = 0;
            std::uint8_t stored[8] = {};
            hn::StoreMaskBits(d8, hn::Lt(hn::BitCast(d8, row), hn::Zero(d8)), stored);
            std::memcpy(&bits, stored, sizeof bits);
            entered.mask[child] |= bits << i;
            row = hn::Add(row, row);
        }
    }
}

/// The rays of a mask that enter one box, a vector of rays at a time.
std::uint64_t enter_box(const Planes& planes, std::size_t child, const Group& group, std::uint64_t mask) {
    const Floats nx = hn::Set(df, planes.near[0][child]), fx = hn::Set(df, planes.far[0][child]);
    const Floats ny = hn::Set(df, planes.near[1][child]), fy = hn::Set(df, planes.far[1][child]);
    const Floats nz = hn::Set(df, planes.near[2][child]), fz = hn::Set(df, planes.far[2][child]);
    std::uint64_t inside = 0;
    for (std::size_t i = 0; i < group_rays; i += lanes) {
        if ((mask >> i & lane_mask) == 0) continue;
        const Floats ix = hn::Load(df, group.inverse[0] + i);
        const Floats iy = hn::Load(df, group.inverse[1] + i);
        const Floats iz = hn::Load(df, group.inverse[2] + i);
        const Floats near = hn::Max(hn::Max(hn::MulAdd(nx, ix, hn::Load(df, group.near_offset[0] + i)),
                                            hn::MulAdd(ny, iy, hn::Load(df, group.near_offset[1] + i))),
                                    hn::Max(hn::MulAdd(nz, iz, hn::Load(df, group.near_offset[2] + i)),
                                            hn::Load(df, group.tmin + i)));
        const Floats far = hn::Min(hn::Min(hn::MulAdd(fx, ix, hn::Load(df, group.far_offset[0] + i)),
                                           hn::MulAdd(fy, iy, hn::Load(df, group.far_offset[1] + i))),
                                   hn::Min(hn::MulAdd(fz, iz, hn::Load(df, group.far_offset[2] + i)),
                                           hn::Load(df, group.limit + i)));
        inside |= std::uint64_t{bits_of(hn::Le(near, far))} << i;
    }
    return inside & mask;
}

/// The space that a group's rays sweep between two planes square to the dominant axis, bounded by a straight
/// line on each of four sides. Each ray is a line there, so lines through the outermost places on both planes
/// bound them all.
class Shaft {
  public:
    Shaft(const Group& group, const Bounds& bounds) : group_(group) {
        const vec3 far = glm::max(glm::abs(bounds.lo), glm::abs(bounds.hi));
        const float corner = std::max(far.x, std::max(far.y, far.z));
        const int axis = static_cast<int>(group.kz);
        backward_ = group.negative[group.kz];
        start_ = backward_ ? bounds.hi[axis] : bounds.lo[axis];
        leave_ = backward_ ? bounds.lo[axis] : bounds.hi[axis];
        // Rays that start inside begin there.
        Floats first = hn::Set(df, backward_ ? -infinity : infinity);
        Floats reach = hn::Zero(df);
        for (std::size_t i = 0; i < group_rays; i += lanes) {
            const Floats o = hn::Load(df, group.origin[group.kz] + i);
            first = backward_ ? hn::Max(first, o) : hn::Min(first, o);
            for (std::size_t a = 0; a < 3; ++a)
                reach = hn::Max(reach, hn::Abs(hn::Load(df, group.origin[a] + i)));
        }
        const float origin =
            backward_ ? hn::GetLane(hn::MaxOfLanes(df, first)) : hn::GetLane(hn::MinOfLanes(df, first));
        start_ = backward_ ? std::min(start_, origin) : std::max(start_, origin);
        slack_ = 0x1p-18f * (corner + hn::GetLane(hn::MaxOfLanes(df, reach)));
        end_ = leave_;
        shorten();
        bound_sides();
    }

    /// Moves the far end to the farthest place that any ray still wants.
    void shorten() {
        Floats most = hn::Set(df, backward_ ? infinity : -infinity);
        for (std::size_t i = 0; i < group_rays; i += lanes) {
            // direction · t, with direction = 1 / inverse.
            const Floats way =
                hn::Div(hn::Load(df, group_.limit + i), hn::Load(df, group_.inverse[group_.kz] + i));
            const Floats place = hn::Add(hn::Load(df, group_.origin[group_.kz] + i), way);
            most = backward_ ? hn::Min(most, place) : hn::Max(most, place);
        }
        const float place =
            backward_ ? hn::GetLane(hn::MinOfLanes(df, most)) : hn::GetLane(hn::MaxOfLanes(df, most));
        end_ = backward_ ? std::max(leave_, place) : std::min(leave_, place);
    }

    /// Is what begins at this depth beyond all rays?
    bool is_beyond(float key) const { return key > (backward_ ? -end_ : end_) + slack_; }

    /// The children that the shaft meets, as bits, and where they begin.
    std::uint32_t meets(const Planes& planes, const WideNode& node, float* keys) const {
        std::uint32_t met = 0;
        const Floats start = hn::Set(df, backward_ ? start_ + slack_ : start_ - slack_);
        const Floats end = hn::Set(df, backward_ ? end_ - slack_ : end_ + slack_);
        for (std::size_t i = 0; i < 8; i += lanes) {
            const Floats near = hn::Load(df, planes.near[group_.kz] + i);
            const Floats far = hn::Load(df, planes.far[group_.kz] + i);
            auto hit = backward_ ? hn::And(hn::Ge(near, end), hn::Le(far, start))
                                 : hn::And(hn::Le(near, end), hn::Ge(far, start));
            for (int side = 0; side < 2; ++side) {
                const std::size_t axis = side == 0 ? group_.kx : group_.ky;
                // A line is lowest, or highest, at one end of the box, by its slope alone.
                const Floats low_at = (low_slope_[side] > 0) == backward_ ? far : near;
                const Floats high_at = (high_slope_[side] > 0) == backward_ ? near : far;
                const Floats low =
                    hn::MulAdd(hn::Set(df, low_slope_[side]), low_at, hn::Set(df, low_base_[side]));
                const Floats high =
                    hn::MulAdd(hn::Set(df, high_slope_[side]), high_at, hn::Set(df, high_base_[side]));
                hit = hn::And(hit, hn::And(hn::Ge(hn::Load(df, node.hi[axis] + i), low),
                                           hn::Le(hn::Load(df, node.lo[axis] + i), high)));
            }
            met |= bits_of(hit) << i;
            hn::Store(backward_ ? hn::Neg(near) : near, df, keys + i);
        }
        return met;
    }

  private:
    void bound_sides() {
        const float length = end_ - start_;
        const bool sound = backward_ ? length < 0 : length > 0;
        for (int side = 0; side < 2; ++side) {
            float low[2], high[2];
            for (int at = 0; at < 2; ++at) reach(side, at == 0 ? start_ : end_, low[at], high[at]);
            const float low_slope = (low[1] - low[0]) / length;
            const float high_slope = (high[1] - high[0]) / length;
            const bool usable = sound && std::abs(low_slope) < 4.0f && std::abs(high_slope) < 4.0f;
            low_slope_[side] = usable ? low_slope : 0.0f;
            high_slope_[side] = usable ? high_slope : 0.0f;
            low_base_[side] = (usable ? low[0] - low_slope * start_ : std::min(low[0], low[1])) - 4 * slack_;
            high_base_[side] =
                (usable ? high[0] - high_slope * start_ : std::max(high[0], high[1])) + 4 * slack_;
        }
    }

    /// The outermost rays on one side where they pass a plane of the dominant axis.
    void reach(int side, float plane, float& low, float& high) const {
        const float* slope = side == 0 ? group_.shear_x : group_.shear_y;
        const float* origin = group_.origin[side == 0 ? group_.kx : group_.ky];
        Floats least = hn::Set(df, infinity);
        Floats most = hn::Set(df, -infinity);
        for (std::size_t i = 0; i < group_rays; i += lanes) {
            const Floats way = hn::Sub(hn::Set(df, plane), hn::Load(df, group_.origin[group_.kz] + i));
            const Floats place = hn::MulAdd(way, hn::Load(df, slope + i), hn::Load(df, origin + i));
            least = hn::Min(least, place);
            most = hn::Max(most, place);
        }
        low = hn::GetLane(hn::MinOfLanes(df, least));
        high = hn::GetLane(hn::MaxOfLanes(df, most));
    }

    const Group& group_;
    bool backward_ = false;
    float start_ = 0; ///< along the dominant axis
    float end_ = 0;
    float leave_ = 0; ///< where the tree ends
    float slack_ = 0;
    float low_slope_[2] = {}, low_base_[2] = {};
    float high_slope_[2] = {}, high_base_[2] = {};
};

/// Puts the children that rays enter on the stack, the nearest on top.
std::size_t push(const WideNode& node, const Entered& entered, Entry* stack, std::size_t size) {
    const std::size_t base = size;
    for (std::size_t child = 0; child < wide_children; ++child) {
        if (entered.mask[child] == 0) continue;
        const Entry entry{node.child[child], entered.key[child], entered.mask[child]};
        std::size_t at = size++;
        for (; at > base && stack[at - 1].key < entry.key; --at) stack[at] = stack[at - 1];
        stack[at] = entry;
    }
    return size;
}

constexpr std::size_t stack_size = 8 * (max_tree_depth + 1);

template <bool any, bool coherent>
std::uint64_t traverse(const MeshTree& tree, Group& group) {
    std::uint64_t alive =
        group.count == group_rays ? ~std::uint64_t{0} : (std::uint64_t{1} << group.count) - 1;
    std::uint64_t hits = 0;
    Shaft shaft(group, tree.bounds);
    Entry stack[stack_size];
    std::size_t size = 0;
    stack[size++] = {0, -infinity, alive};
    while (size > 0) {
        const Entry entry = stack[--size];
        const std::uint64_t mask = entry.mask & alive;
        if (mask == 0 || (coherent && shaft.is_beyond(entry.key))) continue;
        if ((entry.code & leaf_bit) != 0) {
            const std::uint64_t found = test_leaf<any>(tree, entry.code, group, mask);
            hits |= found;
            if (any) alive &= ~found;
            if (any && alive == 0) break;
            if (coherent && !any && found != 0) shaft.shorten();
            continue;
        }
        const WideNode& node = tree.nodes[entry.code];
        const Planes planes(node, group);
        Entered entered;
        const int live = std::popcount(mask);
        if (coherent) {
            std::uint32_t met = shaft.meets(planes, node, entered.key);
            if (std::popcount(met) * 8 <= live) {
                for (std::size_t child = 0; child < wide_children; ++child)
                    entered.mask[child] =
                        (met >> child & 1u) != 0 ? enter_box(planes, child, group, mask) : 0;
            } else {
                enter_by_ray<false>(planes, group, mask, entered);
            }
        } else {
            enter_by_ray<true>(planes, group, mask, entered);
        }
        size = push(node, entered, stack, size);
    }
    return hits;
}

// ── Single rays
// ─────────────────────────────────────────────────────────────────────────────────────────────

/// A ray against boxes: eight children at once.
class LoneRay {
  public:
    LoneRay(const Ray& ray, const Bounds& bounds) {
        const vec3 far = glm::max(glm::abs(bounds.lo), glm::abs(bounds.hi));
        const vec3 reach = glm::abs(ray.origin);
        const vec3 d = glm::abs(ray.direction);
        const float most = std::max(d.x, std::max(d.y, d.z));
        const float pad = 0x1p-20f * (std::max(reach.x, std::max(reach.y, reach.z)) +
                                      std::max(far.x, std::max(far.y, far.z)));
        for (int axis = 0; axis < 3; ++axis) {
            const float clamped = std::max(d[axis], most * 1e-18f);
            const float size = std::min(1.0f / clamped, std::numeric_limits<float>::max());
            const float inverse = std::copysign(size, ray.direction[axis]);
            const float shift = ray.origin[axis] * inverse;
            inverse_[axis] = inverse;
            near_offset_[axis] = -(shift + pad * size);
            far_offset_[axis] = pad * size - shift;
            negative_[axis] = std::signbit(ray.direction[axis]);
        }
        tmin_ = ray.tmin;
    }

    /// The children whose boxes the ray meets up to `limit`, as bits, and where.
    std::uint32_t meets(const WideNode& node, float limit, float* entries) const {
        std::uint32_t met = 0;
        for (std::size_t i = 0; i < 8; i += lanes) {
            Floats near = hn::Set(df, tmin_);
            Floats far = hn::Set(df, limit);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const float* first = negative_[axis] ? node.hi[axis] : node.lo[axis];
                const float* last = negative_[axis] ? node.lo[axis] : node.hi[axis];
                const Floats inverse = hn::Set(df, inverse_[axis]);
                near = hn::Max(near,
                               hn::MulAdd(hn::Load(df, first + i), inverse, hn::Set(df, near_offset_[axis])));
                far =
                    hn::Min(far, hn::MulAdd(hn::Load(df, last + i), inverse, hn::Set(df, far_offset_[axis])));
            }
            met |= bits_of(hn::Le(near, far)) << i;
            hn::Store(near, df, entries + i);
        }
        return met;
    }

  private:
    float inverse_[3];
    float near_offset_[3];
    float far_offset_[3];
    float tmin_;
    bool negative_[3];
};

struct LoneEntry {
    std::uint32_t code;
    float t;
};

/// Children in the order of their entries: the farthest first on the stack, the nearest returned.
LoneEntry push_sorted(const WideNode& node, std::uint32_t met, const float* entries, LoneEntry* stack,
                      std::size_t& size) {
    const auto first = static_cast<std::size_t>(std::countr_zero(met));
    LoneEntry nearest{node.child[first], entries[first]};
    const std::size_t base = size;
    for (met &= met - 1; met != 0; met &= met - 1) {
        const auto child = static_cast<std::size_t>(std::countr_zero(met));
        LoneEntry entry{node.child[child], entries[child]};
        if (entry.t < nearest.t) std::swap(entry, nearest);
        std::size_t at = size++;
        for (; at > base && stack[at - 1].t < entry.t; --at) stack[at] = stack[at - 1];
        stack[at] = entry;
    }
    return nearest;
}

Probe probe_of(const Ray& ray) {
    const ShearedRay sheared(ray);
    const float limit = next_float(ray.tmax, -1.0f);
    return {sheared.kx, sheared.ky, sheared.kz, sheared.ox, sheared.oy, sheared.oz, sheared.sx,
            sheared.sy, sheared.sz, ray.tmin,   limit,      0.0f,       0.0f,       no_triangle};
}

/// Follows one ray; returns whether it hit. The nearest child goes on at once, others wait on the stack.
template <bool any>
bool follow(const MeshTree& tree, const Ray& ray, TriangleRecord& record) {
    const LoneRay lone(ray, tree.bounds);
    alignas(32) float entries[8];
    std::uint32_t met = lone.meets(tree.nodes[0], next_float(ray.tmax, -1.0f), entries);
    if (met == 0) return false;
    Probe probe = probe_of(ray);
    LoneEntry stack[stack_size];
    std::size_t size = 0;
    LoneEntry at = push_sorted(tree.nodes[0], met, entries, stack, size);
    for (;;) {
        if ((at.code & leaf_bit) != 0) {
            if (test_ray<any>(Leaf(tree, LeafCode{at.code}), probe) && any) return true;
        } else {
            const WideNode& node = tree.nodes[at.code];
            met = lone.meets(node, probe.limit, entries);
            if (met != 0) {
                at = push_sorted(node, met, entries, stack, size);
                continue;
            }
        }
        do {
            if (size == 0) {
                record = {probe.limit, probe.u, probe.v, probe.triangle};
                return probe.triangle != no_triangle;
            }
            at = stack[--size];
        } while (at.t > probe.limit);
    }
}

// ── Batches
// ─────────────────────────────────────────────────────────────────────────────────────────────────

constexpr std::size_t batch_rays = 4096;

/// Calls body(group, hits) for groups of one class, made from a batch in a stable order.
template <bool any, class Body>
void for_each_group(const MeshTree& tree, const Ray* rays, std::size_t count, RayHint hint, Body&& body) {
    std::uint8_t classes[batch_rays];
    std::uint32_t starts[class_count + 2] = {};
    for (std::size_t i = 0; i < count; ++i) {
        classes[i] = class_of(rays[i]);
        ++starts[std::min<std::uint32_t>(classes[i], class_count) + 1];
    }
    for (std::size_t c = 1; c < class_count + 2; ++c) starts[c] += starts[c - 1];
    std::uint32_t order[batch_rays];
    std::uint32_t next[class_count + 1];
    std::copy_n(starts, class_count + 1, next);
    for (std::size_t i = 0; i < count; ++i)
        order[next[std::min<std::uint32_t>(classes[i], class_count)]++] = static_cast<std::uint32_t>(i);

    Group group;
    alignas(64) float direction[3][group_rays];
    for (std::uint32_t c = 0; c < class_count; ++c) {
        for (std::uint32_t at = starts[c]; at < starts[c + 1]; at += group_rays) {
            gather(group, rays, order + at, std::min<std::size_t>(group_rays, starts[c + 1] - at), direction);
            set_up(group, static_cast<std::uint8_t>(c), tree.bounds, direction);
            const std::uint64_t hits = hint == RayHint::coherent ? traverse<any, true>(tree, group)
                                                                 : traverse<any, false>(tree, group);
            body(group, hits);
        }
    }
}

void closest_rays(const MeshTree& tree, const Ray* rays, TriangleRecord* records, std::size_t count,
                  RayHint hint) {
    for (std::size_t at = 0; at < count; at += batch_rays) {
        const std::size_t n = std::min(batch_rays, count - at);
        std::fill_n(records + at, n, TriangleRecord{});
        if (tree.nodes.empty()) continue;
        for_each_group<false>(tree, rays + at, n, hint, [&](const Group& group, std::uint64_t hits) {
            for (; hits != 0; hits &= hits - 1) {
                const std::size_t i = first_bit(hits);
                records[at + group.source[i]] = {group.limit[i], group.u[i], group.v[i], group.triangle[i]};
            }
        });
    }
}

void occluded_rays(const MeshTree& tree, const Ray* rays, std::uint8_t* blocked, std::size_t count,
                   RayHint hint) {
    for (std::size_t at = 0; at < count; at += batch_rays) {
        const std::size_t n = std::min(batch_rays, count - at);
        std::fill_n(blocked + at, n, std::uint8_t{0});
        if (tree.nodes.empty()) continue;
        for_each_group<true>(tree, rays + at, n, hint, [&](const Group& group, std::uint64_t hits) {
            for (; hits != 0; hits &= hits - 1) blocked[at + group.source[first_bit(hits)]] = 1;
        });
    }
}

} // namespace

// What the dispatcher calls: anonymous functions cannot be exported.
TriangleRecord closest_lone(const MeshTree& tree, const Ray& ray) {
    TriangleRecord record;
    const bool hit = !tree.nodes.empty() && class_of(ray) != no_class && follow<false>(tree, ray, record);
    return hit ? record : TriangleRecord{};
}
bool occluded_lone(const MeshTree& tree, const Ray& ray) {
    TriangleRecord record;
    return !tree.nodes.empty() && class_of(ray) != no_class && follow<true>(tree, ray, record);
}
void closest_batch(const MeshTree& tree, const Ray* rays, TriangleRecord* records, std::size_t count,
                   RayHint hint) {
    closest_rays(tree, rays, records, count, hint);
}
void occluded_batch(const MeshTree& tree, const Ray* rays, std::uint8_t* blocked, std::size_t count,
                    RayHint hint) {
    occluded_rays(tree, rays, blocked, count, hint);
}

#endif

} // namespace HWY_NAMESPACE
} // namespace glint
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glint {

HWY_EXPORT(closest_batch);
HWY_EXPORT(occluded_batch);
HWY_EXPORT(closest_lone);
HWY_EXPORT(occluded_lone);

TriangleRecord closest(const MeshTree& tree, const Ray& ray) {
    return HWY_DYNAMIC_DISPATCH(closest_lone)(tree, ray);
}

bool occluded(const MeshTree& tree, const Ray& ray) { return HWY_DYNAMIC_DISPATCH(occluded_lone)(tree, ray); }

void closest(const MeshTree& tree, std::span<const Ray> rays, std::span<TriangleRecord> records,
             RayHint hint) {
    HWY_DYNAMIC_DISPATCH(closest_batch)(tree, rays.data(), records.data(), rays.size(), hint);
}

void occluded(const MeshTree& tree, std::span<const Ray> rays, std::span<std::uint8_t> blocked,
              RayHint hint) {
    HWY_DYNAMIC_DISPATCH(occluded_batch)(tree, rays.data(), blocked.data(), rays.size(), hint);
}

} // namespace glint
#endif
