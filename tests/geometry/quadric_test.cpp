// Quadrics and planes against closed forms.

#include "geometry/quadric.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace glint::geometry {
namespace {

const QuadricShape unit_sphere = make_sphere(dvec3(0), 1.0);
/// Radius 2, from z = 1 to z = 4.
const QuadricShape drum = make_cylinder({0, 0, 1}, {0, 0, 1}, 3.0, 2.0);

enum Part { side, base_cap, top_cap };

TEST(Sphere, IsEnteredAndLeft) {
    SolidSpan t{};
    ASSERT_TRUE(intersect({{0, 0, -5}, {0, 0, 1}}, unit_sphere, t));
    EXPECT_EQ(t.enter, 4.0);
    EXPECT_EQ(t.leave, 6.0);
    ASSERT_TRUE(intersect({{0, 0, -5}, {0, 0, 2}}, unit_sphere, t)) << "t counts in the direction's length";
    EXPECT_EQ(t.enter, 2.0);
    EXPECT_EQ(t.leave, 3.0);
}

TEST(Sphere, SurroundsTheOrigin) {
    SolidSpan t{};
    ASSERT_TRUE(intersect({{0.5, 0, 0}, {1, 0, 0}}, unit_sphere, t));
    EXPECT_EQ(t.enter, -1.5);
    EXPECT_EQ(t.leave, 0.5);
    ASSERT_TRUE(intersect({{0, 0, 0}, {0, -1, 0}}, unit_sphere, t)) << "from the centre";
    EXPECT_EQ(t.enter, -1.0);
    EXPECT_EQ(t.leave, 1.0);
}

TEST(Sphere, IsTouchedByATangent) {
    SolidSpan t{};
    ASSERT_TRUE(intersect({{1, 0, -5}, {0, 0, 1}}, unit_sphere, t));
    EXPECT_EQ(t.enter, 5.0);
    EXPECT_EQ(t.leave, 5.0);
    ASSERT_TRUE(intersect({{1, 0, 0}, {0, 0, 1}}, unit_sphere, t)) << "from the point of contact";
    EXPECT_EQ(t.enter, 0.0);
    EXPECT_EQ(t.leave, 0.0);
    EXPECT_FALSE(intersect({{std::nextafter(1.0, 2.0), 0, -5}, {0, 0, 1}}, unit_sphere, t));
}

TEST(Sphere, IsExactFromFarAway) {
    // The radius vanishes in the square of the distance; the roots must stay accurate.
    SolidSpan t{};
    ASSERT_TRUE(intersect({{0.6, 0, -1e7}, {0, 0, 1}}, unit_sphere, t));
    EXPECT_NEAR(t.enter, 1e7 - 0.8, 4e-9);
    EXPECT_NEAR(t.leave, 1e7 + 0.8, 4e-9);
}

TEST(Sphere, MissesByNaN) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    SolidSpan t{};
    EXPECT_FALSE(intersect({{nan, 0, -5}, {0, 0, 1}}, unit_sphere, t));
    EXPECT_FALSE(intersect({{0, 0, -5}, {0, nan, 1}}, unit_sphere, t));
}

TEST(Sphere, SurfaceIsNearest) {
    const ExactPoint point = surface(make_sphere({1, 2, 3}, 2.0), side, {1, 2, 9});
    EXPECT_EQ(point.p, dvec3(1, 2, 5));
    EXPECT_EQ(point.n, dvec3(0, 0, 1));
}

TEST(Cylinder, IsEnteredThroughItsSide) {
    SolidSpan t{};
    ASSERT_TRUE(intersect({{-5, 0, 2}, {1, 0, 0}}, drum, t));
    EXPECT_EQ(t.enter, 3.0);
    EXPECT_EQ(t.leave, 7.0);
    EXPECT_EQ(t.enter_part, side);
    EXPECT_EQ(t.leave_part, side);
    EXPECT_FALSE(intersect({{-5, 0, 4.5}, {1, 0, 0}}, drum, t)) << "over the top";
    EXPECT_FALSE(intersect({{-5, 2.5, 2}, {1, 0, 0}}, drum, t)) << "past the side";
}

