// Choosing resolutions for the requested number of triangles.

#include "request.h"

#include "geometry/mesh.h"
#include "shapes.h"

#include <algorithm>
#include <cmath>

namespace glint::meshgen {
namespace {

// Steps along and around a tube with square cells.
struct Steps {
    int around = 3;
    int across = 3;
};

Steps tube_steps(double triangles, double length, double girth) {
    const double across = std::sqrt(triangles / 2 * girth / length);
    Steps steps;
    steps.across = std::max(3, static_cast<int>(std::round(across)));
    steps.around = std::max(3, static_cast<int>(std::round(triangles / 2 / steps.across)));
    return steps;
}

Mesh knot(const Request& r) {
    // Many windings need a thinner tube.
    Knot shape{r.p, r.q, 2, 1, 0.5};
    if (r.p > 2 || r.q > 3) shape.tube = 1.2 / std::max(r.p, r.q);
    const Steps steps = tube_steps(r.triangles, 13.0 * r.p + 4.0 * r.q, 6.3 * shape.tube);
    Mesh mesh = make_knot(steps.around, steps.across, shape);
    paint(mesh, [&](std::size_t i, const dvec3&) {
        return rainbow(static_cast<double>(i / static_cast<std::size_t>(steps.across)) / steps.around);
    });
    return mesh;
}

Mesh torus(const Request& r) {
    const Steps steps = tube_steps(r.triangles, 1, 0.4);
    Mesh mesh = make_torus(steps.around, steps.across, 1, 0.4);
    paint(mesh, [&](std::size_t i, const dvec3&) {
        return rainbow(static_cast<double>(i / static_cast<std::size_t>(steps.across)) / steps.around);
    });
    return mesh;
}

Mesh shell(const Request& r) {
    const Steps steps = tube_steps(r.triangles, 9, 1);
    Mesh mesh = make_shell(steps.around, steps.across);
    paint(mesh, [](std::size_t, const dvec3& p) {
        const double far = std::min(1.0, glm::length(dvec2(p)));
        return dvec3(0.75, 0.52, 0.34) * (1 - far) + dvec3(0.86, 0.80, 0.70) * far;
    });
    return mesh;
}

Mesh icosphere(const Request& r) {
    int levels = 0;
    for (double count = 20; count * 2 < r.triangles; count *= 4) ++levels;
    Mesh mesh = make_icosphere(levels);
    paint(mesh, [](std::size_t, const dvec3& p) { return (p + 1.0) / 2.0; });
    return mesh;
}

Mesh terrain(const Request& r) {
    Mesh mesh = make_terrain(std::max(1, static_cast<int>(std::sqrt(r.triangles / 2))), r.seed);
    float highest = 0;
    for (const vec3& p : mesh.positions) highest = std::max(highest, p.z);
    if (highest == 0) highest = 1;
    paint(mesh, [&](std::size_t, const dvec3& p) { return landscape(p.z / static_cast<double>(highest)); });
    return mesh;
}

Mesh gyroid(const Request& r) {
    constexpr double periods = 2;
    constexpr double thickness = 0.07;
    // The number of triangles grows with the square of the cells: a coarse trial determines the resolution.
    constexpr int trial = 80;
    const auto count = static_cast<double>(make_gyroid(trial, periods, thickness).triangles.size());
    const int cells = std::max(4, static_cast<int>(std::round(trial * std::sqrt(r.triangles / count))));
    Mesh mesh = make_gyroid(cells, periods, thickness);
    paint(mesh, [](std::size_t, const dvec3& p) { return rainbow(0.62 - 0.55 * glm::length(p)); });
    return mesh;
}

Mesh plain_mesh(const Request& r) {
    switch (r.kind) {
    case Kind::gyroid:
        return gyroid(r);
    case Kind::knot:
        return knot(r);
    case Kind::torus:
        return torus(r);
    case Kind::shell:
        return shell(r);
    case Kind::icosphere:
        return icosphere(r);
    case Kind::terrain:
        return terrain(r);
    case Kind::flake:
    case Kind::city:
    case Kind::spiral:
        break;
    }
    throw Error(ErrorKind::internal, "a scene was asked for as a mesh");
}

} // namespace

Mesh make_mesh(const Request& request) {
    Mesh mesh = plain_mesh(request);
    if (!request.colors) mesh.colors.clear();
    if (!request.flat) mesh.normals = geometry::smooth_normals(mesh.positions, mesh.triangles);
    return mesh;
}

} // namespace glint::meshgen
