// Planes, spheres and cylinders for every SIMD target: one shape at a time, as many rays at once as doubles
// fit into a vector.

#include "trace/surface_batch.h"
#include "trace/flags.h"
#include "trace/reach.h"

#include <cstring>
#include <limits>

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/surface_batch.cpp"
#include <hwy/foreach_target.h> // IWYU pragma: keep

#include <hwy/highway.h>

#include "trace/surface_rays-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Rays against boxes that lie within `bounds`, with the slack that bvh/traverse.h derives, and `more` times
/// the origin's largest |coordinate|.
class BoxRays {
  public:
    HWY_INLINE BoxRays(const Rays& rays, const Bounds& bounds, float more = 0)
        : origin_(rays.line.origin), tmin_(rays.tmin) {
        const Vec& d = rays.line.direction;
        const Doubles most = hn::Max(hn::Abs(d.x), hn::Max(hn::Abs(d.y), hn::Abs(d.z)));
        const Doubles least = hn::Mul(most, all(1e-18));
        const auto inverse = [&](Doubles along) {
            return hn::Div(all(1.0), hn::CopySign(hn::Max(hn::Abs(along), least), along));
        };
        inverse_ = {inverse(d.x), inverse(d.y), inverse(d.z)};
        const Vec& o = origin_;
        const Doubles reach = hn::Max(hn::Abs(o.x), hn::Max(hn::Abs(o.y), hn::Abs(o.z)));
        const vec3 far = glm::max(glm::abs(bounds.lo), glm::abs(bounds.hi));
        pad_ = hn::Mul(all(0x1p-20), hn::Add(reach, all(std::max({far.x, far.y, far.z}))));
        pad_ = hn::Add(pad_, hn::Mul(all(double(more)), reach));
    }

    /// Which rays may meet the box between their tmin and `limit`; `enter` says where.
    HWY_INLINE Mask meet(const vec3& lo, const vec3& hi, Doubles limit, Doubles& enter) const {
        Doubles leave = limit;
        enter = tmin_;
        slab(origin_.x, inverse_.x, lo.x, hi.x, enter, leave);
        slab(origin_.y, inverse_.y, lo.y, hi.y, enter, leave);
        slab(origin_.z, inverse_.z, lo.z, hi.z, enter, leave);
        return hn::Le(enter, leave);
    }

  private:
    HWY_INLINE void slab(Doubles from, Doubles inverse, float lo, float hi, Doubles& enter,
                         Doubles& leave) const {
        const Doubles one = hn::Mul(hn::Sub(hn::Sub(all(double(lo)), pad_), from), inverse);
        const Doubles other = hn::Mul(hn::Sub(hn::Add(all(double(hi)), pad_), from), inverse);
        enter = hn::Max(enter, hn::Min(one, other));
        leave = hn::Min(leave, hn::Max(one, other));
    }

    Vec origin_, inverse_;
    Doubles tmin_, pad_;
};

Vec across(const Vec& axis, const Vec& v) { return v - axis * dot(axis, v); }

/// The solid cylinder of geometry/quadric.cpp. False if all lines miss.
bool in_cylinder(const Lines& line, const Cylinder& cylinder, Inside& in) {
    const Vec axis = all(cylinder.axis);
    const Vec from_base = line.origin - all(cylinder.base);
    if (!in_ball(across(axis, from_base), across(axis, line.direction), cylinder.radius, in)) return false;

    const Doubles zero = hn::Zero(dd);
    const Doubles height = all(cylinder.height);
    const Doubles infinity = all(std::numeric_limits<double>::infinity());
    const Doubles h = dot(axis, from_base);
    const Doubles rise = dot(axis, line.direction);
    const Mask level = hn::Eq(rise, zero);
    const Mask reversed = hn::Lt(rise, zero);
    const Doubles at_base = hn::Div(hn::Neg(h), rise);
    const Doubles at_top = hn::Div(hn::Sub(height, h), rise);
    const Doubles first =
        hn::IfThenElse(level, hn::Sub(zero, infinity), hn::IfThenElse(reversed, at_top, at_base));
    const Doubles last = hn::IfThenElse(level, infinity, hn::IfThenElse(reversed, at_base, at_top));
    const Mask outside = hn::And(level, hn::Not(hn::And(hn::Ge(h, zero), hn::Le(h, height))));

    in.enter = hn::IfThenElse(hn::Gt(in.enter, first), in.enter, first);
    in.leave = hn::IfThenElse(hn::Lt(in.leave, last), in.leave, last);
    in.met = hn::AndNot(outside, hn::And(in.met, hn::Le(in.enter, in.leave)));
    return true;
}