TEST(Cylinder, IsEnteredThroughItsCaps) {
    SolidSpan t{};
    ASSERT_TRUE(intersect({{1, 1, -1}, {0, 0, 1}}, drum, t));
    EXPECT_EQ(t.enter, 2.0);
    EXPECT_EQ(t.leave, 5.0);
    EXPECT_EQ(t.enter_part, base_cap);
    EXPECT_EQ(t.leave_part, top_cap);
    ASSERT_TRUE(intersect({{1, 1, 6}, {0, 0, -1}}, drum, t));
    EXPECT_EQ(t.enter, 2.0);
    EXPECT_EQ(t.enter_part, top_cap);
    EXPECT_EQ(t.leave_part, base_cap);
    EXPECT_FALSE(intersect({{1.5, 1.5, -1}, {0, 0, 1}}, drum, t)) << "beside the cap";
}

TEST(Cylinder, IsCrossedFromCapToSide) {
    SolidSpan t{};
    ASSERT_TRUE(intersect({{0, 0, 0}, {1, 0, 1}}, drum, t));
    EXPECT_EQ(t.enter, 1.0);
    EXPECT_EQ(t.leave, 2.0);
    EXPECT_EQ(t.enter_part, base_cap);
    EXPECT_EQ(t.leave_part, side);
}

TEST(Cylinder, SurroundsTheOrigin) {
    SolidSpan t{};
    ASSERT_TRUE(intersect({{0, 0, 2}, {0, 0, 1}}, drum, t)) << "on the axis";
    EXPECT_EQ(t.enter, -1.0);
    EXPECT_EQ(t.leave, 2.0);
    ASSERT_TRUE(intersect({{1, 0, 2}, {0, 1, 0}}, drum, t));
    EXPECT_NEAR(t.enter, -std::sqrt(3.0), 1e-15);
    EXPECT_NEAR(t.leave, std::sqrt(3.0), 1e-15);
}

TEST(Cylinder, HasOneWayInAndOneOutAtItsRim) {
    SolidSpan t{};
    // Exactly through both rims.
    ASSERT_TRUE(intersect({{-3.0, 0, 0.25}, {4, 0, 3}}, make_cylinder({0, 0, 1}, {0, 0, 1}, 3.0, 2.0), t));
    EXPECT_EQ(t.enter, 0.25);
    EXPECT_EQ(t.leave, 1.25);
    // Touching the rim from outside.
    ASSERT_TRUE(intersect({{1, 0, 5}, {1, 0, -1}}, drum, t));
    EXPECT_EQ(t.enter, 1.0);
    EXPECT_EQ(t.leave, 1.0);
    // Down the side and along the cap, both on the surface.
    EXPECT_TRUE(intersect({{2, 0, 9}, {0, 0, -1}}, drum, t));
    EXPECT_TRUE(intersect({{-9, 0, 4}, {1, 0, 0}}, drum, t));
}

TEST(Cylinder, TurnsWithItsAxis) {
    // The drum along any axis, and mirrored, with equal bits.
    SolidSpan reference{};
    const Line line{{-3.1, 0.4, 0.3}, {1.1, 0.2, 0.7}};
    ASSERT_TRUE(intersect(line, drum, reference));
    const auto swapped = [](const dvec3& v) { return dvec3(v.y, v.x, v.z); };
    const auto mirrored = [](const dvec3& v) { return dvec3(-v.x, v.y, v.z); };
    const dvec3 axis = glm::normalize(dvec3(0.3, -0.5, 0.8));
    const QuadricShape slanted = make_cylinder({0.1, 0.2, 0.3}, axis, 3.0, 2.0);
    SolidSpan slanted_t{};
    ASSERT_TRUE(intersect(line, slanted, slanted_t));
    for (const auto& turn :
         {std::function<dvec3(const dvec3&)>(swapped), std::function<dvec3(const dvec3&)>(mirrored)}) {
        SolidSpan t{};
        ASSERT_TRUE(intersect({turn(line.origin), turn(line.direction)},
                              make_cylinder(turn(slanted.base), turn(axis), 3.0, 2.0), t));
        EXPECT_EQ(t.enter, slanted_t.enter);
        EXPECT_EQ(t.leave, slanted_t.leave);
    }
}

