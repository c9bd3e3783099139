// Groups of up to 64 rays as structure of arrays, and loading them from an array of rays, for every SIMD
// target.

#include "trace/mesh/tree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "trace/simd/mesh_leaf-inl.h"

#if defined(GLINT_TRACE_SIMD_MESH_GROUP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SIMD_MESH_GROUP_INL_H
#undef GLINT_TRACE_SIMD_MESH_GROUP_INL_H
#else
#define GLINT_TRACE_SIMD_MESH_GROUP_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace glint::trace {
namespace HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR
namespace {

constexpr std::size_t group_rays = 64;
constexpr std::uint32_t lane_mask = (1u << lanes) - 1u;

/// Vectors across rays, which may be wider than the eight boxes of a node.
const hn::CappedTag<float, 16> dr;
using RayFloats = hn::Vec<decltype(dr)>;
constexpr std::size_t ray_lanes = hn::MaxLanes(dr);
constexpr std::uint32_t ray_lane_mask = (1u << ray_lanes) - 1u;

/// The number of rays rounded up to whole vectors.
constexpr std::size_t padded_count(std::size_t rays) {
    return (rays + ray_lanes - 1) / ray_lanes * ray_lanes;
}

/// Offsets in a node, in floats.
constexpr std::size_t low_planes(std::size_t axis) { return axis * wide_children; }
constexpr std::size_t high_planes_offset = 3 * wide_children;
static_assert(offsetof(WideNode, lo) == 0 && offsetof(WideNode, hi) == high_planes_offset * sizeof(float));

/// The vectors of a group that contain rays of a mask: the first bit of each is set.
HWY_INLINE std::uint64_t vectors_of(std::uint64_t mask) {
    for (std::size_t i = 1; i < ray_lanes; i *= 2) mask |= mask >> i;
    return mask & (ray_lanes == 16  ? 0x0001000100010001u
                   : ray_lanes == 8 ? 0x0101010101010101u
                                    : 0x1111111111111111u);
}

/// Up to 64 rays, mostly of one octant. Lanes beyond the last ray, in its vector, repeat it.
struct alignas(64) Group {
    float origin[3][group_rays];
    float direction[3][group_rays];
    float inverse[3][group_rays]; ///< 1/direction, never infinite
    float offset[3][group_rays];  ///< −origin · inverse
    float shear_x[group_rays];
    float shear_y[group_rays];
    float shear_z[group_rays];
    float tmin[group_rays];
    float limit[group_rays]; ///< upper bound of t, inclusive
    float u[group_rays];
    float v[group_rays];
    std::uint32_t triangle[group_rays];
    std::uint64_t axis_rays[3]; ///< bit sets by dominant axis, ties resolved as in ShearedRay
    std::size_t count = 0;
    bool is_mixed = false; ///< rays of several octants: no common order of planes
    bool negative[3] = {false, false, false};
    bool reaches_back = false; ///< some tmin are negative
    float pad = 0;             ///< boxes are grown by this on every side, see bvh/traverse.h
    float grow[3];             ///< ±pad: subtracted from near planes, added to far planes
    std::size_t
        near_at[3]; ///< offset of the near planes in a node, in floats (of the low planes for mixed rays)
    std::size_t far_at[3]; ///< likewise of the far planes

    std::uint64_t all() const {
        return count == group_rays ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
    }
};

/// Constants of a tree that all rays through it share.
struct TreeConstants {
    Bounds bounds;
    float corner;     ///< largest |coordinate| of the tree
    float max_origin; ///< rays with a larger origin coordinate are traced singly: they would inflate the pad
                      ///< of their group
    float max_length; ///< longer directions are traced singly: t might become subnormal

