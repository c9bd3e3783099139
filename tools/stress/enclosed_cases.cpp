// Rays that start on the surface of closed solids, near their edges above all: none may start on the wrong
// side.

#include "batches.h"
#include "families.h"
#include "geometry/polyhedron.h"
#include "geometry/quadric.h"
#include "math/offset.shared.h"
#include "trace/world/world.h"

#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace glint::stress {

using geometry::Footing;
using geometry::make_box;
using geometry::make_cone;
using geometry::make_cylinder;
using geometry::Polyhedron;
using trace::Hit;
using trace::World;
using trace::WorldInput;

namespace {

/// Scaled so that one side may be three times as thick as another, at most.
Polyhedron random_solid(Random& random) {
    const Footing footing{random.in_ball(0.5), random.direction(), random.between(3, 8),
                          random.uniform(0.5, 1.0), random.uniform(0.5, 1.5)};
    switch (random.below(7)) {
    case 0:
        return make_box(random.in_ball(0.5), dvec3(0.6) + (random.in_cube(0.5) + dvec3(0.5)));
    case 1:
        return geometry::make_tetrahedron(random.in_ball(0.5), 1.0);
    case 2:
        return geometry::make_octahedron(random.in_ball(0.5), 1.0);
    case 3:
        return geometry::make_dodecahedron(random.in_ball(0.5), 1.0);
    case 4:
        return geometry::make_icosahedron(random.in_ball(0.5), 1.0);
    case 5:
        return geometry::make_prism(footing);
    default:
        return geometry::make_pyramid(footing);
    }
}

/// Vertices in a ring of a torus or knot.
constexpr int tube_sides = 8;

Polyhedron polyhedron_of(const Mesh& mesh) {
    return {{mesh.positions.begin(), mesh.positions.end()}, mesh.triangles};
}

/// With edges down to 1°.
Polyhedron flat_solid(Random& random) {
    const double flatness = random.uniform(0.02, 0.2);
    const Footing footing{random.in_ball(0.5), random.direction(), random.between(3, 8), 1.0, flatness};
    if (random.one_in(3)) return make_prism(footing);
    if (random.one_in(2)) return make_pyramid(footing);
    Polyhedron lens = polyhedron_of(meshgen::make_icosphere(1));
    for (dvec3& p : lens.positions) p.z = p.z * flatness;
    return lens;
}

Polyhedron make_solid(Enclosed kind, Random& random) {
    switch (kind) {
    case Enclosed::flat:
        return flat_solid(random);
    case Enclosed::icosphere:
        return polyhedron_of(meshgen::make_icosphere(random.between(1, 3)));
    case Enclosed::torus:
        return polyhedron_of(meshgen::make_torus(random.between(5, 32), tube_sides, 1.0, 0.4));
    case Enclosed::knot:
        return polyhedron_of(meshgen::make_knot(random.between(48, 96), tube_sides, {}));
    default:
        return random_solid(random);
    }
}

/// One closed solid, a point inside, and points of its edges, corners and rims.
class EnclosedWorld {
  public:
    EnclosedWorld(Enclosed kind, Random& random)
        : kind_(kind), random_(random), to_world_(random_offset(random, 3)) {
        WorldInput input;
        if (kind == Enclosed::quadric)
            add_quadric(input);
        else
            add_mesh(input);
        parallel::TaskPool pool(1);
        world_ = World(std::move(input), pool);
    }

    const World& world() const { return world_; }
    dvec3 inside() const { return inside_; }
    dvec3 outside() {
        if (kind_ != Enclosed::wide) return inside_ + random_.direction() * (8.0 * scale());
        return middle_ + (middle_ - inside_) * 8.0 + random_.in_ball(0.5) * scale();
    }
    double scale() const { return to_world_.scale; }
    bool is_convex() const { return kind_ != Enclosed::torus && kind_ != Enclosed::knot; }

    /// On an edge, in a corner or near one, else anywhere near the solid.
    dvec3 target() {
        const double x = random_.one_in(4) ? 0.0 : random_.unit();
        const Edge& edge = edges_[random_.below(static_cast<std::uint32_t>(edges_.size()))];
        dvec3 point = edge.from + (edge.to - edge.from) * x;
        if (!random_.one_in(8)) point = point + random_.in_ball(random_.power_of_ten(-9, -2)) * scale();
        return random_.one_in(8) ? inside_ + random_.in_ball(2.0) * scale() : point;
    }

  private:
    struct Edge {
        dvec3 from;
        dvec3 to;
    };

