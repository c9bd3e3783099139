// Bounds of the space swept by a group of rays, as a shaft or a box, for every SIMD target.

#include "trace/mesh/tree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "trace/simd/mesh_boxes-inl.h"

#if defined(GLINT_TRACE_SIMD_MESH_SHAFT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SIMD_MESH_SHAFT_INL_H
#undef GLINT_TRACE_SIMD_MESH_SHAFT_INL_H
#else
#define GLINT_TRACE_SIMD_MESH_SHAFT_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace glint::trace {
namespace HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR
namespace {

/// The space that a group's rays sweep between two planes perpendicular to their dominant axis, bounded by a
/// linear function on each of four sides. Rays are lines there, so lines through the extreme points on both
/// planes bound them all. All rays must have one dominant axis.
class Shaft {
  public:
    Shaft(const Group& group, const TreeConstants& constants, std::size_t kz)
        : kx(axis_after[kz]), ky(axis_before[kz]), kz(kz), end_of_rays_(group.count),
          backward_(group.negative[kz]) {
        const int axis = static_cast<int>(kz);
        start_ = backward_ ? constants.bounds.hi[axis] : constants.bounds.lo[axis];
        exit_ = backward_ ? constants.bounds.lo[axis] : constants.bounds.hi[axis];
        if (!group.reaches_back) start_within(group);
        slack_ = 4.0f * group.pad;
        shorten(group);
        bound_sides(group);
    }

    /// Moves the far plane to the largest extent of any ray.
    void shorten(const Group& group) {
        RayFloats max = hn::Set(dr, backward_ ? infinity : -infinity);
        for (std::size_t i = 0; i < end_of_rays_; i += ray_lanes) {
            const RayFloats point =
                hn::MulAdd(hn::Load(dr, group.limit + i), hn::Load(dr, group.direction[kz] + i),
                           hn::Load(dr, group.origin[kz] + i));
            max = backward_ ? hn::Min(max, point) : hn::Max(max, point);
        }
        end_ = backward_ ? std::max(exit_, hn::GetLane(hn::MinOfLanes(dr, max)))
                         : std::min(exit_, hn::GetLane(hn::MaxOfLanes(dr, max)));
    }

    /// The children that the shaft meets as bits, and their near depths.
    HWY_INLINE std::uint32_t meets(const float* node, const Group& group, float* keys) const {
        std::uint32_t met = 0;
        // Depth increases along the rays: flip signs if they go in the negative direction.
        const Floats turn = hn::Set(df, backward_ ? -0.0f : 0.0f);
        const Floats start = hn::Xor(turn, hn::Set(df, backward_ ? start_ + slack_ : start_ - slack_));
        const Floats end = hn::Xor(turn, hn::Set(df, backward_ ? end_ - slack_ : end_ + slack_));
        for (std::size_t i = 0; i < 8; i += lanes) {
            const Floats near = hn::Xor(turn, hn::Load(df, node + group.near_at[kz] + i));
            const Floats far = hn::Xor(turn, hn::Load(df, node + group.far_at[kz] + i));
            auto hit = hn::And(hn::Le(near, end), hn::Ge(far, start));
            for (std::size_t side = 0; side < 2; ++side) {
                const float* const planes = node + low_planes(side == 0 ? kx : ky) + i;
                const Floats min = low(side, hn::Load(df, node + low_at_[side] + i));
                const Floats max = high(side, hn::Load(df, node + high_at_[side] + i));
                hit = hn::And(hit, hn::And(hn::Ge(hn::Load(df, planes + high_planes_offset), min),
                                           hn::Le(hn::Load(df, planes), max)));
            }
            met |= bits_of(hit) << i;
            hn::Store(near, df, keys + i);
        }
        return met;
    }

