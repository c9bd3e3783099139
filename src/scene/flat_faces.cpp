// Planes compared in double, then the outlines within the plane.

#include "scene/flat_faces.h"

#include "scene/shapes/shapes.h"

namespace glint::scene {
namespace {

std::vector<FlatFace> faces_of(const Object& object) {
    std::vector<FlatFace> faces = std::visit([](const auto& s) { return flat_faces(s); }, object.shape);
    if (object.transform == dmat4(1.0)) return faces;
    const dmat3 turned = glm::transpose(glm::inverse(dmat3(object.transform)));
    for (FlatFace& face : faces) {
        face.point = transform_point(object.transform, face.point);
        face.normal = glm::normalize(turned * face.normal);
        for (dvec3& corner : face.corners) corner = transform_point(object.transform, corner);
    }
    return faces;
}

/// The largest |coordinate| along each axis.
dvec3 reach(const FlatFace& face) {
    dvec3 reach = glm::abs(face.point);
    for (const dvec3& corner : face.corners) reach = glm::max(reach, glm::abs(corner));
    return reach;
}

/// Is a face in the plane of the other? `reach` covers both.
bool in_plane(const FlatFace& face, const FlatFace& other, const dvec3& reach) {
    const double rounding = 0x1p-22 * glm::dot(glm::abs(other.normal), reach) + 0x1p-40 * largest(reach);
    const auto on_plane = [&](const dvec3& p) {
        return std::abs(glm::dot(other.normal, p - other.point)) <= rounding;
    };
    return on_plane(face.point) && std::all_of(face.corners.begin(), face.corners.end(), on_plane);
}

/// A common strip less wide than this part of a face is what solids leave that overlap a little on purpose.
constexpr double narrow = 0.01;

/// Does an edge of the polygon separate it from the other, which may touch it or share a narrow strip?
bool has_separating_edge(const FlatFace& polygon, const FlatFace& other, double rounding) {
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const dvec3& from = polygon.corners[i];
        const dvec3& to = polygon.corners[(i + 1) % polygon.corners.size()];
        const dvec3 across = glm::normalize(glm::cross(polygon.normal, to - from));
        const auto within = [&](const FlatFace& face) {
            double low = std::numeric_limits<double>::infinity(), high = -low;
            for (const dvec3& p : face.corners) {
                low = std::min(low, glm::dot(across, p - from));
                high = std::max(high, glm::dot(across, p - from));
            }
            return std::pair(low, high);
        };
        const auto [a_low, a_high] = within(polygon);
        const auto [b_low, b_high] = within(other);
        const double strip = std::max(rounding, narrow * std::min(a_high - a_low, b_high - b_low));
        if (std::min(a_high, b_high) - std::max(a_low, b_low) <= strip) return true;
    }
    return false;
}

bool coincide(const FlatFace& a, const FlatFace& b) {
    const dvec3 both = glm::max(reach(a), reach(b));
    const bool whole_a = a.corners.empty(), whole_b = b.corners.empty();
    // A polygon in a plane: its corners say all.
    if (whole_b && !whole_a) return in_plane(a, b, reach(a) + glm::abs(b.point));
    if (whole_a && !whole_b) return in_plane(b, a, reach(b) + glm::abs(a.point));
    if (!in_plane(a, b, both) || !in_plane(b, a, both)) return false;
    if (whole_a) return glm::length(glm::cross(a.normal, b.normal)) <= 0x1p-40;
    const double rounding = 0x1p-20 * largest(both);
    return !has_separating_edge(a, b, rounding) && !has_separating_edge(b, a, rounding);
}

} // namespace

bool have_coincident_faces(const Object& a, const Object& b) {
    const std::vector<FlatFace> faces = faces_of(a);
    if (faces.empty()) return false;
    for (const FlatFace& other : faces_of(b))
        for (const FlatFace& face : faces)
            if (coincide(face, other)) return true;
    return false;
}

} // namespace glint::scene
