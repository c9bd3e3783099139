// A torus in letters: the least that a program needs to trace rays with glint.

#include <glint/trace.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

using namespace glint::tracing;

int main() {
    // A mesh is two arrays: x y z of each vertex, and three numbers of vertices for each triangle.
    constexpr std::uint32_t around = 120, across = 60;
    std::vector<float> vertices;
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t i = 0; i < around * across; ++i) {
        const float a = 6.2831853f * static_cast<float>(i / across) / around;
        const float b = 6.2831853f * static_cast<float>(i % across) / across;
        const float r = 2 + 0.9f * std::cos(b);
        vertices.insert(vertices.end(), {r * std::cos(a), r * std::sin(a), 0.9f * std::sin(b)});
        const std::uint32_t up = i % across == across - 1 ? i + 1 - across : i + 1;
        const std::uint32_t on = (i + across) % (around * across), both = (up + across) % (around * across);
        triangles.insert(triangles.end(), {i, on, both, i, both, up});
    }
    const Mesh mesh(vertices, triangles);

    // One ray a letter, neighbours side by side. Directions need no length of 1: t counts in them.
    constexpr int width = 78, height = 26;
    std::vector<Ray> rays;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float right = static_cast<float>(2 * x + 1 - width) / width;
            const float up = static_cast<float>(height - 1 - 2 * y) / width * 2;
            Ray ray;
            ray.origin = {0, -7, 5};
            ray.direction = {0.5f * right, 0.8f + 0.3f * up, -0.57f + 0.4f * up};
            rays.push_back(ray);
        }
    std::vector<Hit> hits(rays.size());
    mesh.closest(rays, hits, RayHint::coherent);

    // From just before each hit another ray, towards the sun: is anything in its way?
    std::vector<Ray> to_sun(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        to_sun[i].direction = {-1, -0.4f, 0.3f};
        for (std::size_t k = 0; hits[i] && k < 3; ++k)
            to_sun[i].origin[k] = rays[i].origin[k] + rays[i].direction[k] * hits[i].t * 0.999f;
    }
    std::vector<std::uint8_t> blocked(rays.size());
    mesh.occluded(to_sun, blocked, RayHint::coherent);

    for (std::size_t i = 0; i < rays.size(); ++i)
        std::printf("%c%s", !hits[i] ? ' ' : blocked[i] ? '.' : '#', (i + 1) % width == 0 ? "\n" : "");
    const Hit hit = mesh.closest({{0, -7, 5}, 0, {0, 4, -4.5f}});
    std::printf("triangle %u at t = %g, u = %g, v = %g\n", hit.triangle, hit.t, hit.u, hit.v);
    return hit ? 0 : 1;
}
