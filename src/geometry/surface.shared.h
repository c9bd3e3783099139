#ifndef GLINT_GEOMETRY_SURFACE_SHARED_H
#define GLINT_GEOMETRY_SURFACE_SHARED_H
#include "geometry/quadric.shared.h"
#include "geometry/triangle.shared.h"
#include "math/shared.h"

// Surface points of hits: computed in double, rounded once, with a bound on the error that remains. Also
// interpolation over triangles.

GLINT_SHARED_BEGIN

#ifndef GLINT_GLSL
using glm::mat3;
#endif

/// The surface at a hit. `p` is on the surface up to `p_error`.
struct SurfacePoint {
    vec3 p;
    vec3 p_error; ///< absolute bound, per axis
    vec3 n;       ///< unit geometric normal of the object: outward for closed shapes, by winding for
                  ///< triangles, as given for planes
};

GLINT_FN double max_abs(dvec3 v) {
    dvec3 a = abs(v);
    return max(max(a.x, a.y), a.z);
}

/// Rounds to float, with half a float's spacing and `slack` as the error.
GLINT_FN SurfacePoint rounded_point(dvec3 p, dvec3 n, double slack) {
    SurfacePoint point;
    point.p = vec3(p);
    point.p_error = abs(point.p) * (1.0f / 16777216.0f) + vec3(float(slack));
    point.n = vec3(n);
    return point;
}

// ── Away from edges
//
// Where a point lies within its error of an edge, rounding may put it on the wrong side of the face across
// the edge: a ray that starts there leaves a closed solid without crossing it. So start points keep
// `edge_margin` times their error from the edges of their face. Where two faces meet at the inner angle θ, a
// point at the distance d from the edge, then raised by e, is d sin θ − e cos θ within the other face, and
// offset_ray_origin() raises it by at most 6 errors: enough down to 15°. Faces with sharper edges have a
// larger margin: `off_edges` below, in errors.

/// Bound of the weight that is required of each vertex, for faces hardly larger than the errors of their
/// points.
const double max_edge_weight = 1.0 / 16.0;

/// Weights of vertices b and c of a triangle.
struct TriangleWeights {
    double u;
    double v;
};

/// More than the error of weights that were rounded to float: 2^-22.
const double float_weight_error = 1.0 / 4194304.0;

/// How far to go to the middle, as a share, for a weight to become at least `floor_of`.
GLINT_FN double way_off_edge(double weight, double floor_of) {
    double least = min(floor_of, max_edge_weight);
    return weight < least ? (least - weight) / (double(1.0f) / double(3.0f) - weight) : double(0.0f);
}

/// The weights of the nearest point on the way to the triangle's middle whose distance from each edge is at
/// least `margin`, though the weights given have an error.
GLINT_FN TriangleWeights weights_off_edges(vec3 a, vec3 b, vec3 c, double u, double v, double margin,
                                           double weight_error) {
    TriangleWeights moved;
    moved.u = u;
    moved.v = v;
    // None can be required to be larger.
    if (min(min(u, v), 1.0 - u - v) >= max_edge_weight) return moved;
    dvec3 ab = dvec3(b) - dvec3(a);
    dvec3 ac = dvec3(c) - dvec3(a);
    dvec3 bc = dvec3(c) - dvec3(b);
    dvec3 normal = cross(ab, ac);
    double height = margin / sqrt(dot(normal, normal)); // over an edge of unit length
    double way = max(max(way_off_edge(1.0 - u - v, height * sqrt(dot(bc, bc)) + weight_error),
                         way_off_edge(u, height * sqrt(dot(ac, ac)) + weight_error)),
                     way_off_edge(v, height * sqrt(dot(ab, ab)) + weight_error));
    double third = double(1.0f) / double(3.0f);
    moved.u = u + (third - u) * way;
    moved.v = v + (third - v) * way;
    return moved;
}

/// A point of a triangle in world space, with weights u and v of vertices b and c, off the edges.
/// `seen_along` as in point_of_triangle(); `reversed`: the normal is turned against the winding.
GLINT_FN SurfacePoint triangle_surface(vec3 a, vec3 b, vec3 c, double u, double v, double off_edges,
                                       dvec3 seen_along, bool reversed) {
    dvec3 p;
    dvec3 n;
    point_of_triangle(a, b, c, u, v, seen_along, p, n);
    SurfacePoint point;
    point.p = vec3(p);
    point.p_error = error_of_triangle(a, b, c, point.p);
    TriangleWeights moved =
        weights_off_edges(a, b, c, u, v, off_edges * max_abs(dvec3(point.p_error)), float_weight_error);
    if (moved.u != u || moved.v != v) {
        point_of_triangle(a, b, c, moved.u, moved.v, seen_along, p, n);
        point.p = vec3(p);
        point.p_error = error_of_triangle(a, b, c, point.p);
    }
    point.n = vec3(reversed ? -n : n);
    return point;
}