    /// The triangles of a leaf, as bits, that are not entirely outside one of the four sides. Each side has a
    /// byte with the vertices outside of it, which is indexed by the vertices of each triangle.
    HWY_INLINE std::uint32_t candidates(const Leaf& leaf, const LeafVectors& vertices) const {
        std::uint32_t outside = 0;
        for (std::size_t i = 0; i < parts; ++i) {
            const std::size_t at = i * lanes;
            const Floats z = vertices.z[i];
            outside |= bits_of(hn::Lt(vertices.x[i], low(0, z))) << at |
                       bits_of(hn::Gt(vertices.x[i], high(0, z))) << (8 + at) |
                       bits_of(hn::Lt(vertices.y[i], low(1, z))) << (16 + at) |
                       bits_of(hn::Gt(vertices.y[i], high(1, z))) << (24 + at);
        }
        const hn::RebindToUnsigned<decltype(df)> du;
        const auto sides = hn::Set(du, outside);
        const auto seven = hn::Set(du, 7);
        std::uint32_t culled = 0;
        for (std::size_t i = 0; i < 8; i += lanes) {
            const auto words = hn::BitCast(du, corner_words(leaf, i));
            const auto a = hn::Shr(sides, hn::And(words, seven));
            const auto b = hn::Shr(sides, hn::And(hn::ShiftRight<3>(words), seven));
            const auto c = hn::Shr(sides, hn::ShiftRight<6>(words));
            const auto all = hn::And(hn::And(a, b), hn::And(c, hn::Set(du, 0x01010101u)));
            culled |= bits_of(hn::RebindMask(df, hn::Ne(all, hn::Zero(du)))) << i;
        }
        return ~culled & leaf.all();
    }

    const std::size_t kx, ky, kz;

  private:
    /// Moves the near plane to the first origin if that lies inside the tree.
    void start_within(const Group& group) {
        RayFloats first = hn::Set(dr, backward_ ? -infinity : infinity);
        for (std::size_t i = 0; i < end_of_rays_; i += ray_lanes) {
            const RayFloats o = hn::Load(dr, group.origin[kz] + i);
            first = backward_ ? hn::Max(first, o) : hn::Min(first, o);
        }
        start_ = backward_ ? std::min(start_, hn::GetLane(hn::MaxOfLanes(dr, first)))
                           : std::max(start_, hn::GetLane(hn::MinOfLanes(dr, first)));
    }

    HWY_INLINE Floats low(std::size_t side, Floats at) const {
        return hn::MulAdd(hn::Set(df, low_slope_[side]), at, hn::Set(df, low_base_[side]));
    }
    HWY_INLINE Floats high(std::size_t side, Floats at) const {
        return hn::MulAdd(hn::Set(df, high_slope_[side]), at, hn::Set(df, high_base_[side]));
    }

    void bound_sides(const Group& group) {
        const float length = end_ - start_;
        const bool sound = backward_ ? length < 0 : length > 0;
        for (std::size_t side = 0; side < 2; ++side) {
            float low[2], high[2];
            bound_side(group, side, low, high);
            const float low_slope = (low[1] - low[0]) / length;
            const float high_slope = (high[1] - high[0]) / length;
            const bool usable = sound && std::abs(low_slope) < 4.0f && std::abs(high_slope) < 4.0f;
            low_slope_[side] = usable ? low_slope : 0.0f;
            high_slope_[side] = usable ? high_slope : 0.0f;
            low_base_[side] = (usable ? low[0] - low_slope * start_ : std::min(low[0], low[1])) - 4 * slack_;
            high_base_[side] =
                (usable ? high[0] - high_slope * start_ : std::max(high[0], high[1])) + 4 * slack_;
            // Over a box a line is extremal at one end, which its slope determines.
            low_at_[side] = low_planes(kz) + (low_slope_[side] > 0 ? 0 : high_planes_offset);
            high_at_[side] = low_planes(kz) + (high_slope_[side] > 0 ? high_planes_offset : 0);
        }
    }

