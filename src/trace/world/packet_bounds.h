#pragma once
// Where a batch of rays can be at all, so that what lies elsewhere is left out for all of them at once:
// interval arithmetic after Boulos, Wald, Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray
// Packets", 2006. Private to this room.

#include "bvh/float4.h"
#include "trace/world/data.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace glint::trace {

using bvh::float4;
using bvh::SimdBounds;
using bvh::splat;

/// Boxes around what a batch of rays is made of. A ray with an empty interval may be left out, and one with
/// NaN, as they hit nothing; elsewhere NaN stands for not knowing.
struct RayBoxes {
    SimdBounds starts;     ///< origins; in lane 3, tmin
    SimdBounds directions; ///< in lane 3, tmax
    SimdBounds ends;       ///< points at tmax, in float; may be left empty

    void add(const Ray& ray);
};

/// What rays of a batch can reach, from their origins to their tmax.
class PacketBounds {
  public:
    explicit PacketBounds(const RayBoxes& boxes);

    /// No ray can hit anything.
    bool empty() const { return empty_; }
    /// No ray hits the plane, by the arithmetic that tests it.
    bool misses(const PlanePrim& plane) const;
    /// No ray hits what lies within the box, nor its displacement by rounding (bvh/traverse.h) and by `slack`
    /// times the origin's largest |coordinate|.
    bool misses(const Bounds& box, float slack = 0) const;

  private:
    bool passes_by(const Bounds& box, double pad) const;

    SimdBounds starts_, directions_, ends_;
    double start_size_; ///< the largest |coordinate|
    double direction_size_;
    double end_pad_; ///< what `ends_` may have lost by rounding
    bool empty_;
    bool forward_; ///< no tmin is negative
    bool bounded_; ///< `ends_` is known, and finite
};

/// What of a world the rays of a batch may meet. Each of the first planes has a bit of its own, from the 64th
/// on they share the last one; quadrics likewise.
struct CullMask {
    std::uint64_t planes = 0;
    std::uint64_t quadrics = 0;
    bool triangles = false;

    bool nothing() const { return (planes | quadrics) == 0 && !triangles; }
    static bool has(std::uint64_t bits, std::size_t i) {
        return (bits >> std::min<std::size_t>(i, 63) & 1u) != 0;
    }
};

/// Quadrics that are tested one after another rather than through their tree.
inline constexpr std::size_t few_quadrics = 8;

/// `bounds` are the world's triangle_bounds().
CullMask cull(const WorldData& world, const TriangleBounds& bounds, const RayBoxes& boxes);

} // namespace glint::trace
