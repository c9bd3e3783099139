#include "geometry/triangle.h"

#include <algorithm>
#include <cmath>

namespace glint {

namespace {

dvec3 exact(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

dvec3 unit(const dvec3& v) { return v / std::sqrt(glm::dot(v, v)); }

} // namespace

ExactPoint triangle_point(const TriangleVertices& vertices, double u, double v, const dvec3& seen_along) {
    const dvec3 origin = exact(vertices[0]);
    const dvec3 e1 = exact(vertices[1]) - origin;
    const dvec3 e2 = exact(vertices[2]) - origin;
    const dvec3 normal = glm::cross(e1, e2);
    const bool flat = glm::dot(normal, normal) == 0.0;
    return {origin + e1 * u + e2 * v, unit(flat ? -seen_along : normal)};
}

vec3 triangle_point_error(const TriangleVertices& vertices, const vec3& p) {
    float reach = 0;
    for (const auto& v : vertices)
        reach = std::max({reach, std::abs(v[0] - p.x), std::abs(v[1] - p.y), std::abs(v[2] - p.z)});
    return glm::abs(p) * 0x1p-24f + vec3(reach * 0x1p-21f);
}

} // namespace glint
