#pragma once
// Data of a World, and scalar traversal. Private to this room, to backends that build their own trees, and to
// what compares primitives (scene/contacts.cpp).

#include "bvh/traverse.h"
#include "bvh/tree.h"
#include "geometry/quadric.h"
#include "geometry/triangle.h"
#include "math/index.h"
#include "math/offset.shared.h"
#include "trace/mesh/scalar.h"
#include "trace/world/instance_tree.h"
#include "trace/world/world.h"

#include <algorithm>
#include <span>
#include <type_traits>
#include <vector>

namespace glint::trace {

/// A quadric, in local space if it has one.
struct Quadric {
    std::int32_t affine = -1; ///< index into WorldData::affines, or -1
    std::uint32_t object = 0;
    std::uint32_t prim = 0;
    std::uint32_t surface = 0; ///< index into WorldData::surfaces
    QuadricShape shape{};
    Bounds box{}; ///< world-space bounds
};

struct PlanePrim {
    std::uint32_t object = 0;
    std::uint32_t surface = 0; ///< index into WorldData::surfaces
    geometry::Plane plane;
    double squared = 1;      ///< normal · normal
    dvec3 unit{0.0, 0.0, 1}; ///< the normal of unit length
};

/// Object and primitive index of a plane or quadric.
struct QuadricRef {
    PrimKind kind = PrimKind::none;
    std::uint32_t object = 0;
    std::uint32_t prim = 0;
    std::uint32_t index = 0; ///< into WorldData::planes or quadrics
};

/// A local space: p_world = linear · p_local + translation.
struct Affine {
    dmat3 linear{1.0};
    dmat3 inverse{1.0};
    dvec3 translation{0};

    geometry::Line to_local(const geometry::Line& line) const {
        return {inverse * (line.origin - translation), inverse * line.direction};
    }
};

/// A mesh with several instances.
struct SharedMesh {
    WorldInput::SharedMesh source;
    MeshTree tree;
    double off_edges = edge_margin; ///< as in WorldData
};

/// How far rays start from the edges of a mesh's triangles, in errors of their start points: see "Away from
/// edges" in geometry/surface.shared.h. The edges of large meshes are taken not to be sharp.
double margin_off_edges(std::span<const vec3> positions, std::span<const uvec3> triangles);

/// An instance of a shared mesh; WorldData::instance_tree has the inverse transform.
struct InstanceData {
    std::uint32_t object = 0;
    std::uint32_t mesh = 0; ///< index into WorldData::shared_meshes
    bool turned = false;    ///< the normal is opposite to the winding in the mesh's space
    dmat3 linear{1.0};      ///< p_world = linear · p_mesh + translation
    double slack = 0;       ///< rounding error of transforming to the world and back, in world units
};

struct WorldData {
    MeshTree mesh_tree; ///< of all meshes that are neither shared nor wide, with consecutive triangle indices
    MeshTree wide_tree; ///< of the wide meshes, likewise
    Tree quadric_tree;
    std::vector<Quadric> quadrics; ///< in leaf order
    std::vector<PlanePrim> planes;
    std::vector<Affine> affines;
    std::vector<QuadricRef> surfaces; ///< of planes and quadrics by (object, prim)
    /// by object: index of its first entry in `surfaces`, or of the next one
    std::vector<std::uint32_t> first_surface;

