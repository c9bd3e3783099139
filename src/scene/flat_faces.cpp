// Planes compared in double, then the outlines within the plane.

#include "scene/flat_faces.h"

#include "math/trig.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace glint::scene {
namespace {

/// Is a face in the plane of the other? `reach` covers both.
bool in_plane(const FlatFace& face, const FlatFace& other, const dvec3& reach) {
    const double rounding = rounding_at(other, reach);
    const auto on_plane = [&](const dvec3& p) {
        return std::abs(glm::dot(other.normal, p - other.point)) <= rounding;
    };
    return on_plane(face.point) && std::all_of(face.corners.begin(), face.corners.end(), on_plane);
}

/// How far a face reaches out of the plane of the other.
double distance_from_plane(const FlatFace& face, const FlatFace& other) {
    double most = std::abs(glm::dot(other.normal, face.point - other.point));
    for (const dvec3& p : face.corners)
        most = std::max(most, std::abs(glm::dot(other.normal, p - other.point)));
    return most;
}

/// The largest |coordinate| along each axis.
dvec3 reach_of(const dvec3& point, const std::vector<dvec3>& corners) {
    dvec3 reach = glm::abs(point);
    for (const dvec3& corner : corners) reach = glm::max(reach, glm::abs(corner));
    return reach;
}

/// The corners of a regular polygon around the unit circle.
std::vector<dvec2> polygon_around_circle() {
    constexpr double step = 15; // degrees
    std::vector<dvec2> corners;
    for (double angle = 0; angle < 360; angle += step)
        corners.push_back(dvec2(cos_degrees(angle), cos_degrees(angle - 90)) / cos_degrees(step / 2));
    return corners;
}

/// Does an edge of the polygon separate it from the other, which may touch it?
bool has_separating_edge(const FlatFace& polygon, const FlatFace& other, double rounding) {
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const dvec3& from = polygon.corners[i];
        const dvec3& to = polygon.corners[(i + 1) % polygon.corners.size()];
        const dvec3 across = glm::normalize(glm::cross(polygon.normal, to - from)); // inward
        const bool outside = std::all_of(other.corners.begin(), other.corners.end(), [&](const dvec3& p) {
            return glm::dot(across, p - from) <= rounding;
        });
        if (outside) return true;
    }
    return false;
}

bool coincide(const FlatFace& a, const FlatFace& b) {
    const dvec3 both = glm::max(a.reach, b.reach);
    const bool whole_a = a.corners.empty(), whole_b = b.corners.empty();
    // A polygon in a plane: its corners say all.
    if (whole_b && !whole_a) return in_plane(a, b, a.reach + b.reach);
    if (whole_a && !whole_b) return in_plane(b, a, a.reach + b.reach);
    if (!in_plane(a, b, both) || !in_plane(b, a, both)) return false;
    if (whole_a) return glm::length(glm::cross(a.normal, b.normal)) <= 0x1p-40;
    const double rounding = 0x1p-20 * largest(both);
    return !has_separating_edge(a, b, rounding) && !has_separating_edge(b, a, rounding);
}

} // namespace

FlatFace polygon_face(std::vector<dvec3> corners) {
    const dvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    const dvec3 point = corners[0], reach = reach_of(point, corners);
    return {point, normal, std::move(corners), reach};
}

FlatFace circle_face(const dvec3& center, const dvec3 (&across)[2]) {
    static const std::vector<dvec2> around = polygon_around_circle();
    FlatFace face{center, glm::normalize(glm::cross(across[0], across[1])), {}, dvec3(0)};
    for (const dvec2& p : around) face.corners.push_back(center + across[0] * p.x + across[1] * p.y);
    face.reach = reach_of(center, face.corners);
    return face;
}

double rounding_at(const FlatFace& face, const dvec3& reach) {
    return 0x1p-18 * glm::dot(glm::abs(face.normal), reach) + 0x1p-40 * largest(reach);
}

Bounds box_of(const FlatFace& face) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    if (face.corners.empty()) return {vec3(-infinity), vec3(infinity)};
    Bounds box;
    for (const dvec3& corner : face.corners) box.grow(vec3(corner));
    return box;
}

CommonPart common_part(const FlatFace& a, const FlatFace& b) {
    if (!coincide(a, b)) return {};
    const double apart = a.corners.empty() ? distance_from_plane(b, a) : distance_from_plane(a, b);
    return {common_box(box_of(a), box_of(b)), apart};
}

} // namespace glint::scene
