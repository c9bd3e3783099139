#pragma once
// Packet culling: conservative bounds of the space reached by a batch of rays, by interval arithmetic after
// Boulos, Wald, Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray Packets", 2006. Private to
// this room.

#include "bvh/float4.h"
#include "trace/world/data.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace glint::trace {

/// Bounds of the components of a batch of rays. Rays with an empty interval or NaN may be omitted, as they
/// hit nothing; otherwise NaN means unknown.
struct RayBoxes {
    SimdBounds starts;     ///< origins; in lane 3, tmin
    SimdBounds directions; ///< in lane 3, tmax
    SimdBounds ends;       ///< points at tmax, in float; may be left empty

    void add(const Ray& ray);
};

/// Bounds of the space reached by a batch of rays, from their origins to tmax.
class PacketBounds {
  public:
    explicit PacketBounds(const RayBoxes& boxes);

    /// Whether no ray can hit anything.
    bool empty() const { return empty_; }
    /// Whether no ray hits the plane, by the arithmetic of the plane test.
    bool misses(const PlanePrim& plane) const;
    /// Whether no ray hits anything in the box, grown by rounding (bvh/traverse.h) and by `slack` times the
    /// origin's largest |coordinate|.
    bool misses(const Bounds& box, float slack = 0) const;

  private:
    bool passes_by(const Bounds& box, double pad) const;

    SimdBounds starts_, directions_, ends_;
    double start_size_; ///< largest |coordinate|
    double direction_size_;
    double end_pad_; ///< rounding error of `ends_`
    bool empty_;
    bool forward_; ///< no tmin is negative
    bool bounded_; ///< `ends_` is known and finite
};

/// The primitives that a batch of rays may hit. The first 63 planes have a bit each, the rest share the last
/// one; likewise quadrics.
struct CullMask {
    std::uint64_t planes = 0;
    std::uint64_t quadrics = 0;
    bool triangles = false;

    bool nothing() const { return (planes | quadrics) == 0 && !triangles; }
    static bool has(std::uint64_t bits, std::size_t i) {
        return (bits >> std::min<std::size_t>(i, 63) & 1u) != 0;
    }
};

/// Up to this number, quadrics are tested without a tree.
inline constexpr std::size_t few_quadrics = 8;

/// `bounds` are the world's triangle_bounds().
CullMask cull(const WorldData& world, const TriangleBounds& bounds, const RayBoxes& boxes);

} // namespace glint::trace
