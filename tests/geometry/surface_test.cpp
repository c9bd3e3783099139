// Error bounds of surface points, and interpolation over triangles.

#include "geometry/quadric.h"
#include "geometry/surface.shared.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glint::geometry {
namespace {

const vec3 a(0.0f, 0.0f, 1.0f);
const vec3 b(1.0f, 0.0f, 1.0f);
const vec3 c(0.0f, 1.0f, 1.0f);

TEST(Surface, RoundedPointsCoverTheExactOnes) {
    const dvec3 exact(1.0 / 3.0, -1e9 / 7.0, 1e-9 / 3.0);
    const SurfacePoint point = rounded_point(exact, dvec3(0, 0, 1), 1e-12);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(std::abs(double(point.p[axis]) - exact[axis]), double(point.p_error[axis])) << axis;
        EXPECT_GE(point.p_error[axis], 1e-12f) << axis;
    }
}

TEST(Surface, ReversedTrianglesTurnTheirNormalsOnly) {
    const SurfacePoint front = triangle_surface(a, b, c, 0.25, 0.5, edge_margin, dvec3(0, 0, 1), false);
    const SurfacePoint back = triangle_surface(a, b, c, 0.25, 0.5, edge_margin, dvec3(0, 0, 1), true);
    EXPECT_EQ(front.p, vec3(0.25f, 0.5f, 1.0f));
    EXPECT_EQ(front.n, vec3(0, 0, 1));
    EXPECT_EQ(back.p, front.p);
    EXPECT_EQ(back.n, vec3(0, 0, -1));
    EXPECT_EQ(back.p_error, front.p_error);
}

TEST(Surface, InstancesMovePointsAndTurnNormalsByTheInverseTranspose) {
    dmat3 linear(1.0);
    linear[0][0] = 2; // x is stretched
    const dmat3 inverse = glm::inverse(linear);
    const vec3 slanted(0.0f, 1.0f, 0.0f);
    const SurfacePoint point = instance_surface(a, b, slanted, 0.5, 0.25, edge_margin, dvec3(0, 0, 1), linear,
                                                inverse, dvec3(10, 20, 30), 1e-6, false);
    const SurfacePoint local = triangle_surface(a, b, slanted, 0.5, 0.25, edge_margin, dvec3(0, 0, 1), false);
    EXPECT_EQ(point.p, vec3(11.0f, 20.25f, 30.75f));
    EXPECT_NEAR(dot(point.n, vec3(2, 0, 0)), 0, 1e-7) << "normal to the stretched edge";
    EXPECT_NEAR(dot(point.n, vec3(0, 1, -1)), 0, 1e-7);
    for (int axis = 0; axis < 3; ++axis) EXPECT_GT(point.p_error[axis], local.p_error[axis]) << axis;
}

TEST(Surface, PointsKeepOffTheEdgesOfTheirTriangle) {
    for (const dvec2 weights : {dvec2(0.5, 0.5), dvec2(0, 0.25), dvec2(1, 0), dvec2(1e-9, 0.5)}) {
        const SurfacePoint point =
            triangle_surface(a, b, c, weights.x, weights.y, edge_margin, dvec3(0, 0, 1), false);
        const dvec3 p(point.p);
        const double error = point.p_error.x;
        for (const double distance : {p.x, p.y, (1 - p.x - p.y) / std::sqrt(2.0)}) {
            EXPECT_GT(distance, 30 * error);
        }
        EXPECT_LT(glm::length(p - dvec3(weights, 1)), 1e-4);
        EXPECT_EQ(point.p.z, 1.0f);
    }
}

TEST(Surface, TrianglesSmallerThanTheirErrorsKeepTheirPointsApart) {
    const vec3 far(1e6f, 0, 0);
    const SurfacePoint at_b =
        triangle_surface(far + a, far + b, far + c, 1, 0, edge_margin, dvec3(0, 0, 1), false);
    const SurfacePoint at_c =
        triangle_surface(far + a, far + b, far + c, 0, 1, edge_margin, dvec3(0, 0, 1), false);
    EXPECT_GT(glm::length(at_b.p - at_c.p), 1.0f);
}

TEST(Surface, ShadingNormalsAreUnitAndOnTheGeometricSide) {
    const vec3 n_g(0, 0, 1);
    EXPECT_EQ(shading_normal(vec3(0, 0, 4), n_g), n_g);
    EXPECT_EQ(shading_normal(vec3(0, 3, -4), n_g), vec3(0, -0.6f, 0.8f));
    EXPECT_EQ(shading_normal(vec3(0.0f), n_g), n_g);
    EXPECT_EQ(interpolated(mat3(a, b, c), 0.25f, 0.5f), vec3(0.25f, 0.5f, 1.0f));
}

TEST(Surface, TransformedNormalsAreUnitOrZero) {
    dmat3 normal_matrix(1.0);
    normal_matrix[1][1] = 3;
    EXPECT_EQ(transformed_normal(normal_matrix, vec3(0, 2, 0)), vec3(0, 1, 0));
    EXPECT_EQ(transformed_normal(normal_matrix, vec3(0.0f)), vec3(0.0f));
}

} // namespace
} // namespace glint::geometry