    void add_mesh(WorldInput& input) {
        Polyhedron solid = make_solid(kind_, random_);
        if (kind_ == Enclosed::wide) widen(solid);
        const std::vector<dvec3> corners =
            kind_ == Enclosed::instance ? add_instance(solid, input) : add_triangles(solid, input);
        for (const uvec3& t : solid.triangles)
            for (const auto& [from, to] : {std::pair(t.x, t.y), std::pair(t.y, t.z), std::pair(t.z, t.x)})
                edges_.push_back(seen_part({corners[from], corners[to]}));
        const std::size_t around_inside = is_convex() ? corners.size() : tube_sides;
        for (std::size_t i = 0; i < around_inside; ++i)
            inside_ = inside_ + corners[i] / static_cast<double>(around_inside);
        if (kind_ == Enclosed::wide) inside_ = middle_ + glm::normalize(inside_ - middle_) * scale();
    }

    /// Of an edge of a wide solid, the part near the middle of what is seen.
    Edge seen_part(const Edge& edge) const {
        if (kind_ != Enclosed::wide) return edge;
        const dvec3 along = edge.to - edge.from;
        const double length = glm::length(along);
        const double nearest = glm::dot(middle_ - edge.from, along) / length;
        const auto at = [&](double x) { return edge.from + along * (std::clamp(x, 0.0, length) / length); };
        return {at(nearest - 2 * scale()), at(nearest + 2 * scale())};
    }

    /// Puts a point of an edge in the middle of what is seen, and the solid's other corners far away.
    void widen(Polyhedron& solid) {
        const uvec3& t = solid.triangles[random_.below(static_cast<std::uint32_t>(solid.triangles.size()))];
        const double x = random_.one_in(4) ? 0.0 : random_.unit();
        const dvec3 middle = solid.positions[t.x] * (1.0 - x) + solid.positions[t.y] * x;
        const double size = std::ldexp(1.0, random_.between(10, 20));
        for (dvec3& p : solid.positions) p = (p - middle) * size;
        middle_ = dvec3(to_world_(dvec3(0.0)));
    }

    /// As one mesh, or each by itself; returns the corners in the world.
    std::vector<dvec3> add_triangles(const Polyhedron& solid, WorldInput& input) {
        WorldInput::Triangles mesh;
        mesh.wide = kind_ == Enclosed::wide;
        for (const dvec3& p : solid.positions) mesh.positions.push_back(to_world_(p));
        std::vector<dvec3> corners(mesh.positions.begin(), mesh.positions.end());
        if (kind_ == Enclosed::faces) {
            for (const uvec3& triangle : solid.triangles) {
                mesh.object = static_cast<std::uint32_t>(input.meshes.size());
                mesh.triangles = {triangle};
                input.meshes.push_back(mesh);
            }
        } else {
            mesh.triangles = solid.triangles;
            input.meshes.push_back(std::move(mesh));
        }
        return corners;
    }

    /// Turned, sheared and mirrored half the time; returns the corners in the world.
    std::vector<dvec3> add_instance(const Polyhedron& solid, WorldInput& input) {
        std::vector<vec3> positions(solid.positions.begin(), solid.positions.end());
        dmat3 linear(random_.direction(), random_.direction(), random_.direction());
        while (std::abs(glm::determinant(linear)) < 0.5)
            linear = dmat3(random_.direction(), random_.direction(), random_.direction());
        linear = linear * to_world_.scale;
        WorldInput::Instance instance;
        instance.world_from_mesh = dmat4(linear);
        instance.world_from_mesh[3] = dvec4(to_world_.offset * to_world_.scale, 1.0);
        instance.flip = glm::determinant(linear) < 0;
        std::vector<dvec3> corners;
        for (const vec3& p : positions)
            corners.push_back(dvec3(instance.world_from_mesh * dvec4(dvec3(p), 1.0)));
        input.instances.push_back(instance);
        input.shared_meshes.push_back({std::make_shared<const std::vector<vec3>>(std::move(positions)),
                                       std::make_shared<const std::vector<uvec3>>(solid.triangles)});
        return corners;
    }