    std::vector<WorldInput::Triangles> meshes; ///< by object
    std::vector<std::uint32_t> first_numbers;  ///< index of each mesh's first triangle in mesh_tree
    std::vector<std::uint32_t> wide_numbers;   ///< and in wide_tree
    std::vector<double> off_edges;             ///< margin_off_edges() of each mesh
    std::vector<SharedMesh> shared_meshes;     ///< never reallocated: trees point into it
    std::vector<InstanceData> instances;       ///< by object
    InstanceTree instance_tree;                ///< of `instances`, in their order
    WorldStats stats;
};

/// Moves shared meshes and instances from the input and builds their trees. An instance that its tree does
/// not accept is baked and added to input.meshes.
void add_instances(WorldData& world, WorldInput& input, parallel::TaskPool& pool);

/// The part of a line inside a quadric, transformed to local space if needed; false if there is none.
inline bool intersect(const WorldData& world, const geometry::Line& line, const Quadric& quadric,
                      SolidSpan& span) {
    const geometry::Line local =
        quadric.affine < 0 ? line : world.affines[static_cast<std::size_t>(quadric.affine)].to_local(line);
    return intersect(local, quadric.shape, span);
}

/// Bounds of all triangles but wide ones. `slack` is the additional growth of the box test per unit of the
/// origin's largest |coordinate|.
struct TriangleBounds {
    Bounds box;
    float slack = 0;
};

inline TriangleBounds triangle_bounds(const WorldData& world) {
    TriangleBounds bounds{world.mesh_tree.bounds, world.instance_tree.slack()};
    bounds.box.grow(world.instance_tree.bounds());
    return bounds;
}

/// The hit of a triangle given by its index in mesh_tree or wide_tree, with the tree's `first_numbers`.
inline Hit numbered_hit(const WorldData& world, const std::vector<std::uint32_t>& first_numbers,
                        std::uint32_t number, float t, float u, float v, bool on_edge) {
    const auto above = std::upper_bound(first_numbers.begin(), first_numbers.end(), number);
    const auto mesh = static_cast<std::size_t>(above - first_numbers.begin()) - 1;
    return {t, u, v, world.meshes[mesh].object, number - first_numbers[mesh], PrimKind::triangle, on_edge};
}

inline Hit instance_hit(const WorldData& world, std::uint32_t instance, std::uint32_t triangle, float t,
                        float u, float v, bool on_edge) {
    return {t, u, v, world.instances[instance].object, triangle, PrimKind::triangle, on_edge};
}

/// Index of an object's instance; invalid_index if its triangles are in `meshes`.
inline std::uint32_t instance_of(const WorldData& world, std::uint32_t object) {
    const auto at =
        std::lower_bound(world.instances.begin(), world.instances.end(), object,
                         [](const InstanceData& instance, std::uint32_t o) { return instance.object < o; });
    if (at == world.instances.end() || at->object != object) return invalid_index;
    return static_cast<std::uint32_t>(at - world.instances.begin());
}

/// The index in `meshes` of an object that is not an instance.
inline std::size_t mesh_number(const WorldData& world, std::uint32_t object) {
    const auto at = std::lower_bound(world.meshes.begin(), world.meshes.end(), object,
                                     [](const auto& mesh, std::uint32_t o) { return mesh.object < o; });
    return static_cast<std::size_t>(at - world.meshes.begin());
}

inline const WorldInput::Triangles& mesh_of(const WorldData& world, std::uint32_t object) {
    return world.meshes[mesh_number(world, object)];
}

inline geometry::TriangleVertices vertices_of(std::span<const vec3> positions, const uvec3& corners) {
    geometry::TriangleVertices vertices;
    for (int i = 0; i < 3; ++i) {
        const vec3& p = positions[corners[i]];
        vertices[static_cast<std::size_t>(i)] = {p.x, p.y, p.z};
    }
    return vertices;
}

inline geometry::TriangleVertices vertices_of(const WorldInput::Triangles& mesh, std::uint32_t prim) {
    return vertices_of(mesh.positions, mesh.triangles[prim]);
}

/// Triangle of an instance in the mesh's space.
inline geometry::TriangleVertices vertices_of(const WorldData& world, const InstanceData& instance,
                                              std::uint32_t prim) {
    const WorldInput::SharedMesh& mesh = world.shared_meshes[instance.mesh].source;
    return vertices_of(*mesh.positions, (*mesh.triangles)[prim]);
}

/// Index in `surfaces` of the plane or quadric that was hit.
inline std::uint32_t surface_number(const WorldData& world, const Hit& hit) {
    // Primitives of an object are mostly numbered consecutively.
    const std::uint32_t first = world.first_surface[hit.object];
    const std::size_t guess = std::size_t{first} + hit.prim;
    const auto is_it = [&](const QuadricRef& s) { return s.object == hit.object && s.prim == hit.prim; };
    if (guess < world.surfaces.size() && is_it(world.surfaces[guess]))
        return static_cast<std::uint32_t>(guess);
    const auto at = std::lower_bound(
        world.surfaces.begin() + first, world.surfaces.end(), hit.prim,
        [&](const QuadricRef& s, std::uint32_t prim) { return s.object == hit.object && s.prim < prim; });
    return static_cast<std::uint32_t>(at - world.surfaces.begin());
}

/// Like surface_number(), for planes and for quadrics without local space; otherwise invalid_index.
inline std::uint32_t plain_surface(const WorldData& world, const Hit& hit) {
    if (hit.kind != PrimKind::plane && hit.kind != PrimKind::quadric) return invalid_index;
    const std::uint32_t number = surface_number(world, hit);
    const bool plain = hit.kind == PrimKind::plane || world.quadrics[world.surfaces[number].index].affine < 0;
    return plain ? number : invalid_index;
}

inline geometry::Line exact_line(const Ray& ray) { return {dvec3(ray.origin), dvec3(ray.direction)}; }

/// Sink that keeps the least hit.
struct Closest {
    float limit;
    Hit best{};