TEST(Cylinder, AgreesWithPointsInside) {
    // A point of the line is inside the solid exactly between the two roots.
    std::mt19937_64 engine(5);
    const auto number = [&] { return static_cast<double>(engine() >> 11) * 0x1p-52 - 1.0; };
    int hits = 0;
    for (int round = 0; round < 100'000; ++round) {
        const dvec3 axis = glm::normalize(dvec3{number(), number(), number() + 1e-3});
        const dvec3 base{number(), number(), number()};
        const double height = 1.0 + number() * 0.9;
        const double radius = 1.0 + number() * 0.9;
        const QuadricShape c = make_cylinder(base, axis, height, radius);
        const Line line{{number() * 4, number() * 4, number() * 4}, {number(), number(), number()}};
        const auto inside = [&](double t) {
            const dvec3 v = line.origin + line.direction * t - c.base;
            const double h = glm::dot(axis, v);
            return h >= 0 && h <= c.height && glm::length(v - axis * h) <= c.radius;
        };
        SolidSpan t{};
        const bool hit = intersect(line, c, t);
        hits += hit ? 1 : 0;
        if (hit) {
            const double length = t.leave - t.enter;
            if (length < 1e-9) continue;
            ASSERT_TRUE(inside(t.enter + length * 1e-4) && inside(t.leave - length * 1e-4)) << round;
            ASSERT_FALSE(inside(t.enter - length * 1e-4) || inside(t.leave + length * 1e-4)) << round;
        } else {
            for (int i = -50; i <= 50; ++i) ASSERT_FALSE(inside(0.1 * i)) << round;
        }
    }
    EXPECT_GT(hits, 5000);
}

TEST(Cylinder, SurfaceIsNearestOnThePartHit) {
    EXPECT_EQ(surface(drum, side, {4, 0, 2}).p, dvec3(2, 0, 2));
    EXPECT_EQ(surface(drum, side, {4, 0, 2}).n, dvec3(1, 0, 0));
    EXPECT_EQ(surface(drum, base_cap, {1, 0, 1.1}).p, dvec3(1, 0, 1));
    EXPECT_EQ(surface(drum, base_cap, {1, 0, 1.1}).n, dvec3(0, 0, -1));
    EXPECT_EQ(surface(drum, top_cap, {1, 0, 4.1}).p, dvec3(1, 0, 4));
    EXPECT_EQ(surface(drum, top_cap, {1, 0, 4.1}).n, dvec3(0, 0, 1));
}

/// Radius 0.5 about z, perpendicular to it at z = 2.
const QuadricShape coin = make_disk({0, 0, 2}, {0, 0, 1}, 0.5);

TEST(Disk, IsMetOnceFromEitherSide) {
    SolidSpan t{};
    ASSERT_TRUE(intersect({{0.25, 0.25, 0}, {0, 0, 4}}, coin, t));
    EXPECT_EQ(t.enter, 0.5);
    EXPECT_EQ(t.leave, -std::numeric_limits<double>::infinity()) << "there is no way out";
    ASSERT_TRUE(intersect({{0.25, 0.25, 3}, {0, 0, -1}}, coin, t));
    EXPECT_EQ(t.enter, 1.0);
    EXPECT_EQ(t.leave, -std::numeric_limits<double>::infinity());
}

