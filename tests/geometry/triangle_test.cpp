// The triangle test against closed forms, and against itself across edges.

#include "geometry/quadric.h"
#include "geometry/triangle.h"
#include "math/offset.shared.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace glint::geometry {
namespace {

constexpr float largest = std::numeric_limits<float>::max();

/// x + y <= 1 in the first quadrant of z = 1.
constexpr TriangleVertices corner{{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};

Ray ray_from(const vec3& origin, const vec3& direction) {
    Ray ray;
    ray.origin = origin;
    ray.direction = direction;
    return ray;
}

bool hits(const Ray& ray, const TriangleVertices& triangle, TriangleHit& hit) {
    return intersect_triangle(ShearedRay(ray), triangle, ray.tmin, largest, hit);
}

bool hits(const Ray& ray, const TriangleVertices& triangle) {
    TriangleHit hit;
    return hits(ray, triangle, hit);
}

TEST(Triangle, GivesDistanceAndWeights) {
    TriangleHit hit;
    ASSERT_TRUE(hits(ray_from({0.25f, 0.5f, -1.0f}, {0, 0, 1}), corner, hit));
    EXPECT_EQ(hit.t, 2.0f);
    EXPECT_EQ(hit.u, 0.25f);
    EXPECT_EQ(hit.v, 0.5f);
    EXPECT_FALSE(hit.on_edge);
    // t counts in the direction's length.
    ASSERT_TRUE(hits(ray_from({0.25f, 0.5f, -1.0f}, {0, 0, 8}), corner, hit));
    EXPECT_EQ(hit.t, 0.25f);
}

TEST(Triangle, IsHitFromBothSides) {
    TriangleHit front;
    TriangleHit back;
    const TriangleVertices turned{corner[0], corner[2], corner[1]};
    const Ray ray = ray_from({0.25f, 0.25f, 3.0f}, {0, 0, -1});
    ASSERT_TRUE(hits(ray, corner, front));
    ASSERT_TRUE(hits(ray, turned, back));
    EXPECT_EQ(front.t, 2.0f);
    EXPECT_EQ(back.t, 2.0f);
    EXPECT_NE(front.positive, back.positive);
}

TEST(Triangle, OwnsItsEdgesAndCorners) {
    TriangleHit hit;
    for (const vec3& p :
         {vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 1, 0), vec3(0.5f, 0.5f, 0), vec3(0, 0.25f, 0)}) {
        ASSERT_TRUE(hits(ray_from(p, {0, 0, 1}), corner, hit)) << p.x << " " << p.y;
        EXPECT_TRUE(hit.on_edge);
        EXPECT_EQ(hit.t, 1.0f);
    }
    const float above = std::nextafter(0.5f, 1.0f);
    EXPECT_FALSE(hits(ray_from({above, 0.5f, 0}, {0, 0, 1}), corner));
    EXPECT_FALSE(hits(ray_from({-1e-30f, 0.5f, 0}, {0, 0, 1}), corner));
}

TEST(Triangle, IsMetAlongEveryAxis) {
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.0f, -1.0f}) {
            TriangleVertices triangle{};
            const auto k = static_cast<std::size_t>(axis);
            triangle[1][(k + 1) % 3] = 1.0f;
            triangle[2][(k + 2) % 3] = 1.0f;
            vec3 origin(0.25f);
            origin[axis] = -3.0f * sign;
            vec3 direction(0.0f);
            direction[axis] = sign;
            TriangleHit hit;
            ASSERT_TRUE(hits(ray_from(origin, direction), triangle, hit)) << axis << " " << sign;
            EXPECT_EQ(hit.t, 3.0f);
            EXPECT_EQ(hit.u, 0.25f);
            EXPECT_EQ(hit.v, 0.25f);
        }
}

TEST(Triangle, KeepsWithinItsBounds) {
    const Ray ray = ray_from({0.25f, 0.25f, 0.0f}, {0, 0, 1});
    const ShearedRay sheared(ray);
    TriangleHit hit;
    EXPECT_TRUE(intersect_triangle(sheared, corner, std::nextafter(1.0f, 0.0f), 1.0f, hit));
    EXPECT_FALSE(intersect_triangle(sheared, corner, 1.0f, largest, hit)) << "tmin is exclusive";
    EXPECT_FALSE(intersect_triangle(sheared, corner, 0.0f, std::nextafter(1.0f, 0.0f), hit));
    EXPECT_FALSE(hits(ray_from({0.25f, 0.25f, 2.0f}, {0, 0, 1}), corner)) << "behind the origin";
    EXPECT_FALSE(hits(ray_from({0.25f, 0.25f, 1.0f}, {0, 0, 1}), corner)) << "at the origin";
}