/// The point of a wide triangle (geometry/triangle.h) nearest to `near`, off the edges; its error is that of
/// rounding it, whatever the size of the triangle.
GLINT_FN SurfacePoint wide_triangle_surface(vec3 a, vec3 b, vec3 c, dvec3 near, double off_edges,
                                            dvec3 seen_along, bool reversed) {
    dvec3 ab = dvec3(b) - dvec3(a);
    dvec3 ac = dvec3(c) - dvec3(a);
    dvec3 normal = cross(ab, ac);
    if (dot(normal, normal) == 0.0) normal = -seen_along;
    double squared = dot(normal, normal);
    dvec3 from_a = near - dvec3(a);
    double u = limited(dot(cross(from_a, ac), normal) / squared, 0.0, 1.0);
    double v = limited(dot(cross(ab, from_a), normal) / squared, 0.0, 1.0 - u);
    double reach = max(max_abs(from_a), max(max_abs(near - dvec3(b)), max_abs(near - dvec3(c))));
    double margin = off_edges * (max_abs(near) * (1.0 / 16777216.0) + surface_error * reach);
    TriangleWeights moved = weights_off_edges(a, b, c, u, v, margin, surface_error);
    dvec3 n = normal / sqrt(squared);
    return rounded_point(dvec3(a) + ab * moved.u + ac * moved.v, reversed ? -n : n, surface_error * reach);
}

/// Where the point p of an instance's triangle lies in the world; its normal is not set. See
/// instance_surface().
GLINT_FN SurfacePoint instance_point(vec3 a, vec3 b, vec3 c, dvec3 p, GLINT_IN(dmat3) linear,
                                     GLINT_IN(dvec3) translation, double slack) {
    dvec3 mesh_error = dvec3(error_of_triangle(a, b, c, vec3(p))) * 1.25;
    dvec3 world_error =
        abs(linear[0]) * mesh_error.x + abs(linear[1]) * mesh_error.y + abs(linear[2]) * mesh_error.z;
    SurfacePoint point = rounded_point(linear * p + translation, dvec3(0.0), slack);
    point.p_error = point.p_error + vec3(world_error);
    return point;
}

/// A point of an instance's triangle, given in the mesh's space; p_world = linear · p_mesh + translation,
/// with `slack` as the rounding error of that in double.
///
/// A ray that starts at the point is transformed back to the mesh's space, where its origin and direction are
/// rounded and its test displaces triangles. error_of_triangle() covers the origin and the test; rounding the
/// direction displaces the triangle by up to 1 u S more (u and S as in geometry/triangle.h). A quarter more
/// covers that and terms of second order. Bounds in the mesh's space become bounds in the world by |linear|.
GLINT_FN SurfacePoint instance_surface(vec3 a, vec3 b, vec3 c, double u, double v, double off_edges,
                                       dvec3 seen_along, GLINT_IN(dmat3) linear, GLINT_IN(dmat3) inverse,
                                       GLINT_IN(dvec3) translation, double slack, bool reversed) {
    dvec3 p;
    dvec3 n;
    point_of_triangle(a, b, c, u, v, seen_along, p, n);
    dvec3 normal = transpose(inverse) * n;
    dvec3 unit = normal / sqrt(dot(normal, normal));
    // The margin is kept in the mesh's space, where it covers what rounding in the world comes to there.
    SurfacePoint point = instance_point(a, b, c, p, linear, translation, slack);
    dvec3 rounding = dvec3(point.p_error);
    dvec3 back = abs(inverse[0]) * rounding.x + abs(inverse[1]) * rounding.y + abs(inverse[2]) * rounding.z;
    TriangleWeights moved = weights_off_edges(a, b, c, u, v, off_edges * max_abs(back), float_weight_error);
    if (moved.u != u || moved.v != v) {
        point_of_triangle(a, b, c, moved.u, moved.v, seen_along, p, n);
        point = instance_point(a, b, c, p, linear, translation, slack);
    }
    point.n = vec3(reversed ? -unit : unit);
    return point;
}

/// Where the line o + t d enters or leaves a quadric that it meets, at least `margin` from rims, and the
/// outward normal there.
GLINT_FN void point_on_line(GLINT_IN(QuadricShape) shape, bool leaving, dvec3 o, dvec3 d, double margin,
                            GLINT_OUT(dvec3) on, GLINT_OUT(dvec3) n) {
    SolidSpan span;
    line_in_quadric(shape, o, d, span);
    double t = leaving ? span.leave : span.enter;
    point_of_quadric(shape, leaving ? span.leave_part : span.enter_part, o + d * t, margin, on, n);
}

