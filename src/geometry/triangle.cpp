#include "geometry/triangle.h"

namespace glint {

namespace {

vec3 vector(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

} // namespace

ExactPoint triangle_point(const TriangleVertices& vertices, double u, double v, const dvec3& seen_along) {
    ExactPoint point;
    point_of_triangle(vector(vertices[0]), vector(vertices[1]), vector(vertices[2]), u, v, seen_along,
                      point.p, point.n);
    return point;
}

vec3 triangle_point_error(const TriangleVertices& vertices, const vec3& p) {
    return error_of_triangle(vector(vertices[0]), vector(vertices[1]), vector(vertices[2]), p);
}

} // namespace glint