TEST(Disk, EndsAtItsRim) {
    SolidSpan t{};
    EXPECT_TRUE(intersect({{0.5, 0, 0}, {0, 0, 1}}, coin, t));
    EXPECT_FALSE(intersect({{std::nextafter(0.5, 1.0), 0, 0}, {0, 0, 1}}, coin, t));
    EXPECT_FALSE(intersect({{-1, 0, 3}, {1, 0, 0}}, coin, t)) << "parallel, above it";
    EXPECT_FALSE(intersect({{-1, 0, 2}, {1, 0, 0}}, coin, t)) << "in its plane";
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(intersect({{nan, 0, 0}, {0, 0, 1}}, coin, t));
}

TEST(Disk, SurfaceIsNearest) {
    EXPECT_EQ(surface(coin, side, {0.25, 0, 2.5}).p, dvec3(0.25, 0, 2));
    EXPECT_EQ(surface(coin, side, {0.25, 0, 1.5}).n, dvec3(0, 0, 1)) << "the normal as given, from below too";
}

/// Radius 1 at z = 0, its apex at z = 2.
const QuadricShape spike = make_cone({0, 0, 0}, {0, 0, 1}, 2.0, 1.0);

TEST(Cone, IsCrossedThroughItsSideAndItsCap) {
    SolidSpan t{};
    ASSERT_TRUE(intersect({{-5, 0, 1}, {1, 0, 0}}, spike, t));
    EXPECT_EQ(t.enter, 4.5);
    EXPECT_EQ(t.leave, 5.5);
    EXPECT_EQ(t.enter_part, side);
    EXPECT_EQ(t.leave_part, side);
    ASSERT_TRUE(intersect({{0.25, 0, 5}, {0, 0, -1}}, spike, t));
    EXPECT_EQ(t.enter, 3.5);
    EXPECT_EQ(t.leave, 5.0);
    EXPECT_EQ(t.enter_part, side);
    EXPECT_EQ(t.leave_part, base_cap);
    ASSERT_TRUE(intersect({{0.25, 0, -5}, {0, 0, 1}}, spike, t));
    EXPECT_EQ(t.enter, 5.0);
    EXPECT_EQ(t.leave, 6.5);
    EXPECT_EQ(t.enter_part, base_cap);
    EXPECT_EQ(t.leave_part, side);
    EXPECT_FALSE(intersect({{-5, 0, -0.5}, {1, 0, 0}}, spike, t)) << "below the cap";
    EXPECT_FALSE(intersect({{-5, 0, 2.5}, {1, 0, 0}}, spike, t)) << "through its mirror image above the apex";
    EXPECT_FALSE(intersect({{-5, 0.75, 1}, {1, 0, 0}}, spike, t)) << "past the side";
}

TEST(Cone, IsCrossedParallelToItsSide) {
    // Down a line half a unit inside the side, along it: the quadratic has one root.
    SolidSpan t{};
    ASSERT_TRUE(intersect({{-2.5, 0, 6}, {1, 0, -2}}, make_cone({0, 0, 0}, {0, 0, 1}, 2.0, 1.0), t));
    EXPECT_EQ(t.leave, 3.0);
    EXPECT_EQ(t.leave_part, base_cap);
    EXPECT_NEAR(t.enter, 2.25, 1e-15);
}

TEST(Cone, IsNotMetByLinesParallelToItsSideThatPassTheApex) {
    // Level with the apex at their nearest point: the quadratic has no root.
    const QuadricShape cone = make_cone({0, 0, 0}, {0, 0, 1}, 1.0, 1.0);
    SolidSpan t{};
    for (const double aside : {-2.0, -0.5, 0.25, 4.0}) {
        EXPECT_FALSE(intersect({{-3, aside, 4}, {1, 0, -1}}, cone, t)) << aside;
        EXPECT_FALSE(intersect({{aside, -3, 4}, {0, 1, -1}}, cone, t)) << aside;
    }
}

