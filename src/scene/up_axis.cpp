// Which way up a mesh was meant: told by what it could stand on.

#include "glint/scene.h"
#include "math/vec.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace glint {
namespace {

double cross(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }

// The convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<dvec2> convex_hull(std::vector<dvec2> points) {
    std::sort(points.begin(), points.end(),
              [](const dvec2& a, const dvec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<dvec2> hull;
    const auto extend = [&hull](const dvec2& p, std::size_t keep) {
        while (hull.size() > keep && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
            hull.pop_back();
        hull.push_back(p);
    };
    for (const dvec2& p : points) extend(p, 1);
    const std::size_t lower = hull.size();
    for (std::size_t i = points.size(); i-- > 1;) extend(points[i - 1], lower);
    return hull;
}

double area(const std::vector<dvec2>& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    return twice / 2;
}

bool contains(const std::vector<dvec2>& hull, const dvec2& p) {
    for (std::size_t i = 0; i < hull.size(); ++i) {
        if (cross(hull[(i + 1) % hull.size()] - hull[i], p - hull[i]) < 0) return false;
    }
    return hull.size() > 2;
}

// One vertex of a face, seen along an axis: how high, and above which point of the ground.
struct Standing {
    double height = 0;
    dvec2 ground{0};
};

struct Sheet {
    dvec3 middle{0}; ///< centre of the surface
    dvec3 facing{0}; ///< sum of the areas as vectors, by the surface: 0 for what is closed
};

Sheet sheet_of(const Mesh& mesh) {
    Sheet sheet;
    double surface = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        const dvec3 a(mesh.positions[t.x]);
        const dvec3 b(mesh.positions[t.y]);
        const dvec3 c(mesh.positions[t.z]);
        const dvec3 normal = glm::cross(b - a, c - a);
        const double size = glm::length(normal);
        if (!(size > 0) || !std::isfinite(size)) continue;
        surface += size;
        sheet.facing += normal;
        sheet.middle += size / 3 * (a + b + c);
    }
    if (surface > 0) {
        sheet.facing /= surface;
        sheet.middle /= surface;
    }
    return sheet;
}

std::vector<Standing> seen_along(const Mesh& mesh, int up) {
    std::vector<bool> used(mesh.positions.size());
    for (const glm::uvec3& t : mesh.triangles) used[t.x] = used[t.y] = used[t.z] = true;

    std::vector<Standing> seen;
    for (std::size_t i = 0; i < used.size(); ++i) {
        const glm::vec3& p = mesh.positions[i];
        if (used[i]) seen.push_back({p[up], dvec2(p[(up + 1) % 3], p[(up + 2) % 3])});
    }
    return seen;
}

// The hull of what lies between two heights, as seen from above.
std::vector<dvec2> hull_between(const std::vector<Standing>& seen, double from, double to) {
    std::vector<dvec2> points;
    for (const Standing& s : seen) {
        if (s.height >= from && s.height <= to) points.push_back(s.ground);
    }
    return convex_hull(std::move(points));
}

// How well the mesh stands with this axis up: the share of its outline that its lowest layer spans, less what
// its highest one does, and little where it would fall over.
double stability(const Mesh& mesh, const dvec3& middle, int up) {
    const std::vector<Standing> seen = seen_along(mesh, up);
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (const Standing& s : seen) {
        lowest = std::min(lowest, s.height);
        highest = std::max(highest, s.height);
    }
    const double whole = area(hull_between(seen, lowest, highest));
    if (!(whole > 0)) return 0;

    const double layer = (highest - lowest) * 0.02;
    const std::vector<dvec2> base = hull_between(seen, lowest, lowest + layer);
    const double top = area(hull_between(seen, highest - layer, highest)) / whole;
    const double stands = contains(base, dvec2(middle[(up + 1) % 3], middle[(up + 2) % 3])) ? 1 : 0.3;
    return stands * area(base) / whole - 0.5 * top;
}

} // namespace

Axis guess_up_axis(const Mesh& mesh) {
    // An open sheet, such as a landscape, shows its upper side.
    const Sheet sheet = sheet_of(mesh);
    constexpr double open = 0.3;
    const dvec3 facing = glm::abs(sheet.facing);
    if (std::max(facing.y, facing.z) > open) return facing.y > facing.z ? Axis::y : Axis::z;

    // Anything else stands on what is flat and wide enough; where neither is better, up is z, as in scene
    // files.
    const double margin = 0.02;
    return stability(mesh, sheet.middle, 1) > stability(mesh, sheet.middle, 2) + margin ? Axis::y : Axis::z;
}

} // namespace glint
