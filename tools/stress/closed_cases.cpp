// Rays through edges and vertices of closed meshes, which must not leak.

#include "batches.h"
#include "families.h"
#include "geometry/polyhedron.h"
#include "trace/world/world.h"

#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace glint::stress {

using geometry::Polyhedron;
using trace::Hit;
using trace::World;
using trace::WorldInput;

namespace {

Polyhedron random_polyhedron(Random& random) {
    switch (random.below(4)) {
    case 0:
        return geometry::make_box(dvec3(0.0), dvec3(1.5));
    case 1:
        return geometry::make_octahedron(dvec3(0.0), 1.5);
    case 2:
        return geometry::make_dodecahedron(dvec3(0.0), 1.0);
    default:
        return geometry::make_icosahedron(dvec3(0.0), 1.0);
    }
}

Polyhedron in_double(const Mesh& mesh, double scale) {
    Polyhedron result;
    for (const vec3& p : mesh.positions) result.positions.push_back(dvec3(p) * scale);
    result.triangles = mesh.triangles;
    return result;
}

/// A closed mesh approximately within the unit ball.
Polyhedron make_closed(Closed kind, Random& random) {
    const int around = random.between(16, 32);
    const int across = random.between(8, 16);
    switch (kind) {
    case Closed::icosphere:
        return in_double(meshgen::make_icosphere(random.between(1, 3)), 1.0);
    case Closed::torus:
        return in_double(meshgen::make_torus(around, across, 1.0, 0.4), 1.0);
    case Closed::knot:
        return in_double(meshgen::make_knot(4 * around, across, {}), 0.3);
    case Closed::polyhedron:
        break;
    }
    return random_polyhedron(random);
}

/// A closed mesh in float coordinates, and rays toward its edges and vertices.
class ClosedWorld {
  public:
    ClosedWorld(Closed kind, Random& random)
        : kind_(kind), random_(random), to_world_(random_offset(random, 12)),
          shape_(make_closed(kind, random)) {
        // Half the time scale by a factor that leaves no round coordinates.
        if (random.one_in(2))
            for (dvec3& p : shape_.positions) p *= 1.0 - 0.01 * random.unit();
        WorldInput input;
        input.meshes.resize(1);
        for (const dvec3& p : shape_.positions) input.meshes[0].positions.push_back(to_world_(p));
        input.meshes[0].triangles = shape_.triangles;
        parallel::TaskPool pool(1);
        world_ = World(std::move(input), pool);
    }

    const World& world() const { return world_; }

    /// A point inside by a margin that covers the faceting and the rounding at offsets of 2^12.
    dvec3 inside_point() {
        if (kind_ != Closed::torus) return random_.in_ball(0.7);
        const double angle = random_.uniform(0.0, 2.0 * std::numbers::pi);
        return dvec3(std::cos(angle), std::sin(angle), 0.0) + random_.in_ball(0.2);
    }

    Ray from_inside() {
        const dvec3 inside = inside_point();
        Ray ray = toward(to_world_(inside), target());
        if (!random_.one_in(4)) return ray;
        // Straight up or down through a vertex: the origin shares two of its coordinates exactly.
        const dvec3& vertex = shape_.positions[any(shape_.positions.size())];
        const int axis = random_.axis();
        dvec3 origin = vertex;
        origin[axis] = 0.0;
        if (kind_ == Closed::torus || glm::dot(origin, origin) > 0.49) return ray;
        ray.origin = to_world_(origin);
        ray.direction = vec3(0.0f);
        ray.direction[axis] = static_cast<float>(random_.sign());
        return ray;
    }

    Ray from_outside() {
        const double distance = std::ldexp(1.0, random_.between(2, 8));
        const vec3 outside = to_world_(random_.direction() * distance);
        if (!random_.one_in(4)) return toward(outside, target());
        const dvec3& vertex = shape_.positions[any(shape_.positions.size())];
        const int axis = random_.axis();
        dvec3 origin = vertex;
        origin[axis] = -distance;
        Ray ray;
        ray.origin = to_world_(origin);
        ray.direction = vec3(0.0f);
        ray.direction[axis] = 1.0f;
        return ray;
    }

  private:
    std::uint32_t any(std::size_t count) { return random_.below(static_cast<std::uint32_t>(count)); }

    /// A vertex, a point on an edge or face, or any nearby point.
    vec3 target() {
        const uvec3& t = shape_.triangles[any(shape_.triangles.size())];
        const dvec3 a(to_world_(shape_.positions[t.x]));
        const dvec3 b(to_world_(shape_.positions[t.y]));
        const dvec3 c(to_world_(shape_.positions[t.z]));
        const double x = random_.unit();
        const double y = random_.unit();
        switch (random_.below(4)) {
        case 0:
            return vec3(a);
        case 1:
            return vec3(a + (b - a) * (random_.one_in(2) ? 0.5 : x));
        case 2:
            return vec3(a + (b - a) * x + (c - a) * (y * (1.0 - x)));
        default:
            return to_world_(random_.in_ball(1.2));
        }
    }

    Ray toward(const vec3& origin, const vec3& target) {
        Ray ray;
        ray.origin = origin;
        ray.direction = target - origin;
        if (random_.one_in(2)) ray.direction = vec3(glm::normalize(dvec3(ray.direction)));
        // Along an axis from a random point.
        if (random_.one_in(8)) ray.direction = vec3(random_.along_axis());
        if (ray.direction == vec3(0.0f)) ray.direction.x = 1.0f;
        return ray;
    }

    Closed kind_;
    Random& random_;
    ScaledOffset to_world_;
    Polyhedron shape_;
    World world_;
};

} // namespace

Tally run_inside(Closed kind, std::uint64_t seed, std::uint32_t rays) {
    Random random(seed);
    ClosedWorld closed(kind, random);
    Tally tally;
    ExpectedHits expected;
    for (const std::uint64_t single = rays_traced_once(rays); tally.rays < single; ++tally.rays) {
        const Ray ray = closed.from_inside();
        const Hit hit = closed.world().closest(ray);
        tally.hits += hit ? 1 : 0;
        tally.on_edge += hit.on_edge ? 1 : 0;
        if (!hit) tally.fail(describe(ray) + ": leaks out of a closed mesh");
        if (!closed.world().occluded(ray)) tally.fail(describe(ray) + ": leaks out unoccluded");
        expected.add(ray, hit, true);
    }
    check_batches(closed.world(), expected, random, tally);
    return tally;
}

Tally run_through(Closed kind, std::uint64_t seed, std::uint32_t rays) {
    Random random(seed);
    ClosedWorld closed(kind, random);
    Tally tally;
    std::vector<Hit> all_hits;
    for (; tally.rays < rays; ++tally.rays) {
        const Ray ray = closed.from_outside();
        closed.world().all_hits(ray, all_hits);
        const bool apart =
            std::any_of(all_hits.begin(), all_hits.end(), [](const Hit& h) { return h.on_edge; });
        tally.hits += all_hits.empty() ? 0 : 1;
        tally.on_edge += apart ? 1 : 0;
        if (!apart && all_hits.size() % 2 != 0)
            tally.fail(describe(ray) + ": crosses a closed mesh " + std::to_string(all_hits.size()) +
                       " times");
    }
    return tally;
}

} // namespace glint::stress
