#pragma once
// Small worlds for tests.

#include "trace/world/world.h"

#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace glint {

inline trace::World world_of(trace::WorldInput input, int threads = 1) {
    parallel::TaskPool pool(threads);
    return trace::World(std::move(input), pool);
}

inline Ray ray_from(const vec3& origin, const vec3& direction) {
    Ray ray;
    ray.origin = origin;
    ray.direction = direction;
    return ray;
}

/// The unit square z = height with corners (0, 0) and (1, 1), two triangles with normal +z.
inline trace::WorldInput::Triangles square(std::uint32_t object, float height) {
    trace::WorldInput::Triangles mesh;
    mesh.object = object;
    mesh.positions = {{0, 0, height}, {1, 0, height}, {1, 1, height}, {0, 1, height}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

/// Numbers in [-1, 1) that are the same everywhere.
class Numbers {
  public:
    explicit Numbers(std::uint64_t seed) : engine_(seed) {}
    double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-52 - 1.0; }
    dvec3 point() {
        const double x = (*this)();
        const double y = (*this)();
        const double z = (*this)();
        return {x, y, z};
    }
    dvec3 direction() {
        for (;;) {
            const dvec3 p = point();
            const double squared = glm::dot(p, p);
            if (squared <= 1.0 && squared > 1e-3) return p / std::sqrt(squared);
        }
    }
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(engine_() % n); }

  private:
    std::mt19937_64 engine_;
};

} // namespace glint