TEST(Cone, IsMetAtItsApex) {
    SolidSpan t{};
    ASSERT_TRUE(intersect({{0, 0, 5}, {0, 0, -1}}, spike, t)) << "down the axis";
    EXPECT_EQ(t.enter, 3.0);
    EXPECT_EQ(t.leave, 5.0);
    ASSERT_TRUE(intersect({{-1, 0, 2}, {1, 0, 0}}, spike, t)) << "a touch";
    EXPECT_EQ(t.enter, 1.0);
    EXPECT_EQ(t.leave, 1.0);
    const ExactPoint point = surface(spike, side, {0, 0, 2});
    EXPECT_EQ(point.p, dvec3(0, 0, 2));
    EXPECT_EQ(point.n, dvec3(0, 0, 1));
}

TEST(Cone, IsExactFromFarAway) {
    SolidSpan t{};
    ASSERT_TRUE(intersect({{-1e7, 0.25, 1}, {1, 0, 0}}, spike, t));
    const double half_chord = std::sqrt(0.25 - 0.0625);
    EXPECT_NEAR(t.enter, 1e7 - half_chord, 4e-9);
    EXPECT_NEAR(t.leave, 1e7 + half_chord, 4e-9);
}

TEST(Cone, MissesByNaN) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    SolidSpan t{};
    EXPECT_FALSE(intersect({{nan, 0, -5}, {0, 0, 1}}, spike, t));
    EXPECT_FALSE(intersect({{0, 0, -5}, {0, nan, 1}}, spike, t));
}

TEST(Cone, AgreesWithPointsInside) {
    // A point of the line is inside the solid exactly between the two roots.
    std::mt19937_64 engine(6);
    const auto number = [&] { return static_cast<double>(engine() >> 11) * 0x1p-52 - 1.0; };
    int hits = 0;
    for (int round = 0; round < 100'000; ++round) {
        const dvec3 axis = glm::normalize(dvec3{number(), number(), number() + 1e-3});
        const dvec3 base{number(), number(), number()};
        const double height = 1.0 + number() * 0.95;
        const double radius = 1.0 + number() * 0.95;
        const QuadricShape c = make_cone(base, axis, height, radius);
        const dvec3 origin{number() * 4, number() * 4, number() * 4};
        const Line line{origin, {number(), number(), number()}};
        const auto inside = [&](double t) {
            const dvec3 v = line.origin + line.direction * t - c.base;
            const double h = glm::dot(axis, v);
            return h >= 0 && h <= height && glm::length(v - axis * h) <= radius * (1 - h / height);
        };
        SolidSpan t{};
        const bool hit = intersect(line, c, t);
        hits += hit ? 1 : 0;
        if (hit) {
            const double length = t.leave - t.enter;
            if (length < 1e-9) continue;
            ASSERT_TRUE(inside(t.enter + length * 1e-4) && inside(t.leave - length * 1e-4)) << round;
            ASSERT_FALSE(inside(t.enter - length * 1e-4) || inside(t.leave + length * 1e-4)) << round;
        } else {
            for (int i = -50; i <= 50; ++i) ASSERT_FALSE(inside(0.1 * i)) << round;
        }
    }
    EXPECT_GT(hits, 4000);
}

TEST(Cone, SurfaceIsNearestOnThePartHit) {
    // (0.5, 0, 1) is on the side, whose normal is (2, 0, 1) / √5.
    const dvec3 normal = dvec3(2, 0, 1) / std::sqrt(5.0);
    const ExactPoint point = surface(spike, side, dvec3(0.5, 0, 1) + normal * 0.01);
    EXPECT_LT(glm::length(point.p - dvec3(0.5, 0, 1)), 1e-15);
    EXPECT_LT(glm::length(point.n - normal), 1e-15);
    EXPECT_EQ(surface(spike, base_cap, {0.5, 0, 0.1}).p, dvec3(0.5, 0, 0));
    EXPECT_EQ(surface(spike, base_cap, {0.5, 0, 0.1}).n, dvec3(0, 0, -1));
}

