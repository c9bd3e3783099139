#pragma once
// What a World holds, and how a ray goes through it. Private to this room.

#include "bvh/traverse.h"
#include "bvh/tree.h"
#include "geometry/quadric.h"
#include "geometry/triangle.h"
#include "trace/world.h"

#include <cmath>
#include <vector>

namespace glint {

/// A triangle where its leaf finds it.
struct PackedTriangle {
    TriangleVertices vertices;
    std::uint32_t object;
    std::uint32_t prim;
};

/// A sphere or a cylinder, in its local space where it has one.
struct Quadric {
    PrimKind kind = PrimKind::none;
    std::int32_t affine = -1; ///< index into WorldData::affines, or -1
    std::uint32_t object = 0;
    std::uint32_t prim = 0;
    Cylinder shape; ///< a sphere has base = centre and its radius

    Sphere sphere() const { return {shape.base, shape.radius}; }
};

struct NumberedPlane {
    std::uint32_t object = 0;
    Plane plane;
};

/// A local space: p_world = linear · p_local + translation.
struct Affine {
    dmat3 linear{1.0};
    dmat3 inverse{1.0};
    dvec3 translation{0};

    Line to_local(const Line& line) const {
        return {inverse * (line.origin - translation), inverse * line.direction};
    }
};

struct WorldData {
    Tree triangle_tree;
    std::vector<PackedTriangle> triangles; ///< in the order of the leaves
    Tree quadric_tree;
    std::vector<Quadric> quadrics; ///< in the order of the leaves
    std::vector<NumberedPlane> planes;
    std::vector<Affine> affines;

    std::vector<WorldInput::Triangles> meshes;     ///< by object
    std::vector<std::uint32_t> quadrics_by_number; ///< into `quadrics`, by (object, prim)
    WorldStats stats;
};

struct World::Data : WorldData {};

/// The intervals in which a line, taken to the quadric's local space, is inside it.
inline bool intersect(const WorldData& world, const Line& line, const Quadric& quadric,
                      CylinderInterval& inside) {
    const Line local =
        quadric.affine < 0 ? line : world.affines[static_cast<std::size_t>(quadric.affine)].to_local(line);
    if (quadric.kind == PrimKind::cylinder) return intersect(local, quadric.shape, inside);
    return intersect(local, quadric.sphere(), inside.t);
}

inline Line exact_line(const Ray& ray) { return {dvec3(ray.origin), dvec3(ray.direction)}; }

/// Can the ray hit anything? NaN, infinite rays and those without a direction cannot.
inline bool is_traceable(const Ray& ray) {
    // Each product is 0, or NaN where a value is not finite.
    const vec3 zero = ray.origin * 0.0f + ray.direction * 0.0f;
    const bool finite = zero.x == 0.0f && zero.y == 0.0f && zero.z == 0.0f;
    return finite && (ray.direction.x != 0.0f || ray.direction.y != 0.0f || ray.direction.z != 0.0f);
}

/// The greatest float below tmax: what is asked for as t < tmax is tested as t <= limit.
inline float limit_below(float tmax) { return std::nextafter(tmax, -std::numeric_limits<float>::infinity()); }

/// Tests single primitives for one ray and hands each hit to the sink. A sink has `limit`, the greatest t it
/// still wants, and add(hit, positive), which returns true to end the search; `positive` tells the facings of
/// triangles apart.
template <class Sink>
class PrimitiveTester {
  public:
    PrimitiveTester(const WorldData& world, const Ray& ray, Sink& sink)
        : world_(world), sheared_(ray), line_(exact_line(ray)), tmin_(ray.tmin), sink_(sink) {}

    bool triangles(std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t i = first; i < first + count; ++i) {
            const PackedTriangle& triangle = world_.triangles[i];
            TriangleHit hit;
            if (!intersect_triangle(sheared_, triangle.vertices, tmin_, sink_.limit, hit)) continue;
            const Hit found{hit.t,      hit.u, hit.v, triangle.object, triangle.prim, PrimKind::triangle,
                            hit.on_edge};
            if (sink_.add(found, hit.positive)) return true;
        }
        return false;
    }

    bool quadrics(std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t i = first; i < first + count; ++i) {
            const Quadric& quadric = world_.quadrics[i];
            CylinderInterval inside;
            if (!intersect(world_, line_, quadric, inside)) continue;
            if (root(inside.t.enter, 0.0f, quadric.object, quadric.prim, quadric.kind)) return true;
            if (root(inside.t.leave, 1.0f, quadric.object, quadric.prim, quadric.kind)) return true;
        }
        return false;
    }

    bool planes() {
        for (const NumberedPlane& numbered : world_.planes) {
            double t;
            if (!intersect(line_, numbered.plane, t)) continue;
            if (root(t, 0.0f, numbered.object, 0, PrimKind::plane)) return true;
        }
        return false;
    }

  private:
    /// Root number `which` of a quadric: kept in u, so that two roots with one t stay apart.
    bool root(double t, float which, std::uint32_t object, std::uint32_t prim, PrimKind kind) {
        const float rounded = static_cast<float>(t);
        if (!(t > tmin_ && rounded <= sink_.limit)) return false;
        return sink_.add(Hit{rounded, which, 0.0f, object, prim, kind, false}, false);
    }

    const WorldData& world_;
    ShearedRay sheared_;
    Line line_;
    float tmin_;
    Sink& sink_;
};

/// Hands every hit with max(tmin, from) <= t <= sink.limit to the sink, roughly nearest first; others may
/// come too.
template <class Sink>
void trace(const WorldData& world, const Ray& ray, float from, Sink& sink) {
    if (!is_traceable(ray)) return;
    PrimitiveTester<Sink> test(world, ray, sink);
    if (test.planes()) return;
    bool done = false;
    if (!world.quadric_tree.empty())
        traverse(
            world.quadric_tree, BoxRay(ray, world.quadric_tree.bounds), from, sink.limit,
            [&](std::uint32_t first, std::uint32_t count) { return done = test.quadrics(first, count); });
    if (done || world.triangle_tree.empty()) return;
    traverse(world.triangle_tree, BoxRay(ray, world.triangle_tree.bounds), from, sink.limit,
             [&](std::uint32_t first, std::uint32_t count) { return test.triangles(first, count); });
}

/// The same without trees.
template <class Sink>
void trace_brute_force(const WorldData& world, const Ray& ray, Sink& sink) {
    if (!is_traceable(ray)) return;
    PrimitiveTester<Sink> test(world, ray, sink);
    if (test.planes()) return;
    if (test.quadrics(0, static_cast<std::uint32_t>(world.quadrics.size()))) return;
    test.triangles(0, static_cast<std::uint32_t>(world.triangles.size()));
}

} // namespace glint