bool in_special(const WorldData& world, const Quadric& quadric, Lines line, Inside& in) {
    if (quadric.affine >= 0) {
        const Affine& affine = world.affines[static_cast<std::size_t>(quadric.affine)];
        line = {transformed(affine.inverse, line.origin - all(affine.translation)),
                transformed(affine.inverse, line.direction)};
    }
    if (quadric.kind == PrimKind::cylinder) return in_cylinder(line, quadric.shape, in);
    return in_ball(line.origin - all(quadric.shape.base), line.direction, quadric.shape.radius, in);
}

/// Most are plain spheres: they need no call.
HWY_INLINE bool in_quadric(const WorldData& world, const Quadric& quadric, const Lines& line, Inside& in) {
    if (quadric.kind == PrimKind::sphere && quadric.affine < 0)
        return in_ball(line.origin - all(quadric.shape.base), line.direction, quadric.shape.radius, in);
    return in_special(world, quadric, line, in);
}

/// Does a hit at `exact` count, its t rounded to float?
HWY_INLINE Mask takes(const Rays& rays, Mask met, Doubles exact, Doubles near) {
    return hn::And(met, hn::And(hn::Gt(exact, rays.tmin), hn::Lt(near, rays.tmax)));
}

/// Keeps the least (t, root) of each ray.
struct Least {
    const Rays& rays;
    Doubles t = all(std::numeric_limits<double>::infinity());
    Doubles root = hn::Zero(dd);

    HWY_INLINE void add(Mask met, Doubles exact, double number) {
        const Doubles near = rounded(exact);
        const Doubles it = all(number);
        const Mask closer = hn::Or(hn::Lt(near, t), hn::And(hn::Eq(near, t), hn::Lt(it, root)));
        const Mask better = hn::And(takes(rays, met, exact, near), closer);
        t = hn::IfThenElse(better, near, t);
        root = hn::IfThenElse(better, it, root);
    }
    bool done() const { return false; }
    Doubles limit() const { return hn::Min(t, rays.tmax); } ///< beyond it nothing counts
};

/// Finds which rays meet anything.
struct AnyHit {
    const Rays& rays;
    Mask found = hn::FirstN(dd, 0);

    HWY_INLINE void add(Mask met, Doubles exact, double) {
        found = hn::Or(found, takes(rays, met, exact, rounded(exact)));
    }
    bool done() const { return hn::AllTrue(dd, found); }
    Doubles limit() const {
        return hn::IfThenElse(found, all(-std::numeric_limits<double>::infinity()), rays.tmax);
    }
};

template <class Sink>
HWY_INLINE void meet_plane(const NumberedPlane& numbered, const Lines& line, Sink& sink) {
    const Vec normal = all(numbered.plane.normal);
    const Doubles fall = dot(normal, line.direction);
    const Doubles t = hn::Div(hn::Sub(all(numbered.plane.offset), dot(normal, line.origin)), fall);
    sink.add(hn::Ne(fall, hn::Zero(dd)), t, 2.0 * numbered.surface);
}

template <class Sink>
HWY_INLINE void meet_quadric(const WorldData& world, const Quadric& quadric, const Lines& line, Sink& sink) {
    Inside in;
    if (!in_quadric(world, quadric, line, in)) return;
    sink.add(in.met, in.enter, 2.0 * quadric.surface);
    sink.add(in.met, in.leave, 2.0 * quadric.surface + 1.0);
}

