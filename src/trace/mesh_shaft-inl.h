// The space that a group's rays sweep, as a shaft or a box, for every SIMD target.

#include "trace/mesh_tree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "trace/mesh_boxes-inl.h"

#if defined(GLINT_TRACE_MESH_SHAFT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_MESH_SHAFT_INL_H
#undef GLINT_TRACE_MESH_SHAFT_INL_H
#else
#define GLINT_TRACE_MESH_SHAFT_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR
namespace {

/// The space that a group's rays sweep between two planes square to their dominant axis, bounded by a
/// straight line on each of four sides. Each ray is a line there, so lines through the outermost places on
/// both planes bound them all. The group must be of one dominant axis.
class Shaft {
  public:
    Shaft(const Group& group, const Frame& frame, std::size_t kz)
        : kx(axis_after[kz]), ky(axis_before[kz]), kz(kz), end_of_rays_(group.count),
          backward_(group.negative[kz]) {
        const int axis = static_cast<int>(kz);
        start_ = backward_ ? frame.bounds.hi[axis] : frame.bounds.lo[axis];
        leave_ = backward_ ? frame.bounds.lo[axis] : frame.bounds.hi[axis];
        if (!group.reaches_back) start_within(group);
        slack_ = 4.0f * group.pad;
        shorten(group);
        bound_sides(group);
    }

    /// Moves the far end to the farthest place that any ray still wants.
    void shorten(const Group& group) {
        RayFloats most = hn::Set(dr, backward_ ? infinity : -infinity);
        for (std::size_t i = 0; i < end_of_rays_; i += ray_lanes) {
            const RayFloats place =
                hn::MulAdd(hn::Load(dr, group.limit + i), hn::Load(dr, group.direction[kz] + i),
                           hn::Load(dr, group.origin[kz] + i));
            most = backward_ ? hn::Min(most, place) : hn::Max(most, place);
        }
        end_ = backward_ ? std::max(leave_, hn::GetLane(hn::MinOfLanes(dr, most)))
                         : std::min(leave_, hn::GetLane(hn::MaxOfLanes(dr, most)));
    }

    /// The children of a node that the shaft meets, as bits, and where they begin.
    HWY_INLINE std::uint32_t meets(const float* node, const Group& group, float* keys) const {
        std::uint32_t met = 0;
        // Depths count along the rays: what goes backward is turned over.
        const Floats turn = hn::Set(df, backward_ ? -0.0f : 0.0f);
        const Floats start = hn::Xor(turn, hn::Set(df, backward_ ? start_ + slack_ : start_ - slack_));
        const Floats end = hn::Xor(turn, hn::Set(df, backward_ ? end_ - slack_ : end_ + slack_));
        for (std::size_t i = 0; i < 8; i += lanes) {
            const Floats near = hn::Xor(turn, hn::Load(df, node + group.near_at[kz] + i));
            const Floats far = hn::Xor(turn, hn::Load(df, node + group.far_at[kz] + i));
            auto hit = hn::And(hn::Le(near, end), hn::Ge(far, start));
            for (std::size_t side = 0; side < 2; ++side) {
                const float* const planes = node + low_planes(side == 0 ? kx : ky) + i;
                const Floats least = low(side, hn::Load(df, node + low_at_[side] + i));
                const Floats most = high(side, hn::Load(df, node + high_at_[side] + i));
                hit = hn::And(hit, hn::And(hn::Ge(hn::Load(df, planes + between_planes), least),
                                           hn::Le(hn::Load(df, planes), most)));
            }
            met |= bits_of(hit) << i;
            hn::Store(near, df, keys + i);
        }
        return met;
    }

    /// The triangles of a leaf that do not lie beyond one of the four sides, as bits: which of the vertices
    /// do is one byte a side, looked up for three vertices a triangle.
    HWY_INLINE std::uint32_t keeps(const Leaf& leaf, const LeafVectors& vertices) const {
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
    /// Rays that start inside the tree begin there.
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
            reach(group, side, low, high);
            const float low_slope = (low[1] - low[0]) / length;
            const float high_slope = (high[1] - high[0]) / length;
            const bool usable = sound && std::abs(low_slope) < 4.0f && std::abs(high_slope) < 4.0f;
            low_slope_[side] = usable ? low_slope : 0.0f;
            high_slope_[side] = usable ? high_slope : 0.0f;
            low_base_[side] = (usable ? low[0] - low_slope * start_ : std::min(low[0], low[1])) - 4 * slack_;
            high_base_[side] =
                (usable ? high[0] - high_slope * start_ : std::max(high[0], high[1])) + 4 * slack_;
            // A line is lowest, or highest, at one end of a box, by its slope alone.
            low_at_[side] = low_planes(kz) + (low_slope_[side] > 0 ? 0 : between_planes);
            high_at_[side] = low_planes(kz) + (high_slope_[side] > 0 ? between_planes : 0);
        }
    }