    explicit TreeConstants(const MeshTree& tree) : bounds(tree.bounds) {
        const vec3 far = glm::max(glm::abs(bounds.lo), glm::abs(bounds.hi));
        corner = std::max(far.x, std::max(far.y, far.z));
        max_origin = corner * 64.0f;
        max_length = std::min(corner, 1.0f) * 1e30f;
    }
};

/// Shorter directions are traced singly: their reciprocals may overflow.
constexpr float min_length = 1e-19f;

/// Classification of 64 rays, one bit a ray.
struct Signs {
    std::uint64_t negative[3] = {};
    std::uint64_t axis[2] = {};  ///< set if x, or y, is the dominant axis
    std::uint64_t ungrouped = 0; ///< rays to be traced singly, and padding lanes that repeat such a ray

    /// The rays in the same class as ray i: same octant and, with `by_axis`, same dominant axis.
    std::uint64_t alike(std::size_t i, bool by_axis) const {
        std::uint64_t same = ~std::uint64_t{0};
        for (const std::uint64_t bits : negative) same &= (bits >> i & 1u) != 0 ? bits : ~bits;
        if (by_axis)
            for (const std::uint64_t bits : axis) same &= (bits >> i & 1u) != 0 ? bits : ~bits;
        return same;
    }
    std::uint32_t octant(std::size_t i) const {
        return static_cast<std::uint32_t>((negative[0] >> i & 1u) | (negative[1] >> i & 1u) << 1 |
                                          (negative[2] >> i & 1u) << 2);
    }
    std::uint32_t dominant(std::size_t i) const {
        return (axis[0] >> i & 1u) != 0 ? 0u : ((axis[1] >> i & 1u) != 0 ? 1u : 2u);
    }
};

/// Loads four floats of a ray; in vectors of eight also those of the fourth ray after it.
template <class D>
HWY_INLINE hn::Vec<D> load_blocks(D d, const Ray* const* rays, std::size_t part) {
    const float* const one = reinterpret_cast<const float*>(rays[0]) + part;
    if constexpr (hn::MaxLanes(D()) == 8) {
        const hn::Half<D> half;
        return hn::Combine(d, hn::LoadU(half, reinterpret_cast<const float*>(rays[4]) + part),
                           hn::LoadU(half, one));
    } else {
        return hn::LoadU(d, one);
    }
}

/// Loads and transposes four floats of each ray, starting at float `part`: one ray a lane.
HWY_INLINE void load_four(const Ray* const* rays, std::size_t part, Floats (&out)[4]) {
    const hn::Repartition<double, decltype(df)> dd;
    Floats row[4];
    for (std::size_t k = 0; k < 4; ++k) row[k] = load_blocks(df, rays + k, part);
    // Transpose within each block of four lanes.
    const auto low01 = hn::BitCast(dd, hn::InterleaveLower(df, row[0], row[1]));
    const auto low23 = hn::BitCast(dd, hn::InterleaveLower(df, row[2], row[3]));
    const auto up01 = hn::BitCast(dd, hn::InterleaveUpper(df, row[0], row[1]));
    const auto up23 = hn::BitCast(dd, hn::InterleaveUpper(df, row[2], row[3]));
    out[0] = hn::BitCast(df, hn::InterleaveLower(dd, low01, low23));
    out[1] = hn::BitCast(df, hn::InterleaveUpper(dd, low01, low23));
    out[2] = hn::BitCast(df, hn::InterleaveLower(dd, up01, up23));
    out[3] = hn::BitCast(df, hn::InterleaveUpper(dd, up01, up23));
}
static_assert(sizeof(Ray) == 32 && offsetof(Ray, tmin) == 12 && offsetof(Ray, direction) == 16 &&
              offsetof(Ray, tmax) == 28);

template <class V>
HWY_INLINE V max_of(V x, V y, V z) {
    return hn::Max(x, hn::Max(y, z));
}

/// Copies one vector of rays into a group.
HWY_INLINE void load(Group& group, std::size_t i, const Ray* const (&from)[lanes], Floats (&o)[4],
                     Floats (&d)[4]) {
    load_four(from, 0, o);
    load_four(from, 4, d);
    for (std::size_t k = 0; k < 3; ++k) {
        hn::Store(o[k], df, group.origin[k] + i);
        hn::Store(d[k], df, group.direction[k] + i);
    }
    hn::Store(o[3], df, group.tmin + i);
    hn::Store(d[3], df, group.limit + i);
}

/// Loads at most 64 consecutive rays and classifies them.
HWY_INLINE Signs load_tile(Group& group, const TreeConstants& constants, const Ray* rays, std::size_t count) {
    Signs signs;
    group.count = count;
    for (std::size_t i = 0; i < padded_count(count); i += lanes) {
        const Ray* from[lanes];
        for (std::size_t k = 0; k < lanes; ++k) from[k] = rays + (i + k < count ? i + k : count - 1);
        Floats o[4], d[4];
        load(group, i, from, o, d);
        const Floats ax = hn::Abs(d[0]), ay = hn::Abs(d[1]), az = hn::Abs(d[2]);
        const Floats longest = max_of(ax, ay, az);
        const Floats reach = max_of(hn::Abs(o[0]), hn::Abs(o[1]), hn::Abs(o[2]));
        // Comparisons fail for NaN, and the sum is NaN if any summand is.
        const Floats sum =
            hn::Add(hn::Add(ax, ay), hn::Add(hn::Add(az, o[0]), hn::Add(hn::Add(o[1], o[2]), d[3])));
        const Floats scale = hn::Add(reach, hn::Set(df, constants.corner));
        const auto long_enough = hn::And(hn::Ge(longest, hn::Mul(scale, hn::Set(df, min_direction_ratio))),
                                         hn::Ge(longest, hn::Set(df, min_length)));
        const auto near_enough = hn::And(hn::Le(longest, hn::Set(df, constants.max_length)),
                                         hn::Le(reach, hn::Set(df, constants.max_origin)));
        const auto grouped =
            hn::And(hn::And(long_enough, near_enough), hn::And(hn::Eq(sum, sum), hn::Eq(o[3], o[3])));
        signs.ungrouped |= std::uint64_t{~bits_of(grouped) & lane_mask} << i;
        const auto x_first = hn::Eq(ax, longest);
        signs.axis[0] |= std::uint64_t{bits_of(x_first)} << i;
        signs.axis[1] |= std::uint64_t{bits_of(hn::AndNot(x_first, hn::Eq(ay, longest)))} << i;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto below = hn::Lt(hn::BitCast(di, d[k]), hn::Zero(di));
            signs.negative[k] |= std::uint64_t{bits_of(hn::RebindMask(df, below))} << i;
        }
    }
    return signs;
}