TEST(Triangle, IsMissedInItsOwnPlane) {
    EXPECT_FALSE(hits(ray_from({-1, 0.25f, 1}, {1, 0, 0}), corner));
    EXPECT_FALSE(hits(ray_from({-1, 0, 1}, {1, 0, 0}), corner)) << "along an edge";
}

TEST(Triangle, WithoutAreaIsMissed) {
    const TriangleVertices point{{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}};
    const TriangleVertices line{{{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}};
    EXPECT_FALSE(hits(ray_from({0, 0, 0}, {0, 0, 1}), point));
    EXPECT_FALSE(hits(ray_from({0.5f, 0, 0}, {0, 0, 1}), line));
}

TEST(Triangle, IsMissedByNaN) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (int i = 0; i < 6; ++i) {
        Ray ray = ray_from({0.25f, 0.25f, 0}, {0, 0, 1});
        (i < 3 ? ray.origin : ray.direction)[i % 3] = nan;
        EXPECT_FALSE(hits(ray, corner)) << i;
    }
    const TriangleVertices broken{{{nan, 0, 1}, {1, 0, 1}, {0, 1, 1}}};
    EXPECT_FALSE(hits(ray_from({0.25f, 0.25f, 0}, {0, 0, 1}), broken));
}

TEST(Triangle, IsHitAtAnySizeWithTheSameBits) {
    std::mt19937_64 engine(3);
    const auto number = [&] { return static_cast<float>(engine() >> 40) * 0x1p-23f - 1.0f; };
    int found = 0;
    for (int round = 0; round < 20'000; ++round) {
        TriangleVertices triangle{};
        for (auto& v : triangle)
            for (float& x : v) x = number();
        Ray ray;
        for (int i = 0; i < 3; ++i) ray.origin[i] = number();
        for (int i = 0; i < 3; ++i) ray.direction[i] = number();
        TriangleHit hit{};
        const bool met = hits(ray, triangle, hit);
        found += met ? 1 : 0;
        for (const int k : {-60, -20, 20, 60}) {
            const float scale = std::ldexp(1.0f, k);
            TriangleVertices scaled = triangle;
            for (auto& v : scaled)
                for (float& x : v) x *= scale;
            TriangleHit other{};
            ASSERT_EQ(hits(ray_from(ray.origin * scale, ray.direction), scaled, other), met);
            if (!met) continue;
            ASSERT_EQ(other.t, hit.t * scale);
            ASSERT_EQ(other.u, hit.u);
            ASSERT_EQ(other.v, hit.v);
        }
    }
    EXPECT_GT(found, 500);
}

vec3 vertex(const TriangleVertices& triangle, std::size_t i) {
    return {triangle[i][0], triangle[i][1], triangle[i][2]};
}

ExactPoint exact_point(const TriangleVertices& triangle, double u, double v, const dvec3& seen_along) {
    ExactPoint point;
    point_of_triangle(vertex(triangle, 0), vertex(triangle, 1), vertex(triangle, 2), u, v, seen_along,
                      point.p, point.n);
    return point;
}

