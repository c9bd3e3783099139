// Surface points of hits on planes and quadrics, several at once, for every SIMD target, with the bits of
// World::surface().

#include "trace/simd/quadric_batch.h"

#include <algorithm>

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/simd/quadric_points.cpp"
#include <hwy/foreach_target.h> // IWYU pragma: keep

#include <hwy/highway.h>

#include "trace/simd/quadric_rays-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint::trace {
namespace HWY_NAMESPACE {
namespace {

/// Points and normals in double, with a bound on their error.
struct Points {
    Vec p, n;
    real64 slack;
};

HWY_INLINE Vec at(const Lines& line, real64 t) { return line.origin + line.direction * t; }

HWY_INLINE Points on_plane(const PlanePrim& plane_prim, const Lines& line) {
    const geometry::Plane& plane = plane_prim.plane;
    real64 t;
    line_meets_plane(line.origin, line.direction, plane.normal, plane.offset, t);
    const Vec p = at(line, t);
    return {project_onto_plane(plane.normal, plane_prim.squared, plane.offset, p), plane_prim.unit,
            (largest(line.origin) + largest(p)) * surface_error};
}

HWY_INLINE Points on_quadric(const QuadricShape& shape, const Lines& line, truth leaving) {
    SolidSpan span{0.0, 0.0, 0, 0};
    line_in_quadric(shape, line.origin, line.direction, span);
    Points points;
    const double size = size_of_quadric(shape);
    point_of_quadric(shape, pick(leaving, span.leave_part, span.enter_part),
                     at(line, pick(leaving, span.leave, span.enter)), margin_at_rim(size), points.p,
                     points.n);
    points.slack = surface_error * size;
    return points;
}

HWY_INLINE Points on_surface(const WorldData& world, std::uint32_t number, const Lines& line, truth leaving) {
    const QuadricRef& ref = world.surfaces[number];
    if (ref.kind == PrimKind::plane) return on_plane(world.planes[ref.index], line);
    return on_quadric(world.quadrics[ref.index].shape, line, leaving);
}

HWY_INLINE bool same_primitive(const Hit& a, const Hit& b) {
    return ((a.object ^ b.object) | (a.prim ^ b.prim)) == 0 && a.kind == b.kind;
}

/// Whether as many hits as lanes are on one primitive.
HWY_INLINE bool same_primitive(const Hit* hits) {
    std::uint32_t different = 0;
    for (std::size_t k = 1; k < lanes; ++k)
        different |= (hits[k].object ^ hits[0].object) | (hits[k].prim ^ hits[0].prim) |
                     (static_cast<std::uint32_t>(hits[k].kind) ^ static_cast<std::uint32_t>(hits[0].kind));
    return different == 0;
}

/// Which hits are the second root, where the ray leaves.
HWY_INLINE truth are_leaving(const Hit* hits) {
    alignas(64) double root[lanes];
    for (std::size_t k = 0; k < lanes; ++k) root[k] = double(hits[k].u);
    return real64(hn::Load(dd, root)) != 0.0;
}

/// Surface by surface: `numbers` are the surfaces of the hits, invalid_index for none.
Points on_surfaces(const WorldData& world, const std::uint32_t* numbers, const Lines& line, truth leaving) {
    alignas(64) double number[lanes];
    for (std::size_t k = 0; k < lanes; ++k) number[k] = double(numbers[k]);
    const real64 wanted = hn::Load(dd, number);
    Points points{line.origin, line.origin, 0.0};
    for (std::size_t k = 0; k < lanes; ++k) {
        if (std::find(numbers, numbers + k, numbers[k]) != numbers + k || numbers[k] == invalid_index)
            continue;
        const Points found = on_surface(world, numbers[k], line, leaving);
        const truth same = wanted == number[k];
        points = {pick(same, found.p, points.p), pick(same, found.n, points.n),
                  pick(same, found.slack, points.slack)};
    }
    return points;
}

/// Rounds to float, with half a float's spacing and the slack as the error.
HWY_INLINE void store(const Points& points, const SurfaceRows& rows, std::size_t first) {
    const auto slack = hn::DemoteTo(df, points.slack.v);
    const real64 p[3] = {points.p.x, points.p.y, points.p.z};
    const real64 n[3] = {points.n.x, points.n.y, points.n.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto near = hn::DemoteTo(df, p[axis].v);
        const auto error = hn::Add(hn::Mul(hn::Abs(near), hn::Set(df, 0x1p-24f)), slack);
        hn::StoreU(near, df, rows.p[axis] + first);
        hn::StoreU(error, df, rows.p_error[axis] + first);
        hn::StoreU(hn::DemoteTo(df, n[axis].v), df, rows.n[axis] + first);
    }
}

} // namespace

void surfaces_in_vectors(const WorldData& world, const Ray* rays, const Hit* hits, std::size_t count,
                         const SurfaceRows& rows, std::uint8_t* done) {
    Hit last;
    std::uint32_t surface = plain_surface(world, last);
    // Neighbours mostly hit the same primitive.
    const auto surface_of = [&](const Hit& hit) {
        if (!same_primitive(hit, last)) surface = plain_surface(world, hit);
        last = hit;
        return surface;
    };
    for_vectors(rays, count, [&](std::size_t first, std::size_t n, const Ray* some) {
        const Lines line = LoadedRays(some).line;
        Hit padded[lanes];
        const Hit* hit = hits + first;
        if (n < lanes) {
            for (std::size_t k = 0; k < lanes; ++k) padded[k] = hit[std::min(k, n - 1)];
            hit = padded;
        }
        if (same_primitive(hit) && surface_of(*hit) != invalid_index) {
            for (std::size_t k = 0; k < n; ++k) done[first + k] = 1;
            return store(on_surface(world, surface, line, are_leaving(hit)), rows, first);
        }
        std::uint32_t numbers[lanes];
        for (std::size_t k = 0; k < lanes; ++k) numbers[k] = surface_of(hit[k]);
        for (std::size_t k = 0; k < n; ++k) done[first + k] = numbers[k] != invalid_index ? 1 : 0;
        store(on_surfaces(world, numbers, line, are_leaving(hit)), rows, first);
    });
}

} // namespace HWY_NAMESPACE
} // namespace glint::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glint::trace {

const KernelTable<PointKernel> point_kernels GLINT_KERNEL_TABLE(surfaces_in_vectors);

} // namespace glint::trace
#endif