    /// The extreme coordinates of the rays on one axis where they cross both planes.
    void bound_side(const Group& group, std::size_t side, float (&low)[2], float (&high)[2]) const {
        const float* slope = side == 0 ? group.shear_x : group.shear_y;
        const float* origin = group.origin[side == 0 ? kx : ky];
        const RayFloats planes[2] = {hn::Set(dr, start_), hn::Set(dr, end_)};
        RayFloats min[2] = {hn::Set(dr, infinity), hn::Set(dr, infinity)};
        RayFloats max[2] = {hn::Set(dr, -infinity), hn::Set(dr, -infinity)};
        for (std::size_t i = 0; i < end_of_rays_; i += ray_lanes)
            for (std::size_t at = 0; at < 2; ++at) {
                const RayFloats way = hn::Sub(planes[at], hn::Load(dr, group.origin[kz] + i));
                const RayFloats point = hn::MulAdd(way, hn::Load(dr, slope + i), hn::Load(dr, origin + i));
                min[at] = hn::Min(min[at], point);
                max[at] = hn::Max(max[at], point);
            }
        for (std::size_t at = 0; at < 2; ++at) {
            low[at] = hn::GetLane(hn::MinOfLanes(dr, min[at]));
            high[at] = hn::GetLane(hn::MaxOfLanes(dr, max[at]));
        }
    }

    std::size_t end_of_rays_;
    bool backward_;
    float start_ = 0; ///< along the dominant axis
    float end_ = 0;
    float exit_ = 0; ///< far side of the tree
    float slack_ = 0;
    float low_slope_[2] = {}, low_base_[2] = {};
    float high_slope_[2] = {}, high_base_[2] = {};
    std::size_t low_at_[2] = {},
                high_at_[2] = {}; ///< offsets of the node planes at which the lines are evaluated
};

/// The bounding box of the segments of a group of rays of any octants.
class Sweep {
  public:
    Sweep(const Group& group, const TreeConstants& constants) {
        const float slack = 4.0f * group.pad;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            RayFloats min = hn::Set(dr, infinity);
            RayFloats max = hn::Set(dr, -infinity);
            for (std::size_t i = 0; i < group.count; i += ray_lanes) {
                const RayFloats o = hn::Load(dr, group.origin[axis] + i);
                const RayFloats d = hn::Load(dr, group.direction[axis] + i);
                const auto point_at = [&](RayFloats t) {
                    const RayFloats way = hn::Mul(d, t);
                    // 0 · ∞ is NaN: a zero component does not move.
                    return hn::Add(o, hn::IfThenElse(hn::Eq(way, way), way, hn::Zero(dr)));
                };
                const RayFloats begin = group.reaches_back ? point_at(hn::Load(dr, group.tmin + i)) : o;
                const RayFloats end = point_at(hn::Load(dr, group.limit + i));
                min = hn::Min(min, hn::Min(begin, end));
                max = hn::Max(max, hn::Max(begin, end));
            }
            // Sides beyond the tree need no bound, and large floats are coarse.
            const float low = hn::GetLane(hn::MinOfLanes(dr, min));
            const float high = hn::GetLane(hn::MaxOfLanes(dr, max));
            low_[axis] = low >= constants.bounds.lo[static_cast<int>(axis)] ? low - slack : -infinity;
            high_[axis] = high <= constants.bounds.hi[static_cast<int>(axis)] ? high + slack : infinity;
        }
    }

    /// The children that the box overlaps as bits.
    HWY_INLINE std::uint32_t meets(const float* node) const {
        std::uint32_t met = 0;
        for (std::size_t i = 0; i < 8; i += lanes) {
            const auto overlap = [&](std::size_t axis) {
                const float* const planes = node + low_planes(axis) + i;
                return hn::And(hn::Le(hn::Load(df, planes), hn::Set(df, high_[axis])),
                               hn::Ge(hn::Load(df, planes + high_planes_offset), hn::Set(df, low_[axis])));
            };
            // The inverted box of a missing child would overlap an unbounded box.
            const auto exists = hn::Le(hn::Load(df, node + i), hn::Load(df, node + high_planes_offset + i));
            met |= bits_of(hn::And(hn::And(overlap(0), overlap(1)), hn::And(overlap(2), exists))) << i;
        }
        return met;
    }

  private:
    float low_[3], high_[3];
};

} // namespace
#endif
} // namespace HWY_NAMESPACE
} // namespace glint::trace
HWY_AFTER_NAMESPACE();

#endif