TEST(Plane, IsMetWhereItsEquationHolds) {
    const Plane plane{{0, 0, 2}, 6}; // z = 3
    double t = 0;
    ASSERT_TRUE(intersect({{7, 8, 1}, {0, 1, 4}}, plane, t));
    EXPECT_EQ(t, 0.5);
    EXPECT_FALSE(intersect({{0, 0, 3}, {1, 1, 0}}, plane, t)) << "parallel";
    ExactPoint point;
    point_of_plane(plane.normal, plane.offset, {7, 8, 5}, point.p, point.n);
    EXPECT_EQ(point.p, dvec3(7, 8, 3));
    EXPECT_EQ(point.n, dvec3(0, 0, 1)) << "of unit length";
}

TEST(Extent, IsTight) {
    const Interval sphere = extent(make_sphere({1, 2, 3}, 2.0), {0, 1, 0});
    EXPECT_EQ(sphere.low, 0.0);
    EXPECT_EQ(sphere.high, 4.0);
    const Interval along = extent(drum, {0, 0, -1});
    EXPECT_EQ(along.low, -4.0);
    EXPECT_EQ(along.high, -1.0);
    const Interval across = extent(drum, {1, 0, 0});
    EXPECT_EQ(across.low, -2.0);
    EXPECT_EQ(across.high, 2.0);
    const double r = std::sqrt(0.5);
    const Interval slanted = extent(make_cylinder({0, 0, 0}, {r, 0, r}, 2.0, 1.0), {1, 0, 0});
    EXPECT_NEAR(slanted.low, -r, 1e-15);
    EXPECT_NEAR(slanted.high, 3 * r, 1e-15);
    const Interval disk = extent(make_disk({0, 0, 5}, {r, 0, r}, 1.0), {1, 0, 0});
    EXPECT_NEAR(disk.low, -r, 1e-15);
    EXPECT_NEAR(disk.high, r, 1e-15);
    const Interval cone = extent(spike, {0, 0, 1});
    EXPECT_EQ(cone.low, 0.0);
    EXPECT_EQ(cone.high, 2.0);
    const Interval wide = extent(spike, {1, 0, 0});
    EXPECT_EQ(wide.low, -1.0);
    EXPECT_EQ(wide.high, 1.0);
}

TEST(Sides, CoincideWhereCentreAxisAndRadiusDo) {
    const double error = 1e-7;
    const QuadricShape ball = make_sphere({1, 2, 3}, 2);
    EXPECT_TRUE(same_side(ball, ball, error));
    EXPECT_FALSE(same_side(ball, make_sphere({1, 2, 3}, 2.001), error));
    EXPECT_FALSE(same_side(ball, make_sphere({1, 2, 3.001}, 2), error));
    const QuadricShape tube = make_cylinder({0, 0, 1}, {0, 0, 1}, 3, 2);
    EXPECT_TRUE(same_side(tube, make_cylinder({0, 0, 9}, {0, 0, -1}, 7, 2), error)) << "longer, reversed";
    EXPECT_FALSE(same_side(tube, make_cylinder({0, 0.001, 1}, {0, 0, 1}, 3, 2), error));
    EXPECT_FALSE(same_side(tube, make_cylinder({0, 0, 1}, {0, 0, 1}, 3, 1.999), error));
    const QuadricShape hat = make_cone({0, 0, 0}, {0, 0, 1}, 2, 1);
    EXPECT_TRUE(same_side(hat, make_cone({0, 0, 1}, {0, 0, 1}, 1, 0.5), error)) << "its tip";
    EXPECT_FALSE(same_side(hat, make_cone({0, 0, 1}, {0, 0, 1}, 1, 0.6), error));
    EXPECT_FALSE(same_side(hat, tube, error));
    EXPECT_FALSE(same_side(make_disk({0, 0, 0}, {0, 0, 1}, 1), make_disk({0, 0, 0}, {0, 0, 1}, 1), error));
}

} // namespace
} // namespace glint::geometry