    bool add(const Hit& hit) {
        if (precedes(hit, best)) {
            best = hit;
            limit = hit.t;
        }
        return false;
    }
};

/// Tests triangles of an instance (with the ray in the mesh's space) or of mesh_tree, and passes hits to a
/// sink. A sink has `limit`, the upper bound of t, and add(hit), which returns true to end the search.
template <class Sink, class Sheared = geometry::ShearedRay>
class TriangleTester {
  public:
    TriangleTester(const WorldData& world, const Ray& ray, Sink& sink, std::uint32_t instance = invalid_index)
        : world_(world), sheared_(ray), tmin_(ray.tmin), sink_(sink), instance_(instance) {}

    bool leaf(const MeshTree& tree, LeafCode leaf) {
        for (std::uint32_t i = 0; i < leaf.triangles(); ++i) {
            std::uint32_t number;
            const geometry::TriangleVertices vertices = leaf_triangle(tree, leaf, i, number);
            if (triangle(vertices, number)) return true;
        }
        return false;
    }

    bool triangle(const geometry::TriangleVertices& vertices, std::uint32_t number) {
        TriangleHit hit;
        if (!geometry::intersect_triangle(sheared_, vertices, tmin_, sink_.limit, hit)) return false;
        Hit found = instance_ == invalid_index
                        ? numbered_hit(world_, first_numbers(), number, hit.t, hit.u, hit.v, hit.on_edge)
                        : instance_hit(world_, instance_, number, hit.t, hit.u, hit.v, hit.on_edge);
        found.positive = hit.positive;
        return sink_.add(found);
    }

  private:
    static constexpr bool wide = std::is_same_v<Sheared, geometry::DoubleShearedRay>;
    const std::vector<std::uint32_t>& first_numbers() const {
        return wide ? world_.wide_numbers : world_.first_numbers;
    }

    const WorldData& world_;
    Sheared sheared_;
    float tmin_;
    Sink& sink_;
    std::uint32_t instance_;
};

/// The same for wide_tree.
template <class Sink>
using WideTester = TriangleTester<Sink, geometry::DoubleShearedRay>;

/// Tests planes and quadrics, and passes hits to a sink.
template <class Sink>
class QuadricTester {
  public:
    QuadricTester(const WorldData& world, const Ray& ray, Sink& sink)
        : world_(world), line_(exact_line(ray)), tmin_(ray.tmin), sink_(sink) {}

    bool quadrics(std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t i = first; i < first + count; ++i) {
            const Quadric& quadric = world_.quadrics[i];
            SolidSpan span;
            if (!intersect(world_, line_, quadric, span)) continue;
            if (root(span.enter, 0.0f, quadric.object, quadric.prim, PrimKind::quadric)) return true;
            if (root(span.leave, 1.0f, quadric.object, quadric.prim, PrimKind::quadric)) return true;
        }
        return false;
    }

    bool planes() {
        for (const PlanePrim& plane_prim : world_.planes) {
            double t;
            if (!intersect(line_, plane_prim.plane, t)) continue;
            if (root(t, 0.0f, plane_prim.object, 0, PrimKind::plane)) return true;
        }
        return false;
    }

  private:
    /// Root `which` of a quadric, stored in u to distinguish roots with equal t.
    bool root(double t, float which, std::uint32_t object, std::uint32_t prim, PrimKind kind) {
        const float rounded = static_cast<float>(t);
        if (!(t > tmin_ && rounded <= sink_.limit)) return false;
        return sink_.add(Hit{rounded, which, 0.0f, object, prim, kind});
    }

    const WorldData& world_;
    geometry::Line line_;
    float tmin_;
    Sink& sink_;
};