    /// The outermost rays on one side where they pass the two planes.
    void reach(const Group& group, std::size_t side, float (&low)[2], float (&high)[2]) const {
        const float* slope = side == 0 ? group.shear_x : group.shear_y;
        const float* origin = group.origin[side == 0 ? kx : ky];
        const RayFloats planes[2] = {hn::Set(dr, start_), hn::Set(dr, end_)};
        RayFloats least[2] = {hn::Set(dr, infinity), hn::Set(dr, infinity)};
        RayFloats most[2] = {hn::Set(dr, -infinity), hn::Set(dr, -infinity)};
        for (std::size_t i = 0; i < end_of_rays_; i += ray_lanes)
            for (std::size_t at = 0; at < 2; ++at) {
                const RayFloats way = hn::Sub(planes[at], hn::Load(dr, group.origin[kz] + i));
                const RayFloats place = hn::MulAdd(way, hn::Load(dr, slope + i), hn::Load(dr, origin + i));
                least[at] = hn::Min(least[at], place);
                most[at] = hn::Max(most[at], place);
            }
        for (std::size_t at = 0; at < 2; ++at) {
            low[at] = hn::GetLane(hn::MinOfLanes(dr, least[at]));
            high[at] = hn::GetLane(hn::MaxOfLanes(dr, most[at]));
        }
    }

    std::size_t end_of_rays_;
    bool backward_;
    float start_ = 0; ///< along the dominant axis
    float end_ = 0;
    float leave_ = 0; ///< where the tree ends
    float slack_ = 0;
    float low_slope_[2] = {}, low_base_[2] = {};
    float high_slope_[2] = {}, high_base_[2] = {};
    std::size_t low_at_[2] = {}, high_at_[2] = {}; ///< the planes of a node where the lines are compared
};

/// The box that a group's rays sweep, whatever their octants and axes.
class Sweep {
  public:
    Sweep(const Group& group, const Frame& frame) {
        const float slack = 4.0f * group.pad;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            RayFloats least = hn::Set(dr, infinity);
            RayFloats most = hn::Set(dr, -infinity);
            for (std::size_t i = 0; i < group.count; i += ray_lanes) {
                const RayFloats o = hn::Load(dr, group.origin[axis] + i);
                const RayFloats d = hn::Load(dr, group.direction[axis] + i);
                const auto place = [&](RayFloats t) {
                    const RayFloats way = hn::Mul(d, t);
                    // Without a limit, what stands still would go NaN far.
                    return hn::Add(o, hn::IfThenElse(hn::Eq(way, way), way, hn::Zero(dr)));
                };
                const RayFloats begin = group.reaches_back ? place(hn::Load(dr, group.tmin + i)) : o;
                const RayFloats end = place(hn::Load(dr, group.limit + i));
                least = hn::Min(least, hn::Min(begin, end));
                most = hn::Max(most, hn::Max(begin, end));
            }
            // Beyond the tree there is nothing to be told apart, and floats are coarse.
            const float low = hn::GetLane(hn::MinOfLanes(dr, least));
            const float high = hn::GetLane(hn::MaxOfLanes(dr, most));
            low_[axis] = low >= frame.bounds.lo[static_cast<int>(axis)] ? low - slack : -infinity;
            high_[axis] = high <= frame.bounds.hi[static_cast<int>(axis)] ? high + slack : infinity;
        }
    }

    /// The children of a node that the box meets, as bits.
    HWY_INLINE std::uint32_t meets(const float* node) const {
        std::uint32_t met = 0;
        for (std::size_t i = 0; i < 8; i += lanes) {
            const auto overlap = [&](std::size_t axis) {
                const float* const planes = node + low_planes(axis) + i;
                return hn::And(hn::Le(hn::Load(df, planes), hn::Set(df, high_[axis])),
                               hn::Ge(hn::Load(df, planes + between_planes), hn::Set(df, low_[axis])));
            };
            // The inverted box of a missing child overlaps a box without bounds.
            const auto exists = hn::Le(hn::Load(df, node + i), hn::Load(df, node + between_planes + i));
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
} // namespace glint
HWY_AFTER_NAMESPACE();

#endif
