// Difficult rays against brute force.

#include "batches.h"
#include "soups.h"

#include <cmath>
#include <limits>
#include <vector>

namespace glint::stress {

using trace::Hit;
using trace::World;
using trace::WorldInput;

namespace {

/// Difficult rays in a world: through corners and edges, along sides and axes, from far away.
class DifficultRays {
  public:
    DifficultRays(const WorldInput& world, const ScaledOffset& to_world, Random& random)
        : to_world_(to_world), random_(random) {
        for (const auto& mesh : world.meshes)
            for (const uvec3& t : mesh.triangles)
                for (int k = 0; k < 3; ++k) corners_.push_back(mesh.positions[t[k]]);
        for (const auto& instance : world.instances) {
            const WorldInput::SharedMesh& mesh = world.shared_meshes[instance.mesh];
            for (const uvec3& t : *mesh.triangles)
                for (int k = 0; k < 3; ++k)
                    corners_.push_back(
                        vec3(dvec3(instance.world_from_mesh * dvec4(dvec3((*mesh.positions)[t[k]]), 1.0))));
        }
        if (corners_.empty())
            for (const auto& q : world.quadrics)
                if (q.shape.kind == quadric_sphere)
                    for (int k = 0; k < 3; ++k) corners_.push_back(vec3(q.shape.base));
        while (corners_.size() < 3) corners_.push_back(to_world(random.in_cube(1.0)));
    }

    Ray operator()() {
        Ray ray;
        ray.origin = origin();
        ray.direction = direction(ray.origin);
        // Directions of any length; t is in units of it.
        if (random_.one_in(4))
            ray.direction *= std::ldexp(1.0f, random_.between(-20, 20));
        else if (random_.one_in(2))
            ray.direction = vec3(glm::normalize(dvec3(ray.direction)));
        if (random_.one_in(16))
            ray.tmin = random_.one_in(2) ? -std::numeric_limits<float>::infinity()
                                         : -static_cast<float>(random_.power_of_ten(-3, 3));
        return ray;
    }

  private:
    vec3 corner(std::uint32_t t, std::uint32_t k) { return corners_[3 * t + k % 3]; }
    std::uint32_t any_triangle() { return random_.below(static_cast<std::uint32_t>(corners_.size() / 3)); }

    vec3 on_edge() {
        const std::uint32_t t = any_triangle();
        const std::uint32_t k = random_.below(3);
        const double along = random_.one_in(2) ? 0.5 : random_.unit();
        return vec3(glm::mix(dvec3(corner(t, k)), dvec3(corner(t, k + 1)), along));
    }

    vec3 within() {
        const std::uint32_t t = any_triangle();
        const double u = random_.unit();
        const double v = random_.unit() * (1.0 - u);
        return vec3(dvec3(corner(t, 0)) * (1.0 - u - v) + dvec3(corner(t, 1)) * u + dvec3(corner(t, 2)) * v);
    }

    vec3 origin() {
        switch (random_.below(6)) {
        case 0:
            return within();
        case 1: {
            const std::uint32_t t = any_triangle();
            return corner(t, random_.below(3));
        }
        case 2: {
            const double distance = std::ldexp(1.0, random_.between(2, 14));
            return to_world_(random_.direction() * distance);
        }
        default:
            return to_world_(random_.in_cube(2.0));
        }
    }

    vec3 axis() {
        vec3 d(random_.along_axis());
        // Nearly parallel to an axis: stresses 1/d.
        const int other = random_.axis();
        if (random_.one_in(2)) d[other] += random_.one_in(2) ? 1e-30f : -1e-12f;
        return d;
    }

    vec3 direction(const vec3& from) {
        const std::uint32_t t = any_triangle();
        const std::uint32_t k = random_.below(3);
        vec3 d(0.0f);
        switch (random_.below(6)) {
        case 0:
            d = corner(t, k) - from;
            break;
        case 1:
            d = on_edge() - from;
            break;
        case 2:
        case 3:
            d = within() - from;
            break;
        case 4:
            d = random_.one_in(2) ? axis() : corner(t, k) - corner(t, k + 1);
            break;
        default:
            d = vec3(random_.direction());
        }
        return d == vec3(0.0f) ? vec3(0.0f, 1.0f, 0.0f) : d;
    }

    const ScaledOffset& to_world_;
    Random& random_;
    std::vector<vec3> corners_;
};

/// Enumerates hits with next() and compares them with all_hits().
bool next_agrees(const World& world, const Ray& ray) {
    std::vector<Hit> all;
    world.all_hits(ray, all);
    Hit at = world.closest(ray);
    for (const Hit& expected : all) {
        if (!same(at, expected)) return false;
        at = world.next(ray, at);
    }
    return !at;
}

/// Compares one ray with brute force, then a second ray that ends at its hit.
void compare(const World& world, Ray ray, Random& random, ExpectedHits& expected, Tally& tally) {
    for (int round = 0; round < 2; ++round) {
        const Hit hit = world.closest(ray);
        const Hit truth = world.closest_brute_force(ray);
        ++tally.rays;
        tally.hits += truth ? 1 : 0;
        tally.on_edge += truth.on_edge ? 1 : 0;
        if (!same(hit, truth))
            tally.fail(describe(ray) + ": closest is " + describe(hit) + ", not " + describe(truth));
        const bool blocked = world.occluded_brute_force(ray);
        expected.add(ray, truth, blocked);
        if (world.occluded(ray) != blocked) tally.fail(describe(ray) + ": occluded differs from brute force");
        if (random.one_in(16) && !next_agrees(world, ray))
            tally.fail(describe(ray) + ": next() differs from all_hits()");
        // Set a bound exactly to a hit: both are exclusive.
        float& bound = random.one_in(2) ? ray.tmin : ray.tmax;
        bound = truth ? truth.t : 1.0f;
    }
}

} // namespace

Tally run_soup(Soup kind, std::uint64_t seed, std::uint32_t rays) {
    Random random(seed);
    const ScaledOffset to_world = random_offset(random, 24);
    WorldInput input = make_soup(kind, to_world, random);
    DifficultRays next_ray(input, to_world, random);
    parallel::TaskPool pool(1);
    const World world(std::move(input), pool);
    Tally tally;
    ExpectedHits expected;
    for (const std::uint64_t single = rays_traced_once(rays); tally.rays < single;)
        compare(world, next_ray(), random, expected, tally);
    check_batches(world, expected, random, tally);
    return tally;
}

} // namespace glint::stress
