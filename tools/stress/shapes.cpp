#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace glint::stress {

namespace {

/// Cuts every triangle in four; new vertices go onto the unit sphere.
void subdivide(Polyhedron& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [at, fresh] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.positions.size()));
        if (fresh) mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
        return at->second;
    };
    std::vector<uvec3> finer;
    for (const uvec3& t : mesh.triangles) {
        const std::uint32_t xy = middle(t.x, t.y);
        const std::uint32_t yz = middle(t.y, t.z);
        const std::uint32_t zx = middle(t.z, t.x);
        finer.insert(finer.end(), {{t.x, xy, zx}, {t.y, yz, xy}, {t.z, zx, yz}, {xy, yz, zx}});
    }
    mesh.triangles = std::move(finer);
}

} // namespace

Polyhedron make_icosphere(int levels) {
    Polyhedron mesh = make_icosahedron(dvec3(0.0), 1.0);
    for (int i = 0; i < levels; ++i) subdivide(mesh);
    return mesh;
}

Polyhedron make_torus(int around, int across) {
    Polyhedron mesh;
    const auto vertex = [&](int i, int j) {
        return static_cast<std::uint32_t>((i % around) * across + j % across);
    };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double a = 2.0 * std::numbers::pi * i / around;
            const double b = 2.0 * std::numbers::pi * j / across;
            const double r = 1.0 + 0.4 * std::cos(b);
            mesh.positions.emplace_back(r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b));
            mesh.triangles.emplace_back(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
            mesh.triangles.emplace_back(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
        }
    return mesh;
}

Placement random_placement(Random& random, int offset_bits) {
    Placement placement;
    if (random.one_in(2)) return placement;
    if (random.one_in(2)) placement.scale = std::pow(10.0, random.between(-12, 12));
    if (random.one_in(2)) {
        const int bits = random.between(0, offset_bits);
        placement.offset = random.in_cube(std::ldexp(1.0, bits));
    }
    return placement;
}

} // namespace glint::stress