/// Passes all hits of planes and quadrics with max(tmin, from) <= t <= sink.limit to the sink, possibly
/// others too. Returns whether the sink ended the search.
template <class Sink>
bool trace_quadrics(const WorldData& world, const Ray& ray, float from, Sink& sink) {
    if (world.planes.empty() && world.quadrics.empty()) return false;
    QuadricTester<Sink> test(world, ray, sink);
    if (test.planes()) return true;
    // Too few for a tree.
    if (world.quadric_tree.nodes.empty())
        return test.quadrics(0, static_cast<std::uint32_t>(world.quadrics.size()));
    bool done = false;
    traverse(world.quadric_tree, BoxRay(ray, world.quadric_tree.bounds), from, sink.limit,
             [&](std::uint32_t first, std::uint32_t count) { return done = test.quadrics(first, count); });
    return done;
}

/// Like trace_quadrics() for the triangles of a tree: mesh_tree, wide_tree, or that of an instance.
template <class Sink, class Tester>
bool trace_mesh(const MeshTree& tree, const Ray& ray, float from, Sink& sink, Tester test) {
    bool done = false;
    walk(tree, ray, from, sink.limit, [&](LeafCode leaf) { return done = test.leaf(tree, leaf); });
    return done;
}

/// Likewise for instances.
template <class Sink>
bool trace_instances(const WorldData& world, const Ray& ray, float from, Sink& sink) {
    bool done = false;
    Ray rest = ray;
    rest.tmin = from;
    world.instance_tree.visit(rest, sink.limit, [&](std::uint32_t instance) {
        const Ray local = world.instance_tree.to_local(instance, ray);
        return done = is_traceable(local) && trace_mesh(world.instance_tree.mesh(instance), local, from, sink,
                                                        TriangleTester<Sink>(world, local, sink, instance));
    });
    return done;
}

/// Likewise for everything, roughly nearest first.
template <class Sink>
void trace(const WorldData& world, const Ray& ray, float from, Sink& sink) {
    if (!is_traceable(ray) || trace_quadrics(world, ray, from, sink)) return;
    if (!world.wide_tree.nodes.empty() &&
        trace_mesh(world.wide_tree, ray, from, sink, WideTester<Sink>(world, ray, sink)))
        return;
    if (trace_mesh(world.mesh_tree, ray, from, sink, TriangleTester<Sink>(world, ray, sink))) return;
    trace_instances(world, ray, from, sink);
}

/// Closest hit, or any hit, of planes and quadrics.
Hit closest_surface(const WorldData& world, const Ray& ray);
bool occluded_surface(const WorldData& world, const Ray& ray);

/// Replaces `hit` by the closest hit of a wide mesh if that precedes it.
void keep_closer_wide(const WorldData& world, const Ray& ray, Hit& hit);

bool occluded_by_wide(const WorldData& world, const Ray& ray);

/// Replaces `hit` by the result of a mesh kernel if that precedes it.
void keep_closer(const WorldData& world, const Ray& ray, const TriangleRecord& record, Hit& hit);

void keep_closer(const WorldData& world, const Ray& ray, const InstanceRecord& record, Hit& hit);

/// trace() by brute force.
template <class Sink>
void trace_brute_force(const WorldData& world, const Ray& ray, Sink& sink) {
    if (!is_traceable(ray)) return;
    QuadricTester<Sink> quadrics(world, ray, sink);
    if (quadrics.planes()) return;
    if (quadrics.quadrics(0, static_cast<std::uint32_t>(world.quadrics.size()))) return;
    TriangleTester<Sink> triangles(world, ray, sink);
    WideTester<Sink> wide(world, ray, sink);
    for (std::size_t m = 0; m < world.meshes.size(); ++m) {
        const WorldInput::Triangles& mesh = world.meshes[m];
        for (std::uint32_t prim = 0; prim < mesh.triangles.size(); ++prim)
            if (mesh.wide ? wide.triangle(vertices_of(mesh, prim), world.wide_numbers[m] + prim)
                          : triangles.triangle(vertices_of(mesh, prim), world.first_numbers[m] + prim))
                return;
    }
    for (std::uint32_t i = 0; i < world.instances.size(); ++i) {
        const Ray local = world.instance_tree.to_local(i, ray);
        if (!is_traceable(local)) continue;
        TriangleTester<Sink> test(world, local, sink, i);
        const InstanceData& instance = world.instances[i];
        const std::size_t count = world.shared_meshes[instance.mesh].source.triangles->size();
        for (std::uint32_t prim = 0; prim < count; ++prim)
            if (test.triangle(vertices_of(world, instance, prim), prim)) return;
    }
}

} // namespace glint::trace