/// Of the largest number in a local space, in the world.
GLINT_FN double size_in_world(GLINT_IN(dmat3) linear, GLINT_IN(dvec3) translation, double size) {
    double stretch = max_abs(linear[0]) + max_abs(linear[1]) + max_abs(linear[2]);
    return max_abs(translation) + stretch * size;
}

/// margin_at_rim() in a local space, for rays that start in the world.
GLINT_FN double local_margin_at_rim(GLINT_IN(dmat3) linear, GLINT_IN(dmat3) inverse,
                                    GLINT_IN(dvec3) translation, double size) {
    double shrink = max_abs(inverse[0]) + max_abs(inverse[1]) + max_abs(inverse[2]);
    return margin_at_rim(shrink * size_in_world(linear, translation, size));
}

/// From a quadric's local space to the world: p_world = linear · p + translation, normals by the inverse
/// transpose. `size` is size_of_quadric() there.
GLINT_FN SurfacePoint point_in_world(dvec3 p, dvec3 n, GLINT_IN(dmat3) linear, GLINT_IN(dmat3) inverse,
                                     GLINT_IN(dvec3) translation, double size) {
    dvec3 normal = transpose(inverse) * n;
    return rounded_point(linear * p + translation, normal / sqrt(dot(normal, normal)),
                         surface_error * size_in_world(linear, translation, size));
}

/// Where the line o + t d enters or leaves a quadric of the world.
GLINT_FN SurfacePoint quadric_surface(GLINT_IN(QuadricShape) shape, bool leaving, dvec3 o, dvec3 d) {
    double size = size_of_quadric(shape);
    dvec3 p;
    dvec3 n;
    point_on_line(shape, leaving, o, d, margin_at_rim(size), p, n);
    return rounded_point(p, n, surface_error * size);
}

/// The same in a local space, in which the quadric and the line are given.
GLINT_FN SurfacePoint local_quadric_surface(GLINT_IN(QuadricShape) shape, bool leaving, dvec3 o, dvec3 d,
                                            GLINT_IN(dmat3) linear, GLINT_IN(dmat3) inverse,
                                            GLINT_IN(dvec3) translation) {
    double size = size_of_quadric(shape);
    dvec3 p;
    dvec3 n;
    point_on_line(shape, leaving, o, d, local_margin_at_rim(linear, inverse, translation, size), p, n);
    return point_in_world(p, n, linear, inverse, translation, size);
}

/// Where the line o + t d meets a plane.
GLINT_FN SurfacePoint plane_surface(dvec3 o, dvec3 d, dvec3 normal, double offset) {
    double t;
    line_meets_plane(o, d, normal, offset, t);
    dvec3 p = o + d * t;
    dvec3 on;
    dvec3 n;
    point_of_plane(normal, offset, p, on, n);
    return rounded_point(on, n, surface_error * (max_abs(o) + max_abs(p)));
}

/// A vertex normal in the world: unit length, or 0 if n is 0. The matrix is the inverse transpose of the
/// points'.
GLINT_FN vec3 transformed_normal(GLINT_IN(dmat3) normal_matrix, vec3 n) {
    dvec3 t = normal_matrix * dvec3(n);
    double squared = dot(t, t);
    return squared > 0.0 ? vec3(t / sqrt(squared)) : vec3(0.0f);
}

/// The same for those of a triangle's corners, the columns.
GLINT_FN mat3 transformed_normals(GLINT_IN(dmat3) normal_matrix, GLINT_IN(mat3) n) {
    return mat3(transformed_normal(normal_matrix, n[0]), transformed_normal(normal_matrix, n[1]),
                transformed_normal(normal_matrix, n[2]));
}

/// Between the corners of a triangle, the columns, at the weights u and v of the second and the third.
GLINT_FN vec3 interpolated(GLINT_IN(mat3) corners, float u, float v) {
    return corners[0] * (1.0f - u - v) + corners[1] * u + corners[2] * v;
}

/// The shading normal from the interpolated one: unit length, on the side of n_g; n_g if that is 0.
GLINT_FN vec3 shading_normal(vec3 normal, vec3 n_g) {
    float squared = dot(normal, normal);
    if (!(squared > 0.0f)) return n_g;
    vec3 n = normal / sqrt(squared);
    return dot(n, n_g) < 0.0f ? -n : n;
}

GLINT_SHARED_END
#endif
