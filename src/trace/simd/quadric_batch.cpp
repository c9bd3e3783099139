// Batch kernels for planes and quadrics for every SIMD target: one shape at a time, vectors of rays in
// double.

#include "trace/simd/quadric_batch.h"
#include "trace/simd/flags.h"
#include "trace/world/packet_bounds.h"

#include <cstring>
#include <limits>

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/simd/quadric_batch.cpp"
#include <hwy/foreach_target.h> // IWYU pragma: keep

#include <hwy/highway.h>

#include "trace/simd/quadric_rays-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint::trace {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Slab test of rays against boxes within `bounds`, with the slack derived in bvh/traverse.h, plus `more`
/// times the origin's largest |coordinate|.
class BoxRays {
  public:
    HWY_INLINE BoxRays(const Rays& rays, const Bounds& bounds, float more = 0)
        : origin_(rays.line.origin), tmin_(rays.tmin) {
        const Vec& d = rays.line.direction;
        const real64 min_size = largest(d) * 1e-18;
        const auto inverse = [&](real64 along) {
            return real64(1.0) / hn::CopySign(fast_max(abs(along), min_size).v, along.v);
        };
        inverse_ = {inverse(d.x), inverse(d.y), inverse(d.z)};
        const real64 reach = largest(origin_);
        pad_ = (reach + double(bounds.max_coordinate())) * 0x1p-20;
        pad_ = pad_ + reach * double(more);
    }

    /// Rays that may hit the box between tmin and `limit`; `enter` returns the distance.
    HWY_INLINE truth meet(const Bounds& box, real64 limit, real64& enter) const {
        real64 leave = limit;
        enter = tmin_;
        slab(origin_.x, inverse_.x, box.lo.x, box.hi.x, enter, leave);
        slab(origin_.y, inverse_.y, box.lo.y, box.hi.y, enter, leave);
        slab(origin_.z, inverse_.z, box.lo.z, box.hi.z, enter, leave);
        return enter <= leave;
    }

  private:
    HWY_INLINE void slab(real64 from, real64 inverse, float lo, float hi, real64& enter,
                         real64& leave) const {
        const real64 one = (real64(double(lo)) - pad_ - from) * inverse;
        const real64 other = (real64(double(hi)) + pad_ - from) * inverse;
        enter = fast_max(enter, fast_min(one, other));
        leave = fast_min(leave, fast_max(one, other));
    }

    Vec origin_, inverse_;
    real64 tmin_, pad_;
};

truth in_general_quadric(const WorldData& world, const Quadric& quadric, const Lines& line, SolidSpan& span) {
    if (quadric.affine < 0) return line_in_quadric(quadric.shape, line.origin, line.direction, span);
    const Affine& affine = world.affines[static_cast<std::size_t>(quadric.affine)];
    return line_in_quadric(quadric.shape, transformed(affine.inverse, line.origin - affine.translation),
                           transformed(affine.inverse, line.direction), span);
}

/// Which lines meet a quadric, and where. Spheres without local space, the most common case, are inlined.
HWY_INLINE truth in_quadric(const WorldData& world, const Quadric& quadric, const Lines& line,
                            SolidSpan& span) {
    if (quadric.shape.kind == quadric_sphere && quadric.affine < 0)
        return line_in_ball(line.origin - quadric.shape.base, line.direction, quadric.shape.radius,
                            span.enter, span.leave);
    return in_general_quadric(world, quadric, line, span);
}

/// Whether a hit at `exact` counts, given its rounded t.
HWY_INLINE truth takes(const Rays& rays, truth met, real64 exact, real64 near) {
    return met && exact > rays.tmin && near < rays.tmax;
}

std::uint32_t bits_of(truth mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(dd, mask.m, bits);
    return bits[0];
}

Hit hit_of(const WorldData& world, std::size_t root) {
    const QuadricRef& name = world.surfaces[root / 2];
    return {0.0f, static_cast<float>(root % 2), 0.0f, name.object, name.prim, name.kind, false};
}

/// Keeps the least (t, root) of each ray.
struct ClosestHit {
    static constexpr bool bounds_ends = false; ///< whether bounding the rays' ends pays

    const Rays& rays;
    real64 t = infinity;
    real64 root = 0.0;

    HWY_INLINE void add(truth met, real64 exact, double number) {
        const real64 near = rounded(exact);
        const truth closer = near < t || (near == t && number < root);
        const truth better = takes(rays, met, exact, near) && closer;
        t = pick(better, near, t);
        root = pick(better, number, root);
    }
    bool done() const { return false; }
    real64 limit() const { return fast_min(t, rays.tmax); } ///< upper bound of t