/// The quadrics whose boxes any of the rays meets, roughly nearest first: neighbours go nearly the same way.
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
        Doubles enter[2];
        Mask met[2];
        for (int k = 0; k < 2; ++k)
            met[k] = boxes.meet(vec3(node.lo[0][k], node.lo[1][k], node.lo[2][k]),
                                vec3(node.hi[0][k], node.hi[1][k], node.hi[2][k]), sink.limit(), enter[k]);
        // What the first ray meets first is looked at first.
        const int near = hn::GetLane(enter[1]) < hn::GetLane(enter[0]) ? 1 : 0;
        for (const int k : {1 - near, near})
            if (!hn::AllFalse(dd, met[k])) stack[size++] = node.child[k];
    }
}

/// The planes ahead, and what quadrics lie in the way of one vector of rays.
template <class Sink>
HWY_INLINE void meet_all(const WorldData& world, const Ahead& ahead, const Rays& rays, Sink& sink) {
    if (ahead.planes != 0)
        for (std::size_t i = 0; i < world.planes.size(); ++i)
            if (Ahead::has(ahead.planes, i)) meet_plane(world.planes[i], rays.line, sink);
    if (ahead.quadrics == 0) return;
    if (world.quadrics.size() > few_quadrics) return meet_tree(world, rays, sink);
    for (std::size_t i = 0; i < world.quadrics.size() && !sink.done(); ++i)
        if (Ahead::has(ahead.quadrics, i)) meet_quadric(world, world.quadrics[i], rays.line, sink);
}

std::uint32_t bits_of(Mask mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(dd, mask, bits);
    return bits[0];
}

HWY_INLINE std::uint32_t mesh_ahead_of(const Ahead& ahead, const TriangleBounds& bounds, const Rays& rays,
                                       Doubles limit) {
    if (!ahead.triangles) return 0u;
    Doubles enter;
    return bits_of(BoxRays(rays, bounds.box, bounds.slack).meet(bounds.box.lo, bounds.box.hi, limit, enter));
}

#if HWY_TARGET == HWY_SCALAR
template <bool ends>
RayBoxes boxes_of(const Ray* rays, std::size_t count) {
    RayBoxes boxes;
    std::for_each(rays, rays + count, [&](const Ray& ray) { boxes.add(ray); });
    return boxes;
}
#else
/// The least and the greatest of each lane.
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
    /// What the even lanes, or the odd ones, have found.
    void give(std::size_t odd, int axis, SimdBounds& box) const {
        alignas(64) float least[hn::MaxLanes(halves)], greatest[hn::MaxLanes(halves)];
        hn::Store(lo, halves, least);
        hn::Store(hi, halves, greatest);
        float a = least[odd];
        float b = greatest[odd];
        for (std::size_t k = odd; k < hn::MaxLanes(halves); k += 2) {
            a = std::min(least[k], a);
            b = std::max(greatest[k], b);
        }
        box.lo[axis] = a;
        box.hi[axis] = b;
    }
};

/// Origins in the even lanes, directions in the odd ones, as LoadedRays finds them.
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
        all[i].give(0, static_cast<int>(i), boxes.starts);
        all[i].give(1, static_cast<int>(i), boxes.directions);
    }
    for (std::size_t i = 0; ends && i < 3; ++i) last[i].give(0, static_cast<int>(i), boxes.ends);
    return boxes;
}
#endif

Hit hit_of(const WorldData& world, std::size_t root) {
    const SurfaceName& name = world.surfaces[root / 2];
    return {0.0f, static_cast<float>(root % 2), 0.0f, name.object, name.prim, name.kind, false};
}

/// The hits that a vector of rays has found.
HWY_INLINE void write_hits(const WorldData& world, const Least& least, Hit* hits, std::size_t count) {
    const Mask any = hn::Lt(least.t, all(std::numeric_limits<double>::infinity()));
    if (hn::AllFalse(dd, any)) {
        std::fill_n(hits, count, Hit{});
        return;
    }
    alignas(64) double t[lanes], root[lanes];
    hn::Store(least.t, dd, t);
    hn::Store(least.root, dd, root);
    // Neighbours mostly hit the same.
    if (hn::AllTrue(dd, hn::And(any, hn::Eq(least.root, all(root[0]))))) {
        const Hit hit = hit_of(world, static_cast<std::size_t>(root[0]));
        for (std::size_t k = 0; k < count; ++k) {
            hits[k] = hit;
            hits[k].t = static_cast<float>(t[k]);
        }
        return;
    }
    for (std::size_t k = 0; k < count; ++k) {
        hits[k] = Hit{};
        if (!(t[k] < std::numeric_limits<double>::infinity())) continue;
        hits[k] = hit_of(world, static_cast<std::size_t>(root[k]));
        hits[k].t = static_cast<float>(t[k]);
    }
}

