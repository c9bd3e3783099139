// Guessing the up axis of a mesh by what it could stand on.

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

// Points and surface of a mesh.
struct Body {
    std::vector<dvec3> points; ///< finite, and used by a face if there are faces
    dvec3 middle{0};           ///< centre of the surface, or of the points
    dvec3 facing{0};           ///< vector area of the surface: 0 if closed
};

std::vector<dvec3> points_of(const Mesh& mesh) {
    std::vector<bool> used(mesh.positions.size(), mesh.triangles.empty());
    for (const glm::uvec3& t : mesh.triangles) used[t.x] = used[t.y] = used[t.z] = true;

    std::vector<dvec3> points;
    for (std::size_t i = 0; i < used.size(); ++i) {
        const glm::vec3& p = mesh.positions[i];
        if (used[i] && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) points.emplace_back(p);
    }
    return points;
}

Body body_of(const Mesh& mesh) {
    Body body{points_of(mesh)};
    dvec3 moment(0);
    double surface = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        const dvec3 a(mesh.positions[t.x]);
        const dvec3 b(mesh.positions[t.y]);
        const dvec3 c(mesh.positions[t.z]);
        const dvec3 normal = glm::cross(b - a, c - a);
        const double size = glm::length(normal);
        if (!std::isfinite(size)) continue;
        surface += size;
        body.facing += normal;
        moment += size / 3 * (a + b + c);
    }
    if (surface > 0) {
        body.facing /= surface;
        body.middle = moment / surface;
        return body;
    }
    for (const dvec3& p : body.points) body.middle += p / static_cast<double>(body.points.size());
    return body;
}

// A point projected along the given axis.
dvec2 on_ground(const dvec3& p, int up) { return dvec2(p[(up + 1) % 3], p[(up + 2) % 3]); }

// Convex hull, seen along the axis, of the points between two heights.
std::vector<dvec2> hull_between(const Body& body, int up, double from, double to) {
    std::vector<dvec2> points;
    for (const dvec3& p : body.points) {
        if (p[up] >= from && p[up] <= to) points.push_back(on_ground(p, up));
    }
    return convex_hull(std::move(points));
}

// How well the mesh stands with this axis up: the fraction of its outline covered by its lowest layer, minus
// half that of its highest layer, minus a penalty if it would fall over. A ball has about 0.06, a box 0.5.
double stability(const Body& body, int up) {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (const dvec3& p : body.points) {
        lowest = std::min(lowest, p[up]);
        highest = std::max(highest, p[up]);
    }
    const double whole = area(hull_between(body, up, lowest, highest));
    if (!(whole > 0)) return 0;

    const double layer = (highest - lowest) * 0.03;
    const std::vector<dvec2> base = hull_between(body, up, lowest, lowest + layer);
    const double top = area(hull_between(body, up, highest - layer, highest)) / whole;
    const double share = area(base) / whole;
    return (contains(base, on_ground(body.middle, up)) ? share : 0.3 * share) - 0.5 * top;
}

} // namespace

Axis guess_up_axis(const Mesh& mesh) {
    const Body body = body_of(mesh);

    // Threshold for open sheets such as landscapes, which show their upper side.
    constexpr double open = 0.3;
    const dvec3 facing = glm::abs(body.facing);
    if (std::max(facing.y, facing.z) > open) return facing.y > facing.z ? Axis::y : Axis::z;

    // Threshold for standing on a flat base. Otherwise y is up, as in most scans.
    constexpr double standing = 0.1;
    const double with_z_up = stability(body, 2);
    return with_z_up > standing && with_z_up >= stability(body, 1) ? Axis::z : Axis::y;
}

} // namespace glint