    HWY_INLINE void write(const WorldData& world, Hit* hits, std::size_t count) const {
        const truth any = t < infinity;
        if (!any_lane(any)) {
            std::fill_n(hits, count, Hit{});
            return;
        }
        alignas(64) double ts[lanes], roots[lanes];
        hn::Store(t.v, dd, ts);
        hn::Store(root.v, dd, roots);
        // Neighbours mostly hit the same.
        if (all_lanes(any && root == roots[0])) {
            const Hit hit = hit_of(world, static_cast<std::size_t>(roots[0]));
            for (std::size_t k = 0; k < count; ++k) {
                hits[k] = hit;
                hits[k].t = static_cast<float>(ts[k]);
            }
            return;
        }
        for (std::size_t k = 0; k < count; ++k) {
            hits[k] = Hit{};
            if (!(ts[k] < infinity)) continue;
            hits[k] = hit_of(world, static_cast<std::size_t>(roots[k]));
            hits[k].t = static_cast<float>(ts[k]);
        }
    }
};

/// Determines which rays hit anything.
struct AnyHit {
    static constexpr bool bounds_ends = true;

    const Rays& rays;
    truth found = hn::FirstN(dd, 0);

    HWY_INLINE void add(truth met, real64 exact, double) {
        found = found || takes(rays, met, exact, rounded(exact));
    }
    bool done() const { return all_lanes(found); }
    real64 limit() const { return pick(found, -infinity, rays.tmax); }

    HWY_INLINE void write(const WorldData&, std::uint8_t* blocked, std::size_t count) const {
        write_flags(bits_of(found), blocked, count);
    }
};

template <class Sink>
HWY_INLINE void meet_plane(const PlanePrim& plane, const Lines& line, Sink& sink) {
    real64 t;
    const truth met =
        line_meets_plane(line.origin, line.direction, plane.plane.normal, plane.plane.offset, t);
    sink.add(met, t, 2.0 * plane.surface);
}

template <class Sink>
HWY_INLINE void meet_quadric(const WorldData& world, const Quadric& quadric, const Lines& line, Sink& sink) {
    SolidSpan span;
    const truth met = in_quadric(world, quadric, line, span);
    if (!any_lane(met)) return;
    sink.add(met, span.enter, 2.0 * quadric.surface);
    sink.add(met, span.leave, 2.0 * quadric.surface + 1.0);
}

/// Visits quadrics whose boxes are met by any of the rays, roughly nearest first, as neighbouring rays are
/// similar.
template <class Sink>
void meet_tree(const WorldData& world, const Rays& rays, Sink& sink) {
    const Tree& tree = world.quadric_tree;
    const BoxRays boxes(rays, tree.bounds);
    TreeRef stack[max_tree_depth + 1];
    std::size_t size = 0;
    stack[size++] = tree.root;
    while (size > 0 && !sink.done()) {
        const TreeRef at = stack[--size];
        if (at.count > 0) {
            for (std::size_t i = at.first; i < at.first + at.count && !sink.done(); ++i)
                meet_quadric(world, world.quadrics[i], rays.line, sink);
            continue;
        }
        const TreeNode& node = tree.nodes[at.first];
        real64 enter[2];
        bool met[2];
        for (std::size_t k = 0; k < 2; ++k)
            met[k] = any_lane(boxes.meet(child_box(node, k), sink.limit(), enter[k]));
        // Visit the child first that is nearer for the first ray.
        const int near = hn::GetLane(enter[1].v) < hn::GetLane(enter[0].v) ? 1 : 0;
        for (const int k : {1 - near, near})
            if (met[k]) stack[size++] = node.child[k];
    }
}

/// Tests a vector of rays against the planes and quadrics in the mask.
template <class Sink>
HWY_INLINE void meet_all(const WorldData& world, const CullMask& cull_mask, const Rays& rays, Sink& sink) {
    if (cull_mask.planes != 0)
        for (std::size_t i = 0; i < world.planes.size(); ++i)
            if (CullMask::has(cull_mask.planes, i)) meet_plane(world.planes[i], rays.line, sink);
    if (cull_mask.quadrics == 0) return;
    if (world.quadrics.size() > few_quadrics) return meet_tree(world, rays, sink);
    for (std::size_t i = 0; i < world.quadrics.size() && !sink.done(); ++i)
        if (CullMask::has(cull_mask.quadrics, i)) meet_quadric(world, world.quadrics[i], rays.line, sink);
}

HWY_INLINE std::uint32_t packet_meets_mesh(const CullMask& cull_mask, const TriangleBounds& bounds,
                                           const Rays& rays, real64 limit) {
    if (!cull_mask.triangles) return 0u;
    real64 enter;
    return bits_of(BoxRays(rays, bounds.box, bounds.slack).meet(bounds.box, limit, enter));
}

#if HWY_TARGET == HWY_SCALAR
template <bool ends>
RayBoxes boxes_of(const Ray* rays, std::size_t count) {
    RayBoxes boxes;
    std::for_each(rays, rays + count, [&](const Ray& ray) { boxes.add(ray); });
    return boxes;
}
#else
/// Minimum and maximum of each lane.
struct Extremes {
    Halves lo, hi;