/// Hands each vector of rays to use(first, count, rays, ahead), and those of whose batch nothing is ahead to
/// none(first, count). `ends` says whether the rays' ends are worth knowing.
template <bool ends, class None, class Use>
HWY_INLINE void for_vectors_ahead(const WorldData& world, const TriangleBounds& bounds, const Ray* rays,
                                  std::size_t count, None&& none, Use&& use) {
    // A square of 8 x 8 pixels: longer batches reach further, shorter ones are weighed too often.
    constexpr std::size_t batch = 64;
    for (std::size_t begin = 0; begin < count; begin += batch) {
        const std::size_t size = std::min(batch, count - begin);
        const Ahead ahead = ahead_of(world, bounds, boxes_of<ends>(rays + begin, size));
        if (ahead.nothing())
            none(begin, size);
        else
            for_vectors(rays + begin, size, [&](std::size_t first, std::size_t n, const Ray* some) {
                use(begin + first, n, Rays(some), ahead);
            });
    }
}

} // namespace

// What the dispatcher calls: anonymous functions cannot be exported.
void closest_in_vectors(const WorldData& world, const Ray* rays, std::size_t count, Hit* hits,
                        std::uint8_t* mesh_ahead) {
    const TriangleBounds bounds = triangle_bounds(world);
    const auto none = [&](std::size_t first, std::size_t n) {
        std::fill_n(hits + first, n, Hit{});
        std::memset(mesh_ahead + first, 0, n);
    };
    for_vectors_ahead<false>(world, bounds, rays, count, none,
                             [&](std::size_t first, std::size_t n, const Rays& vector, const Ahead& ahead) {
                                 Least sink{vector};
                                 meet_all(world, ahead, vector, sink);
                                 const std::uint32_t meshes =
                                     mesh_ahead_of(ahead, bounds, vector, sink.limit());
                                 write_flags(meshes, mesh_ahead + first, n);
                                 write_hits(world, sink, hits + first, n);
                             });
}

void occluded_in_vectors(const WorldData& world, const Ray* rays, std::size_t count, std::uint8_t* blocked,
                         std::uint8_t* mesh_ahead) {
    const TriangleBounds bounds = triangle_bounds(world);
    const auto none = [&](std::size_t first, std::size_t n) {
        std::memset(blocked + first, 0, n);
        std::memset(mesh_ahead + first, 0, n);
    };
    for_vectors_ahead<true>(world, bounds, rays, count, none,
                            [&](std::size_t first, std::size_t n, const Rays& vector, const Ahead& ahead) {
                                AnyHit sink{vector};
                                meet_all(world, ahead, vector, sink);
                                const std::uint32_t found = bits_of(sink.found);
                                const std::uint32_t meshes =
                                    mesh_ahead_of(ahead, bounds, vector, sink.limit());
                                write_flags(found, blocked + first, n);
                                write_flags(meshes, mesh_ahead + first, n);
                            });
}

} // namespace HWY_NAMESPACE
} // namespace glint
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glint {

const std::array<SurfaceKernels, kernel_targets> surface_kernels{{
    {HWY_CHOOSE_FALLBACK(closest_in_vectors), HWY_CHOOSE_FALLBACK(occluded_in_vectors)},
    {HWY_CHOOSE_SSE4(closest_in_vectors), HWY_CHOOSE_SSE4(occluded_in_vectors)},
    {HWY_CHOOSE_AVX2(closest_in_vectors), HWY_CHOOSE_AVX2(occluded_in_vectors)},
    {HWY_CHOOSE_AVX3(closest_in_vectors), HWY_CHOOSE_AVX3(occluded_in_vectors)},
}};

} // namespace glint
#endif