/// Loads at most 64 rays given by index.
HWY_INLINE void load_numbered(Group& group, const Ray* rays, const std::uint32_t* numbers,
                              std::size_t count) {
    group.count = count;
    for (std::size_t i = 0; i < padded_count(count); i += lanes) {
        const Ray* from[lanes];
        for (std::size_t k = 0; k < lanes; ++k) from[k] = rays + numbers[i + k < count ? i + k : count - 1];
        Floats o[4], d[4];
        load(group, i, from, o, d);
    }
}

/// Overwrites one loaded ray with a copy of another.
HWY_INLINE void duplicate_ray(Group& group, std::size_t from, std::size_t to) {
    for (std::size_t k = 0; k < 3; ++k) {
        group.origin[k][to] = group.origin[k][from];
        group.direction[k][to] = group.direction[k][from];
    }
    group.tmin[to] = group.tmin[from];
    group.limit[to] = group.limit[from];
}

/// The next float below each, like next_float().
HWY_INLINE RayFloats one_below(RayFloats x) {
    const hn::RebindToSigned<decltype(dr)> dri;
    const auto bits = hn::BitCast(dri, x);
    const auto step = hn::Or(hn::BroadcastSignBit(hn::Not(bits)), hn::Set(dri, 1));
    const auto below_zero = hn::BitCast(dr, hn::Set(dri, static_cast<std::int32_t>(0x80000001u)));
    return hn::IfThenElse(hn::Eq(x, hn::Zero(dr)), below_zero, hn::BitCast(dr, hn::Add(bits, step)));
}

