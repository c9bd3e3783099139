// Queries of World with single rays: hits, and the surface at a hit.

#include "trace/world/world.h"

#include "trace/world/data.h"

#include <algorithm>

namespace glint::trace {

namespace {

/// Sink that keeps the least hit after another.
struct ClosestAfter {
    const Hit& previous;
    float limit;
    Closest closest{limit};

    bool add(const Hit& hit) {
        if (!precedes(previous, hit)) return false;
        closest.add(hit);
        limit = closest.limit;
        return false;
    }
};

/// Sink that stops at the first hit.
struct Any {
    float limit;
    bool found = false;

    bool add(const Hit&) { return found = true; }
};

/// Sink that keeps all hits, up to one that ends the search.
struct All {
    float limit;
    std::vector<Hit>& hits;
    const EndsSearch& ends;
    bool ended = false;

    bool add(const Hit& hit) {
        hits.push_back(hit);
        return ended = ends && ends(hit);
    }
};

/// Lower bound of t for hits on the same edge, whose t differ by rounding only.
float lowest_same(float t) { return t - std::abs(t) * 0x1p-18f; }

/// Whether `later` repeats `earlier` in the adjacent triangle across an edge or a vertex.
bool same_crossing(const Hit& earlier, const Hit& later) {
    return earlier.on_edge && later.on_edge && earlier.object == later.object &&
           earlier.positive == later.positive && earlier.t >= lowest_same(later.t) &&
           precedes(earlier, later);
}

/// Whether two hits are of the same triangle, found in different leaves.
bool same_hit(const Hit& a, const Hit& b) {
    return a.kind == PrimKind::triangle && b.kind == PrimKind::triangle && a.t == b.t &&
           a.object == b.object && a.prim == b.prim;
}

/// Whether hit i of a sorted list repeats one before it.
bool repeats_earlier(const std::vector<Hit>& hits, std::size_t i) {
    if (i > 0 && same_hit(hits[i - 1], hits[i])) return true;
    if (!hits[i].on_edge) return false;
    for (std::size_t k = i; k-- > 0 && hits[k].t >= lowest_same(hits[i].t);)
        if (same_crossing(hits[k], hits[i])) return true;
    return false;
}

/// Sink that keeps the first hit of each facing among those of one object at one t.
struct FirstOfFacing {
    const Hit& at;
    float limit = at.t;
    Hit of_facing[2]{};

    bool add(const Hit& hit) {
        Hit& first = of_facing[hit.positive ? 1 : 0];
        if (hit.object == at.object && hit.t == at.t && (!first || precedes(hit, first))) first = hit;
        return false;
    }
};

/// Sink that keeps the closest hit of an object.
struct ClosestOf {
    std::uint32_t object;
    float limit;
    Closest closest{limit};

    bool add(const Hit& hit) {
        if (hit.object != object) return false;
        closest.add(hit);
        limit = closest.limit;
        return false;
    }
};

/// Sink that checks whether a hit was already reported by an earlier one.
struct Repeated {
    const Hit& later;
    float limit = later.t;
    bool found = false;

