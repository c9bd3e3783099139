#pragma once
// What a World holds, and how a ray goes through it. Private to this room.

#include "bvh/traverse.h"
#include "bvh/tree.h"
#include "geometry/quadric.h"
#include "geometry/triangle.h"
#include "math/offset.shared.h"
#include "trace/mesh_walk.h"
#include "trace/world.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace glint {

/// A sphere or a cylinder, in its local space where it has one.
struct Quadric {
    PrimKind kind = PrimKind::none;
    std::int32_t affine = -1; ///< index into WorldData::affines, or -1
    std::uint32_t object = 0;
    std::uint32_t prim = 0;
    std::uint32_t surface = 0; ///< index into WorldData::surfaces
    Cylinder shape;            ///< a sphere has base = centre and its radius

    Sphere sphere() const { return {shape.base, shape.radius}; }
};

struct NumberedPlane {
    std::uint32_t object = 0;
    std::uint32_t surface = 0; ///< index into WorldData::surfaces
    Plane plane;
};

/// Whose a plane or quadric is.
struct SurfaceName {
    PrimKind kind = PrimKind::none;
    std::uint32_t object = 0;
    std::uint32_t prim = 0;
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
    MeshTree mesh_tree; ///< of all meshes: triangles under one running number
    Tree quadric_tree;
    std::vector<Quadric> quadrics; ///< in the order of the leaves
    std::vector<NumberedPlane> planes;
    std::vector<Affine> affines;
    std::vector<SurfaceName> surfaces; ///< of planes and quadrics by (object, prim)

    std::vector<WorldInput::Triangles> meshes;     ///< by object
    std::vector<std::uint32_t> first_numbers;      ///< the number of each mesh's first triangle
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

/// The triangle with a running number, as a hit.
inline Hit numbered_hit(const WorldData& world, std::uint32_t number, float t, float u, float v,
                        bool on_edge) {
    const auto above = std::upper_bound(world.first_numbers.begin(), world.first_numbers.end(), number);
    const auto mesh = static_cast<std::size_t>(above - world.first_numbers.begin()) - 1;
    return {t,      u, v, world.meshes[mesh].object, number - world.first_numbers[mesh], PrimKind::triangle,
            on_edge};
}

inline TriangleVertices vertices_of(const WorldInput::Triangles& mesh, std::uint32_t prim) {
    TriangleVertices vertices;
    for (int i = 0; i < 3; ++i) {
        const vec3& p = mesh.positions[mesh.triangles[prim][i]];
        vertices[static_cast<std::size_t>(i)] = {p.x, p.y, p.z};
    }
    return vertices;
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
inline float limit_below(float tmax) { return next_float(tmax, -1.0f); }

/// Tests triangles for one ray and hands each hit to the sink. A sink has `limit`, the greatest t it still
/// wants, and add(hit, positive), which returns true to end the search; `positive` tells the facings of
/// triangles apart.
template <class Sink>
class TriangleTester {
  public:
    TriangleTester(const WorldData& world, const Ray& ray, Sink& sink)
        : world_(world), sheared_(ray), tmin_(ray.tmin), sink_(sink) {}

    bool leaf(LeafCode leaf) {
        for (std::uint32_t i = 0; i < leaf.triangles(); ++i) {
            std::uint32_t number;
            const TriangleVertices vertices = leaf_triangle(world_.mesh_tree, leaf, i, number);
            if (triangle(vertices, number)) return true;
        }
        return false;
    }

    bool triangle(const TriangleVertices& vertices, std::uint32_t number) {
        TriangleHit hit;
        if (!intersect_triangle(sheared_, vertices, tmin_, sink_.limit, hit)) return false;
        return sink_.add(numbered_hit(world_, number, hit.t, hit.u, hit.v, hit.on_edge), hit.positive);
    }

  private:
    const WorldData& world_;
    ShearedRay sheared_;
    float tmin_;
    Sink& sink_;
};

/// The same for planes, spheres and cylinders.
template <class Sink>
class QuadricTester {
  public:
    QuadricTester(const WorldData& world, const Ray& ray, Sink& sink)
        : world_(world), line_(exact_line(ray)), tmin_(ray.tmin), sink_(sink) {}

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
    Line line_;
    float tmin_;
    Sink& sink_;
};

/// Planes, spheres and cylinders: hands every hit with max(tmin, from) <= t <= sink.limit to the sink; others
/// may come too. Returns whether the sink ended the search.
template <class Sink>
bool trace_quadrics(const WorldData& world, const Ray& ray, float from, Sink& sink) {
    if (world.planes.empty() && world.quadrics.empty()) return false;
    QuadricTester<Sink> test(world, ray, sink);
    if (test.planes()) return true;
    // So few need no tree.
    if (world.quadric_tree.nodes.empty())
        return test.quadrics(0, static_cast<std::uint32_t>(world.quadrics.size()));
    bool done = false;
    traverse(world.quadric_tree, BoxRay(ray, world.quadric_tree.bounds), from, sink.limit,
             [&](std::uint32_t first, std::uint32_t count) { return done = test.quadrics(first, count); });
    return done;
}

/// The same with triangles, roughly nearest first.
template <class Sink>
void trace(const WorldData& world, const Ray& ray, float from, Sink& sink) {
    if (!is_traceable(ray) || trace_quadrics(world, ray, from, sink)) return;
    TriangleTester<Sink> test(world, ray, sink);
    walk(world.mesh_tree, ray, from, sink.limit, [&](LeafCode leaf) { return test.leaf(leaf); });
}

/// The closest plane, sphere or cylinder; whether there is any.
Hit closest_surface(const WorldData& world, const Ray& ray);
bool occluded_surface(const WorldData& world, const Ray& ray);

/// Puts the triangle that a mesh's kernel found in the place of `hit`, if it precedes.
void keep_closer(const WorldData& world, const Ray& ray, const TriangleRecord& record, Hit& hit);

/// The same without trees.
template <class Sink>
void trace_brute_force(const WorldData& world, const Ray& ray, Sink& sink) {
    if (!is_traceable(ray)) return;
    QuadricTester<Sink> quadrics(world, ray, sink);
    if (quadrics.planes()) return;
    if (quadrics.quadrics(0, static_cast<std::uint32_t>(world.quadrics.size()))) return;
    TriangleTester<Sink> triangles(world, ray, sink);
    for (std::size_t m = 0; m < world.meshes.size(); ++m)
        for (std::uint32_t prim = 0; prim < world.meshes[m].triangles.size(); ++prim)
            if (triangles.triangle(vertices_of(world.meshes[m], prim), world.first_numbers[m] + prim)) return;
}

} // namespace glint