TEST(Triangle, PointHasTheNormalOfTheWinding) {
    const ExactPoint point = exact_point(corner, 0.25, 0.5, {0, 0, 1});
    EXPECT_EQ(point.p, dvec3(0.25, 0.5, 1.0));
    EXPECT_EQ(point.n, dvec3(0, 0, 1));
    const TriangleVertices line{{{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}};
    EXPECT_EQ(exact_point(line, 0.25, 0.5, {0, 3, 0}).n, dvec3(0, -1, 0)) << "no area: toward the viewer";
}

/// Random numbers in [-1, 1), and thin triangles made of them.
struct Needles {
    std::mt19937_64 engine{11};

    double number() { return static_cast<double>(engine() >> 11) * 0x1p-52 - 1.0; }
    double power_of_ten(int lowest) {
        return std::pow(10.0, -static_cast<int>(engine() % static_cast<unsigned>(1 - lowest)));
    }
    dvec3 point() {
        const double x = number();
        const double y = number();
        const double z = number();
        return {x, y, z};
    }
    TriangleVertices triangle() {
        const dvec3 offset = point() * power_of_ten(-3) * 1000.0;
        const dvec3 a = point();
        const dvec3 b = point();
        const dvec3 c = engine() % 2 == 0 ? point() : b + point() * power_of_ten(-4);
        TriangleVertices result{};
        const dvec3 corners[3] = {a + offset, b + offset, c + offset};
        for (std::size_t i = 0; i < 3; ++i)
            result[i] = {static_cast<float>(corners[i].x), static_cast<float>(corners[i].y),
                         static_cast<float>(corners[i].z)};
        return result;
    }
};

TEST(Triangle, SpawnedRayNeverReintersects) {
    Needles random;
    constexpr int needles = 1'000'000;
    int failures = 0;
    int grazing = 0;
    for (int i = 0; i < needles; ++i) {
        const TriangleVertices triangle = random.triangle();
        double u = 0.5 + 0.5 * random.number();
        double v = 0.5 + 0.5 * random.number();
        if (u + v > 1.0) {
            u = 1.0 - u;
            v = 1.0 - v;
        }
        const ExactPoint exact = exact_point(triangle, u, v, {0, 0, 1});
        const vec3 p(exact.p);
        const vec3 n(exact.n);
        const vec3 error =
            error_of_triangle(vertex(triangle, 0), vertex(triangle, 1), vertex(triangle, 2), p);

        // Toward one corner, at angles from 0 to 90 degrees to the plane.
        const auto& goal = triangle[random.engine() % 3];
        const dvec3 along =
            glm::normalize(dvec3(goal[0], goal[1], goal[2]) - exact.p + random.point() * 1e-3);
        const double height = random.power_of_ten(-9);
        grazing += height < 1e-4 ? 1 : 0;
        const dvec3 w =
            along - exact.n * glm::dot(exact.n, along) + exact.n * (random.number() < 0 ? -height : height);
        Ray ray;
        ray.direction = vec3(w);
        ray.origin = offset_ray_origin(p, error, n, ray.direction);
        TriangleHit hit{};
        if (!hits(ray, triangle, hit)) continue;
        if (failures++ == 0)
            ADD_FAILURE() << "needle " << i << " is hit again at t = " << hit.t << ", height " << height;
    }
    EXPECT_EQ(failures, 0) << "of " << needles;
    EXPECT_GT(grazing, needles / 4);
}

TEST(Triangle, NeighboursAgreeOnTheirEdge) {
    // Rays toward points of the common edge of two triangles always hit one of them.
    Needles random;
    int on_edge = 0;
    for (int i = 0; i < 300'000; ++i) {
        // Every other pair on a coarse grid, where rays pass exactly through the edge.
        const bool grid = i % 2 == 0;
        const dvec3 a = grid ? glm::round(random.point() * 4.0) : random.point();
        const dvec3 b = grid ? glm::round(random.point() * 4.0) : random.point();
        const dvec3 middle = (a + b) * 0.5;
        const dvec3 across = random.point();
        const auto rounded = [](const dvec3& p) {
            return std::array{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
        };
        const TriangleVertices left{rounded(a), rounded(b), rounded(middle + across)};
        const TriangleVertices right{rounded(b), rounded(a), rounded(middle - across)};
        const dvec3 side = glm::cross(b - a, across);
        const vec3 origin(grid ? glm::round(middle + side) : middle + side * 3.0 + random.point() * 0.01);
        const vec3 goal(grid ? middle : a + (b - a) * (0.5 + 0.45 * random.number()));
        // Skip triangles seen edge-on.
        if (!(glm::dot(dvec3(origin) - middle, side) > 0.1 * glm::dot(side, side))) continue;
        TriangleHit first{};
        TriangleHit second{};
        const bool hits_left = hits(ray_from(origin, goal - origin), left, first);
        const bool hits_right = hits(ray_from(origin, goal - origin), right, second);
        ASSERT_TRUE(hits_left || hits_right) << "leak at round " << i;
        if (hits_left && hits_right) {
            ++on_edge;
            ASSERT_TRUE(first.on_edge && second.on_edge);
            ASSERT_EQ(first.positive, second.positive);
            ASSERT_NEAR(first.t, second.t, first.t * 0x1p-22f);
        }
    }
    EXPECT_GT(on_edge, 1000);
}

} // namespace
} // namespace glint::geometry
