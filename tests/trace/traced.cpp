#include "traced.h"

#include "geometry/triangle.h"
#include "math/offset.shared.h"
#include "math/random.shared.h"

#include <bit>
#include <cmath>
#include <limits>

namespace glint::tracing {
namespace {

std::array<float, 3> draw_point(std::uint32_t key, std::uint32_t index) {
    return {draw(key, 3 * index), draw(key, 3 * index + 1), draw(key, 3 * index + 2)};
}

bool can_hit(const Ray& ray) {
    bool finite = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
        finite = finite && std::isfinite(ray.origin[axis]) && std::isfinite(ray.direction[axis]);
    return finite && (ray.direction[0] != 0 || ray.direction[1] != 0 || ray.direction[2] != 0);
}

void spoil(Ray& ray, std::uint32_t i) {
    if (i % 128 == 5) ray.direction[0] = std::numeric_limits<float>::quiet_NaN();
    if (i % 128 == 6) ray.origin[1] = std::numeric_limits<float>::infinity();
    if (i % 128 == 7) ray.direction = {0, 0, 0};
}

} // namespace

float draw(std::uint32_t key, std::uint32_t index) { return unit_float(hash_with(hash_mix(key), index)); }

Soup make_soup(std::uint32_t seed, std::uint32_t count) {
    Soup soup;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::array<float, 3> at = draw_point(seed, 4 * i);
        for (std::uint32_t k = 1; k < 4; ++k) {
            const std::array<float, 3> out = draw_point(seed, 4 * i + k);
            for (std::size_t axis = 0; axis < 3; ++axis)
                soup.xyz.push_back(at[axis] + (out[axis] - 0.5f) * 0.3f);
        }
        const std::uint32_t first = 3 * (i % 16 == 15 ? i - 1 : i);
        soup.corners.insert(soup.corners.end(), {first, first + 1, i % 32 == 7 ? first : first + 2});
    }
    return soup;
}

std::vector<Ray> make_rays(const Soup& soup, std::uint32_t seed, std::uint32_t count) {
    std::vector<Ray> rays;
    const auto vertices = static_cast<std::uint32_t>(soup.xyz.size() / 3);
    for (std::uint32_t i = 0; i < count; ++i) {
        Ray ray;
        const std::array<float, 3> from = draw_point(seed, 2 * i);
        const std::array<float, 3> way = draw_point(seed, 2 * i + 1);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            ray.origin[axis] = from[axis] * 3 - 1;
            ray.direction[axis] = way[axis] - 0.5f;
        }
        if (i % 3 == 0) ray.direction = {0.1f, 0.2f, 1.0f};
        if (i % 16 == 1) ray.direction = {0.0f, i % 32 == 1 ? -0.0f : 0.0f, i % 64 == 1 ? -1e-12f : 2.0f};
        if (i % 8 == 2) ray.tmax = 0.4f;
        if (i % 8 == 3) ray.tmin = 0.5f;
        if (i % 8 == 4 && vertices > 0)
            for (std::size_t axis = 0; axis < 3; ++axis)
                ray.direction[axis] = soup.xyz[3 * (i * 7 % vertices) + axis] - ray.origin[axis];
        spoil(ray, i);
        rays.push_back(ray);
    }
    return rays;
}

Hit brute_force(const Soup& soup, const Ray& ray) {
    Hit best;
    if (!can_hit(ray)) return best;
    const glint::Ray inner{vec3(ray.origin[0], ray.origin[1], ray.origin[2]), ray.tmin,
                           vec3(ray.direction[0], ray.direction[1], ray.direction[2]), ray.tmax};
    const geometry::ShearedRay sheared(inner);
    float limit = next_float(ray.tmax, -1.0f);
    for (std::uint32_t i = 0; i < soup.triangles(); ++i) {
        geometry::TriangleVertices vertices;
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t axis = 0; axis < 3; ++axis)
                vertices[k][axis] = soup.xyz[3 * soup.corners[3 * i + k] + axis];
        TriangleHit hit;
        if (!geometry::intersect_triangle(sheared, vertices, ray.tmin, limit, hit)) continue;
        if (hit.t == limit && best) continue;
        limit = hit.t;
        best = {hit.t, hit.u, hit.v, i};
    }
    return best;
}

bool same_bits(const Hit& a, const Hit& b) {
    const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
    return bits(a.t) == bits(b.t) && bits(a.u) == bits(b.u) && bits(a.v) == bits(b.v) &&
           a.triangle == b.triangle;
}

} // namespace glint::tracing