    HWY_INLINE Extremes() {
        lo = hn::Set(halves, std::numeric_limits<float>::infinity());
        hi = hn::Neg(lo);
    }
    HWY_INLINE void grow(Halves x) {
        lo = hn::Min(x, lo);
        hi = hn::Max(x, hi);
    }
    HWY_INLINE void grow(hn::Mask<decltype(halves)> where, Halves x) {
        lo = hn::Min(hn::IfThenElse(where, x, lo), lo);
        hi = hn::Max(hn::IfThenElse(where, x, hi), hi);
    }
    /// Stores the extremes of the even or the odd lanes.
    void store(std::size_t odd, int axis, SimdBounds& box) const {
        alignas(64) float lowest[hn::MaxLanes(halves)], highest[hn::MaxLanes(halves)];
        hn::Store(lo, halves, lowest);
        hn::Store(hi, halves, highest);
        float a = lowest[odd];
        float b = highest[odd];
        for (std::size_t k = odd; k < hn::MaxLanes(halves); k += 2) {
            a = std::min(lowest[k], a);
            b = std::max(highest[k], b);
        }
        box.lo[axis] = a;
        box.hi[axis] = b;
    }
};

/// Origins are in the even lanes, directions in the odd ones, as in LoadedRays.
template <bool ends>
RayBoxes boxes_of(const Ray* rays, std::size_t count) {
    Extremes all[4], last[3];
    for_vectors(rays, count, [&](std::size_t, std::size_t, const Ray* some) {
        Halves of[4];
        hn::LoadInterleaved4(halves, &some->origin.x, of[0], of[1], of[2], of[3]);
        const Halves tmax = hn::DupOdd(of[3]);
        const auto live = hn::Lt(hn::DupEven(of[3]), tmax);
        const bool whole = hn::AllTrue(halves, live);
        for (std::size_t i = 0; i < 4; ++i) whole ? all[i].grow(of[i]) : all[i].grow(live, of[i]);
        for (std::size_t i = 0; ends && i < 3; ++i) {
            const Halves end = hn::Add(of[i], hn::Mul(hn::DupOdd(of[i]), tmax));
            whole ? last[i].grow(end) : last[i].grow(live, end);
        }
    });
    RayBoxes boxes;
    for (std::size_t i = 0; i < 4; ++i) {
        all[i].store(0, static_cast<int>(i), boxes.starts);
        all[i].store(1, static_cast<int>(i), boxes.directions);
    }
    for (std::size_t i = 0; ends && i < 3; ++i) last[i].store(0, static_cast<int>(i), boxes.ends);
    return boxes;
}
#endif

/// Traces rays in vectors, with a Sink for each, and culls for batches of them.
template <class Sink, class Result>
void trace_in_vectors(const WorldData& world, const Ray* rays, std::size_t count, Result* results,
                      std::uint8_t* meets_mesh) {
    // A square of 8 x 8 pixels: longer batches cover more space, shorter ones are culled too often.
    constexpr std::size_t batch = 64;
    const TriangleBounds bounds = triangle_bounds(world);
    for (std::size_t begin = 0; begin < count; begin += batch) {
        const std::size_t size = std::min(batch, count - begin);
        const CullMask cull_mask = cull(world, bounds, boxes_of<Sink::bounds_ends>(rays + begin, size));
        if (cull_mask.nothing()) {
            std::fill_n(results + begin, size, Result{});
            std::memset(meets_mesh + begin, 0, size);
            continue;
        }
        for_vectors(rays + begin, size, [&](std::size_t first, std::size_t n, const Ray* some) {
            const Rays vector(some);
            Sink sink{vector};
            meet_all(world, cull_mask, vector, sink);
            const std::uint32_t meshes = packet_meets_mesh(cull_mask, bounds, vector, sink.limit());
            sink.write(world, results + begin + first, n);
            write_flags(meshes, meets_mesh + begin + first, n);
        });
    }
}

void closest_in_vectors(const WorldData& world, const Ray* rays, std::size_t count, Hit* hits,
                        std::uint8_t* meets_mesh) {
    trace_in_vectors<ClosestHit>(world, rays, count, hits, meets_mesh);
}

void occluded_in_vectors(const WorldData& world, const Ray* rays, std::size_t count, std::uint8_t* blocked,
                         std::uint8_t* meets_mesh) {
    trace_in_vectors<AnyHit>(world, rays, count, blocked, meets_mesh);
}

} // namespace

extern const QuadricKernels quadrics{closest_in_vectors, occluded_in_vectors};

} // namespace HWY_NAMESPACE
} // namespace glint::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glint::trace {

const KernelTable<QuadricKernels> quadric_kernels GLINT_KERNEL_TABLE(quadrics);

} // namespace glint::trace
#endif
