// Rays that start on the surface of closed solids, near their edges above all: none may start on the wrong
// side.

#include "batches.h"
#include "families.h"
#include "geometry/polyhedron.h"
#include "geometry/quadric.h"
#include "math/offset.shared.h"
#include "trace/world/world.h"

#include "shapes.h"

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

/// One convex solid, a point inside, and points of its edges, corners and rims.
class ConvexWorld {
  public:
    ConvexWorld(Enclosed kind, Random& random) : random_(random), to_world_(random_offset(random, 3)) {
        WorldInput input;
        if (kind == Enclosed::quadric)
            add_quadric(input);
        else
            add_mesh(kind, input);
        parallel::TaskPool pool(1);
        world_ = World(std::move(input), pool);
    }

    const World& world() const { return world_; }
    dvec3 inside() const { return inside_; }
    double scale() const { return to_world_.scale; }

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

    void add_mesh(Enclosed kind, WorldInput& input) {
        Polyhedron solid = random_solid(random_);
        if (kind == Enclosed::icosphere) {
            const Mesh mesh = meshgen::make_icosphere(random_.between(1, 3));
            solid.positions.assign(mesh.positions.begin(), mesh.positions.end());
            solid.triangles = mesh.triangles;
        }
        std::vector<dvec3> corners;
        if (kind == Enclosed::instance)
            corners = add_instance(solid, input);
        else {
            input.meshes.resize(1);
            input.meshes[0].triangles = solid.triangles;
            for (const dvec3& p : solid.positions) {
                input.meshes[0].positions.push_back(to_world_(p));
                corners.push_back(dvec3(input.meshes[0].positions.back()));
            }
        }
        for (const uvec3& t : solid.triangles)
            for (const auto& [from, to] : {std::pair(t.x, t.y), std::pair(t.y, t.z), std::pair(t.z, t.x)})
                edges_.push_back({corners[from], corners[to]});
        for (const dvec3& corner : corners) inside_ = inside_ + corner / static_cast<double>(corners.size());
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
        input.quadrics.push_back(
            {0, 0,
             is_cone ? make_cone(base, axis, height, radius) : make_cylinder(base, axis, height, radius)});
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

    Random& random_;
    ScaledOffset to_world_;
    World world_;
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

/// Follows a ray from inside from face to face.
void bounce_inside(ConvexWorld& solid, Ray ray, int bounces, Tally& tally) {
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
            return tally.fail(describe(ray) + ": began outside the solid that it was in");
        vec3 direction(glm::normalize(solid.target() - dvec3(at.p)));
        const float out = glm::dot(direction, at.n);
        if (out > 0) direction = direction - at.n * (2 * out);
        if (is_grazing(at, direction)) return;
        ray = spawn(at, direction);
    }
}

} // namespace

Tally run_enclosed(Enclosed kind, std::uint64_t seed, std::uint32_t rays) {
    Random random(seed);
    ConvexWorld solid(kind, random);
    Tally tally;
    while (tally.rays < rays) {
        bounce_inside(solid, ray_of(vec3(solid.inside()), solid.target() - solid.inside()), 16, tally);

        // Through the solid from outside: into it, and out for good.
        const dvec3 outside = solid.inside() + random.direction() * (8.0 * solid.scale());
        const Ray first = ray_of(vec3(outside), solid.target() - outside);
        const Hit entry = solid.world().closest(first);
        ++tally.rays;
        if (!entry) continue;
        const SurfacePoint in = solid.world().surface(first, entry);
        // Where a ray touches an edge on the outline only, the face behind may be the one that is hit.
        if (is_grazing(in, first.direction) || glm::dot(in.n, first.direction) > 0) continue;
        const Ray second = spawn(in, first.direction);
        const Hit exit = solid.world().closest(second);
        ++tally.rays;
        if (!exit) {
            tally.fail(describe(second) + ": is outside of the solid that it entered");
            continue;
        }
        const SurfacePoint out = solid.world().surface(second, exit);
        if (is_grazing(out, first.direction)) continue;
        const Ray third = spawn(out, first.direction);
        ++tally.rays;
        if (solid.world().closest(third))
            tally.fail(describe(third) + ": is inside of the solid that it left");
        bounce_inside(solid, second, 8, tally);
    }
    return tally;
}

} // namespace glint::stress
