// Torus, knot and shell as deformed grids.

#include "math/trig.h"
#include "shapes.h"

#include <cstdint>

namespace glint::meshgen {
namespace {

using Index = std::uint32_t;

// Cross-section of a tube: u and v span its plane, u × v points along the tube.
struct Section {
    dvec3 center{0};
    dvec3 u{1, 0, 0};
    dvec3 v{0, 1, 0};
    double radius = 1;
};

void add_section(Mesh& mesh, const Section& s, int across) {
    for (int j = 0; j < across; ++j) {
        const double angle = 360.0 * j / across;
        const dvec3 out = s.u * cos_degrees(angle) + s.v * sin_degrees(angle);
        mesh.positions.emplace_back(s.center + s.radius * out);
    }
}

// Adds triangles between two adjacent sections, given their first vertices.
void join_sections(Mesh& mesh, Index first, Index next, int across) {
    const Index n = static_cast<Index>(across);
    for (Index j = 0; j < n; ++j) {
        const Index k = (j + 1) % n;
        mesh.triangles.emplace_back(first + j, first + k, next + k);
        mesh.triangles.emplace_back(first + j, next + k, next + j);
    }
}

// Closes one end of a tube with a triangle fan.
void cap_section(Mesh& mesh, Index first, const dvec3& middle, int across, bool at_start) {
    const Index n = static_cast<Index>(across);
    const Index center = static_cast<Index>(mesh.positions.size());
    mesh.positions.emplace_back(middle);
    for (Index j = 0; j < n; ++j) {
        const Index k = (j + 1) % n;
        if (at_start) {
            mesh.triangles.emplace_back(center, first + k, first + j);
        } else {
            mesh.triangles.emplace_back(center, first + j, first + k);
        }
    }
}

// A tube whose ends are joined.
Mesh closed_tube(int around, int across, const std::function<Section(int)>& section) {
    Mesh mesh;
    for (int i = 0; i < around; ++i) add_section(mesh, section(i), across);
    for (int i = 0; i < around; ++i) {
        const Index first = static_cast<Index>(i * across);
        join_sections(mesh, first, static_cast<Index>((i + 1) % around * across), across);
    }
    return mesh;
}

} // namespace

Mesh make_torus(int around, int across, double radius, double tube) {
    return closed_tube(around, across, [&](int i) {
        const double angle = 360.0 * i / around;
        const dvec3 out(cos_degrees(angle), sin_degrees(angle), 0);
        return Section{out * radius, dvec3(0, 0, 1), out, tube};
    });
}

Mesh make_knot(int around, int across, const Knot& knot) {
    return closed_tube(around, across, [&](int i) {
        // The torus normal gives a frame that is continuous around the knot.
        const double along = 360.0 * i / around * knot.p;
        const double through = 360.0 * i / around * knot.q;
        const dvec3 out(cos_degrees(along), sin_degrees(along), 0);
        const dvec3 on(-sin_degrees(along), cos_degrees(along), 0);
        const dvec3 up(0, 0, 1);
        const dvec3 normal = out * cos_degrees(through) + up * sin_degrees(through);
        const double reach = knot.radius + knot.swing * cos_degrees(through);
        const dvec3 tangent =
            on * (reach * knot.p) +
            (up * cos_degrees(through) - out * sin_degrees(through)) * (knot.swing * knot.q);
        const dvec3 center = out * knot.radius + normal * knot.swing;
        return Section{center, normal, glm::normalize(glm::cross(tangent, normal)), knot.tube};
    });
}

Mesh make_shell(int around, int across) {
    constexpr double turns = 4.25;
    constexpr double ribs = 15; // ribs per turn
    Mesh mesh;
    dvec3 mouth(0);
    for (int i = 1; i <= around; ++i) {
        // Growth with the fourth power approximates a shell's logarithmic spiral.
        const double t = static_cast<double>(i) / around;
        const double grown = 0.06 + 0.94 * t;
        const double size = grown * grown * grown * grown;
        const double angle = 360 * turns * t;
        const dvec3 out(cos_degrees(angle), sin_degrees(angle), 0);
        const double rib = 1 + 0.05 * cos_degrees(angle * ribs);
        const dvec3 center = out * (0.62 * size) + dvec3(0, 0, 0.25 * (1 - size));
        add_section(mesh, {center, dvec3(0, 0, 1), out, 0.38 * size * rib}, across);
        mouth = center;
    }
    for (int i = 0; i + 1 < around; ++i) {
        join_sections(mesh, static_cast<Index>(i * across), static_cast<Index>((i + 1) * across), across);
    }
    cap_section(mesh, 0, dvec3(0, 0, 0.25), across, true);
    cap_section(mesh, static_cast<Index>((around - 1) * across), mouth, across, false);
    return mesh;
}

} // namespace glint::meshgen