/// Computes the derived values of a loaded group without ungrouped rays. All rays are of one octant unless
/// `is_mixed`.
HWY_INLINE void set_up(Group& group, const TreeConstants& constants, bool is_mixed = false) {
    const hn::RebindToUnsigned<decltype(dr)> du;
    std::uint64_t first_axis[2] = {0, 0};
    RayFloats reaches = hn::Zero(dr);
    RayFloats starts = hn::Zero(dr);
    for (std::size_t i = 0; i < group.count; i += ray_lanes) {
        starts = hn::Min(starts, hn::Load(dr, group.tmin + i));
        RayFloats d[3], inverse[3], size[3];
        for (std::size_t k = 0; k < 3; ++k) {
            d[k] = hn::Load(dr, group.direction[k] + i);
            size[k] = hn::Abs(d[k]);
        }
        const RayFloats longest = max_of(size[0], size[1], size[2]);
        const RayFloats min_size = hn::Mul(longest, hn::Set(dr, min_direction_ratio));
        for (std::size_t k = 0; k < 3; ++k) {
            const RayFloats o = hn::Load(dr, group.origin[k] + i);
            reaches = hn::Max(reaches, hn::Abs(o));
            inverse[k] = hn::Div(hn::Set(dr, 1.0f), hn::CopySignToAbs(hn::Max(size[k], min_size), d[k]));
            hn::Store(inverse[k], dr, group.inverse[k] + i);
            hn::Store(hn::Neg(hn::Mul(o, inverse[k])), dr, group.offset[k] + i);
        }
        const auto x_first = hn::Eq(size[0], longest);
        const auto y_first = hn::AndNot(x_first, hn::Eq(size[1], longest));
        const auto cycle = [&](RayFloats for_x, RayFloats for_y, RayFloats for_z) {
            return hn::IfThenElse(x_first, for_x, hn::IfThenElse(y_first, for_y, for_z));
        };
        const RayFloats dz = cycle(d[0], d[1], d[2]);
        hn::Store(hn::Div(cycle(d[1], d[2], d[0]), dz), dr, group.shear_x + i);
        hn::Store(hn::Div(cycle(d[2], d[0], d[1]), dz), dr, group.shear_y + i);
        // The largest component is never clamped, so this is 1/dz.
        hn::Store(cycle(inverse[0], inverse[1], inverse[2]), dr, group.shear_z + i);
        first_axis[0] |= std::uint64_t{bits_of(dr, x_first)} << i;
        first_axis[1] |= std::uint64_t{bits_of(dr, y_first)} << i;
        hn::Store(one_below(hn::Load(dr, group.limit + i)), dr, group.limit + i);
        hn::Store(hn::Zero(dr), dr, group.u + i);
        hn::Store(hn::Zero(dr), dr, group.v + i);
        hn::Store(hn::Set(du, invalid_index), du, group.triangle + i);
    }
    group.reaches_back = bits_of(dr, hn::Lt(starts, hn::Zero(dr))) != 0;
    group.axis_rays[0] = first_axis[0];
    group.axis_rays[1] = first_axis[1];
    group.axis_rays[2] = ~(first_axis[0] | first_axis[1]);
    group.pad = 0x1p-20f * (hn::GetLane(hn::MaxOfLanes(dr, reaches)) + constants.corner);
    group.is_mixed = is_mixed;
    for (std::size_t k = 0; k < 3; ++k) {
        group.negative[k] = !is_mixed && std::signbit(group.direction[k][0]);
        group.grow[k] = group.negative[k] ? -group.pad : group.pad;
        group.near_at[k] = low_planes(k) + (group.negative[k] ? high_planes_offset : 0);
        group.far_at[k] = low_planes(k) + (group.negative[k] ? 0 : high_planes_offset);
    }
}

} // namespace
#endif
} // namespace HWY_NAMESPACE
} // namespace glint::trace
HWY_AFTER_NAMESPACE();

#endif