    bool add(const Hit& hit) { return found = same_crossing(hit, later); }
};

/// Kernels do not report hits on edges; only hits with a weight of (nearly) 0 can be on one.
bool may_be_on_edge(const Hit& hit) { return hit.u == 0.0f || hit.v == 0.0f || !(hit.u + hit.v < 0.99999f); }

bool is_on_edge(const geometry::TriangleVertices& vertices, const Ray& ray, float t) {
    TriangleHit again;
    return geometry::intersect_triangle(geometry::ShearedRay(ray), vertices, ray.tmin, t, again) &&
           again.on_edge;
}

} // namespace

bool precedes(const Hit& a, const Hit& b) {
    if (a.t != b.t) return a.t < b.t;
    if (a.object != b.object) return a.object < b.object;
    if (a.prim != b.prim) return a.prim < b.prim;
    // Both roots of a quadric may round to the same t; the ray still enters before it leaves.
    return a.kind == b.kind && a.kind != PrimKind::triangle && a.u < b.u;
}

Hit closest_surface(const WorldData& world, const Ray& ray) {
    if (!is_traceable(ray)) return {};
    Closest sink{limit_below(ray.tmax)};
    trace_quadrics(world, ray, ray.tmin, sink);
    return sink.best;
}

bool occluded_surface(const WorldData& world, const Ray& ray) {
    if (!is_traceable(ray)) return false;
    Any sink{limit_below(ray.tmax)};
    return trace_quadrics(world, ray, ray.tmin, sink);
}

void keep_closer_wide(const WorldData& world, const Ray& ray, Hit& hit) {
    if (world.wide_tree.nodes.empty() || !is_traceable(ray)) return;
    Closest sink{std::min(hit.t, limit_below(ray.tmax)), hit};
    trace_mesh(world.wide_tree, ray, ray.tmin, sink, WideTester<Closest>(world, ray, sink));
    hit = sink.best;
}

bool occluded_by_wide(const WorldData& world, const Ray& ray) {
    if (world.wide_tree.nodes.empty() || !is_traceable(ray)) return false;
    Any sink{limit_below(ray.tmax)};
    return trace_mesh(world.wide_tree, ray, ray.tmin, sink, WideTester<Any>(world, ray, sink));
}

void keep_closer(const WorldData& world, const Ray& ray, const TriangleRecord& record, Hit& hit) {
    const Hit triangle =
        numbered_hit(world, world.first_numbers, record.triangle, record.t, record.u, record.v, false);
    if (!precedes(triangle, hit)) return;
    hit = triangle;
    if (may_be_on_edge(hit))
        hit.on_edge = is_on_edge(vertices_of(mesh_of(world, hit.object), hit.prim), ray, hit.t);
}

void keep_closer(const WorldData& world, const Ray& ray, const InstanceRecord& record, Hit& hit) {
    const Hit triangle =
        instance_hit(world, record.instance, record.triangle, record.t, record.u, record.v, false);
    if (!precedes(triangle, hit)) return;
    hit = triangle;
    if (may_be_on_edge(hit))
        hit.on_edge = is_on_edge(vertices_of(world, world.instances[record.instance], hit.prim),
                                 world.instance_tree.to_local(record.instance, ray), hit.t);
}

Hit World::closest(const Ray& ray, const KernelChoice& choice) const {
    Hit hit = closest_surface(*data_, ray);
    keep_closer_wide(*data_, ray, hit);
    Ray limited = ray;
    if (hit) limited.tmax = next_float(hit.t, 1.0f);
    const TriangleRecord record = trace::closest(data_->mesh_tree, limited, choice);
    if (record.triangle != invalid_index) keep_closer(*data_, ray, record, hit);
    if (data_->instances.empty()) return hit;
    if (hit) limited.tmax = next_float(hit.t, 1.0f);
    const InstanceRecord placed = data_->instance_tree.closest(limited, choice);
    if (placed.instance != invalid_index) keep_closer(*data_, ray, placed, hit);
    return hit;
}

Hit World::closest_brute_force(const Ray& ray) const {
    Closest sink{limit_below(ray.tmax)};
    trace_brute_force(*data_, ray, sink);
    return sink.best;
}

bool World::occluded(const Ray& ray, const KernelChoice& choice) const {
    return occluded_surface(*data_, ray) || occluded_by_wide(*data_, ray) ||
           trace::occluded(data_->mesh_tree, ray, choice) || data_->instance_tree.occluded(ray, choice);
}

bool World::occluded_brute_force(const Ray& ray) const {
    Any sink{limit_below(ray.tmax)};
    trace_brute_force(*data_, ray, sink);
    return sink.found;
}

Hit World::next(const Ray& ray, const Hit& previous) const {
    if (!previous) return {};
    Hit last = previous;
    for (;;) {
        ClosestAfter sink{last, limit_below(ray.tmax)};
        trace(*data_, ray, std::max(ray.tmin, last.t), sink);
        const Hit& found = sink.closest.best;
        if (!found || !found.on_edge) return found;
        Repeated repeated{found};
        trace(*data_, ray, std::max(ray.tmin, lowest_same(found.t)), repeated);
        if (!repeated.found) return found;
        last = found;
    }
}

bool World::all_hits(const Ray& ray, std::vector<Hit>& out, const EndsSearch& ends) const {
    out.clear();
    All sink{limit_below(ray.tmax), out, ends};
    trace(*data_, ray, ray.tmin, sink);
    if (sink.ended) return false;
    std::sort(out.begin(), out.end(), precedes);
    // From the last on, so that each is compared with all before it.
    for (std::size_t i = out.size(); i-- > 0;)
        if (repeats_earlier(out, i)) out.erase(out.begin() + static_cast<std::ptrdiff_t>(i));
    return true;
}

// ── From a hit back to the surface: computed in double, rounded once

namespace {

vec3 corner(const geometry::TriangleVertices& vertices, std::size_t i) {
    return {vertices[i][0], vertices[i][1], vertices[i][2]};
}

SurfacePoint triangle_point(const WorldData& world, const Ray& ray, const Hit& hit) {
    const double u = hit.u;
    const double v = hit.v;
    const std::uint32_t instance = instance_of(world, hit.object);
    if (instance == invalid_index) {
        const std::size_t number = mesh_number(world, hit.object);
        const WorldInput::Triangles& mesh = world.meshes[number];
        const geometry::TriangleVertices at = vertices_of(mesh, hit.prim);
        const double off_edges = world.off_edges[number];
        const geometry::Line line = exact_line(ray);
        if (mesh.wide)
            return wide_triangle_surface(corner(at, 0), corner(at, 1), corner(at, 2),
                                         line.origin + line.direction * double(hit.t), off_edges,
                                         line.direction, mesh.flip);
        return triangle_surface(corner(at, 0), corner(at, 1), corner(at, 2), u, v, off_edges, line.direction,
                                mesh.flip);
    }
    const InstanceData& data = world.instances[instance];
    const geometry::TriangleVertices at = vertices_of(world, data, hit.prim);
    const Ray local = world.instance_tree.to_local(instance, ray);
    return instance_surface(corner(at, 0), corner(at, 1), corner(at, 2), u, v,
                            world.shared_meshes[data.mesh].off_edges, dvec3(local.direction), data.linear,
                            world.instance_tree.inverse(instance), world.instance_tree.translation(instance),
                            data.slack, data.turned);
}

/// Far enough from edges for a neighbour not to be hit at the same t.
constexpr float off_edge_weight = 0x1p-10f;

/// The hit whose face a ray meets. Where it touches an edge of a mesh's outline, it meets a face from before
/// and one from behind at the same t, and `hit` is the one of the lower number. Of a closed mesh the right
/// one is that which faces the other way than what the ray would have met last on its way to its origin.
Hit hit_at_outline(const WorldData& world, const Ray& ray, const Hit& hit) {
    if (std::min({hit.u, hit.v, 1.0f - hit.u - hit.v}) > off_edge_weight) return hit;
    FirstOfFacing touched{hit};
    trace(world, ray, hit.t, touched);
    const auto& [negative, positive] = touched.of_facing;
    if (!negative || !positive) return hit;
    Ray back = ray;
    back.tmin = 0;
    back.direction = -ray.direction;
    ClosestOf behind{hit.object, limit_below(std::numeric_limits<float>::infinity())};
    trace(world, back, back.tmin, behind);
    if (behind.closest.best) return behind.closest.best.positive ? negative : positive;
    return glm::dot(triangle_point(world, ray, positive).n, ray.direction) < 0 ? positive : negative;
}

SurfacePoint quadric_point(const WorldData& world, const Ray& ray, const Hit& hit) {
    const Quadric& quadric = world.quadrics[world.surfaces[surface_number(world, hit)].index];
    const geometry::Line line = exact_line(ray);
    const bool leaving = hit.u != 0.0f;
    if (quadric.affine < 0) return quadric_surface(quadric.shape, leaving, line.origin, line.direction);
    const Affine& affine = world.affines[static_cast<std::size_t>(quadric.affine)];
    const geometry::Line local = affine.to_local(line);
    return local_quadric_surface(quadric.shape, leaving, local.origin, local.direction, affine.linear,
                                 affine.inverse, affine.translation);
}

SurfacePoint plane_point(const WorldData& world, const Ray& ray, const Hit& hit) {
    const geometry::Plane& plane = world.planes[world.surfaces[surface_number(world, hit)].index].plane;
    const geometry::Line line = exact_line(ray);
    return plane_surface(line.origin, line.direction, plane.normal, plane.offset);
}

} // namespace

SurfacePoint World::surface(const Ray& ray, const Hit& hit) const {
    switch (hit.kind) {
    case PrimKind::triangle:
        return triangle_point(*data_, ray, hit_at_outline(*data_, ray, hit));
    case PrimKind::quadric:
        return quadric_point(*data_, ray, hit);
    case PrimKind::plane:
        return plane_point(*data_, ray, hit);
    case PrimKind::none:
        break;
    }
    return {};
}

Bounds World::bounds() const {
    Bounds box = triangle_bounds(*data_).box;
    box.grow(data_->wide_tree.bounds);
    box.grow(data_->quadric_tree.bounds);
    return box;
}

WorldStats World::stats() const { return data_->stats; }

const WorldData& World::data() const { return *data_; }

} // namespace glint::trace