    void add_quadric(WorldInput& input) {
        const dvec3 base = (random_.in_ball(0.5) + to_world_.offset) * to_world_.scale;
        const dvec3 axis = random_.direction();
        const double height = random_.uniform(0.5, 1.5) * to_world_.scale;
        const double radius = random_.uniform(0.5, 1.0) * to_world_.scale;
        const bool is_cone = random_.one_in(2);
        const QuadricShape shape =
            is_cone ? make_cone(base, axis, height, radius) : make_cylinder(base, axis, height, radius);
        input.quadrics.push_back({0, 0, shape});
        const dvec3 top = base + axis * height;
        inside_ = base + axis * (height / 4);
        const dvec3 across = glm::normalize(glm::cross(axis, random_.direction()));
        const dvec3 around = glm::cross(axis, across);
        constexpr int steps = 64;
        for (int i = 0; i < steps; ++i) {
            const double x = 2.0 * i / (steps - 1) - 1.0;
            const double y = std::sqrt(1.0 - x * x) * (i % 2 == 0 ? 1 : -1);
            const dvec3 rim = (across * x + around * y) * radius;
            edges_.push_back({base + rim, base + rim});
            edges_.push_back(is_cone ? Edge{top, top} : Edge{top + rim, top + rim});
        }
    }

    Enclosed kind_;
    Random& random_;
    ScaledOffset to_world_;
    World world_;
    dvec3 middle_{0}; ///< of what is seen of a wide solid
    dvec3 inside_{0};
    std::vector<Edge> edges_;
};

Ray ray_of(const vec3& origin, const dvec3& direction) {
    Ray ray;
    ray.origin = origin;
    ray.direction = vec3(glm::normalize(direction));
    return ray;
}

/// The ray from a surface point on the side that `direction` goes to.
Ray spawn(const SurfacePoint& at, const vec3& direction) {
    Ray ray;
    ray.origin = offset_ray_origin(at.p, at.p_error, at.n, direction);
    ray.direction = direction;
    return ray;
}

/// Too grazing to tell sides apart: rounding decides.
bool is_grazing(const SurfacePoint& at, const vec3& direction) {
    return std::abs(glm::dot(at.n, direction)) < 1e-5f * glm::length(direction);
}

/// Follows a ray from inside from face to face, as light among mirrors for part of the way.
void bounce_inside(EnclosedWorld& solid, Ray ray, int bounces, Random& random, Tally& tally) {
    for (int i = 0; i < bounces; ++i) {
        const Hit hit = solid.world().closest(ray);
        ++tally.rays;
        tally.on_edge += hit.on_edge ? 1 : 0;
        if (!hit)
            return tally.fail(describe(ray) + ": leaves a closed solid after " + std::to_string(i) +
                              " bounces");
        ++tally.hits;
        const SurfacePoint at = solid.world().surface(ray, hit);
        if (!is_grazing(at, ray.direction) && glm::dot(at.n, ray.direction) < 0)
            return tally.fail(describe(ray) + ": began outside the solid that it was in; " + describe(hit));
        vec3 direction = ray.direction;
        if (!random.one_in(4)) direction = vec3(glm::normalize(solid.target() - dvec3(at.p)));
        const float out = glm::dot(direction, at.n);
        if (out > 0) direction = direction - at.n * (2 * out);
        if (is_grazing(at, direction)) return;
        ray = spawn(at, direction);
    }
}

} // namespace

Tally run_enclosed(Enclosed kind, std::uint64_t seed, std::uint32_t rays) {
    Random random(seed);
    EnclosedWorld solid(kind, random);
    Tally tally;
    while (tally.rays < rays) {
        bounce_inside(solid, ray_of(vec3(solid.inside()), solid.target() - solid.inside()), 16, random,
                      tally);

        // Through the solid from outside: into it, and out for good.
        const dvec3 outside = solid.outside();
        const Ray first = ray_of(vec3(outside), solid.target() - outside);
        const Hit entry = solid.world().closest(first);
        ++tally.rays;
        if (!entry) continue;
        const SurfacePoint in = solid.world().surface(first, entry);
        if (is_grazing(in, first.direction)) continue;
        if (glm::dot(in.n, first.direction) > 0) {
            // Where a ray touches an edge of two objects, the one behind may be the one that is hit.
            if (kind == Enclosed::faces) continue;
            tally.fail(describe(first) + ": meets a closed solid from inside; " + describe(entry));
            continue;
        }
        const Ray second = spawn(in, first.direction);
        const Hit exit = solid.world().closest(second);
        ++tally.rays;
        if (!exit) {
            tally.fail(describe(second) + ": is outside of the solid that it entered");
            continue;
        }
        bounce_inside(solid, second, 8, random, tally);
        const SurfacePoint out = solid.world().surface(second, exit);
        if (is_grazing(out, first.direction) || !solid.is_convex()) continue;
        const Ray third = spawn(out, first.direction);
        ++tally.rays;
        if (solid.world().closest(third))
            tally.fail(describe(third) + ": is inside of the solid that it left");
    }
    return tally;
}

} // namespace glint::stress
