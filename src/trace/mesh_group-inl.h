// Up to 64 rays of one class, how they pass eight boxes, and the shaft around them, for every SIMD target.

#include "math/offset.shared.h"
#include "trace/mesh_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include <hwy/highway.h>

#include "trace/mesh_leaf-inl.h"

#if defined(GLINT_TRACE_MESH_GROUP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_MESH_GROUP_INL_H
#undef GLINT_TRACE_MESH_GROUP_INL_H
#else
#define GLINT_TRACE_MESH_GROUP_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR
namespace {

constexpr std::size_t group_rays = 64;
constexpr std::uint32_t lane_mask = (1u << lanes) - 1u;

std::size_t first_bit(std::uint64_t mask) { return static_cast<std::size_t>(std::countr_zero(mask)); }

/// Up to 64 rays of one class, side by side.
struct alignas(64) Group {
    float origin[3][group_rays];
    float inverse[3][group_rays];     ///< 1/direction, never infinite
    float near_offset[3][group_rays]; ///< −origin · inverse − pad · |inverse|
    float far_offset[3][group_rays];  ///< −origin · inverse + pad · |inverse|
    float shear_x[group_rays];
    float shear_y[group_rays];
    float shear_z[group_rays];
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

} // namespace
#endif
} // namespace HWY_NAMESPACE
} // namespace glint
HWY_AFTER_NAMESPACE();

#endif
