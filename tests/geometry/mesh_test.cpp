// Mesh tools and the triangulation of polygons.

#include "geometry/mesh.h"
#include "geometry/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace glint::geometry {
namespace {

struct TestMesh {
    std::vector<vec3> positions;
    std::vector<uvec3> triangles;
};

/// The cube 0 … 1, eight shared corners, triangles counter-clockwise from outside.
TestMesh cube() {
    TestMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.positions.emplace_back(static_cast<float>(i & 1), static_cast<float>((i >> 1) & 1),
                                    static_cast<float>(i >> 2));
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

/// The same surface with three separate corners for each triangle.
TestMesh soup_of(const TestMesh& mesh) {
    TestMesh soup;
    for (const uvec3& t : mesh.triangles) {
        const auto n = static_cast<std::uint32_t>(soup.positions.size());
        for (int k = 0; k < 3; ++k) soup.positions.push_back(mesh.positions[t[k]]);
        soup.triangles.emplace_back(n, n + 1, n + 2);
    }
    return soup;
}

double area(const vec3& a, const vec3& b, const vec3& c) {
    return glm::length(glm::cross(dvec3(b) - dvec3(a), dvec3(c) - dvec3(a))) / 2;
}

TEST(Weld, GivesEachVertexTheFirstAtItsPosition) {
    const std::vector<vec3> p{{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {-0.0f, 0, -0.0f}, {3, 2, 1}, {1, 2, 3}};
    EXPECT_EQ(weld_by_position(p), (std::vector<std::uint32_t>{0, 1, 0, 1, 4, 0}));
    EXPECT_TRUE(weld_by_position({}).empty());
}

TEST(Weld, TellsNeighbouringFloatsApart) {
    const float next = std::nextafter(1.0f, 2.0f);
    const std::vector<vec3> p{{1, 1, 1}, {next, 1, 1}, {1, next, 1}, {1, 1, next}};
    EXPECT_EQ(weld_by_position(p), (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(Weld, AgreesWithASearchOfAllPairs) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> coordinate(-4, 4);
    std::vector<vec3> p;
    for (int i = 0; i < 700; ++i) p.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    const std::vector<std::uint32_t> first = weld_by_position(p);
    for (std::size_t i = 0; i < p.size(); ++i)
        EXPECT_EQ(first[i], std::find(p.begin(), p.end(), p[i]) - p.begin()) << "vertex " << i;
}

TEST(Closed, HoldsForACubeAndForItsSoup) {
    const TestMesh mesh = cube();
    EXPECT_TRUE(is_closed(mesh.positions, mesh.triangles));
    const TestMesh soup = soup_of(mesh);
    EXPECT_TRUE(is_closed(soup.positions, soup.triangles));
}

TEST(Closed, FailsWithoutOneTriangleOrWithOneTurned) {
    TestMesh open = cube();
    open.triangles.pop_back();
    EXPECT_FALSE(is_closed(open.positions, open.triangles));
    TestMesh turned = cube();
    std::swap(turned.triangles[5].x, turned.triangles[5].y);
    EXPECT_FALSE(is_closed(turned.positions, turned.triangles));
    EXPECT_TRUE(has_no_holes(turned.positions, turned.triangles));
    EXPECT_FALSE(has_no_holes(open.positions, open.triangles));
    EXPECT_FALSE(is_closed(turned.positions, {}));
}

TEST(Closed, HoldsWhereTwoBodiesShareAnEdgeOrAFaceIsDegenerate) {
    TestMesh mesh = cube();
    for (const uvec3& t : cube().triangles) {
        const auto n = static_cast<std::uint32_t>(mesh.positions.size());
        for (int k = 0; k < 3; ++k) mesh.positions.push_back(cube().positions[t[k]] + vec3(1, 1, 0));
        mesh.triangles.emplace_back(n, n + 1, n + 2);
    }
    mesh.triangles.emplace_back(2, 2, 5);
    EXPECT_TRUE(is_closed(mesh.positions, mesh.triangles));
}

TEST(Volume, OfACubeIsOneWhereverItStandsAndTurnsWithItsWinding) {
    TestMesh mesh = cube();
    EXPECT_DOUBLE_EQ(signed_volume(mesh.positions, mesh.triangles), 1.0);
    for (vec3& p : mesh.positions) p += vec3(4096, -8192, 65536);
    EXPECT_DOUBLE_EQ(signed_volume(mesh.positions, mesh.triangles), 1.0);
    for (uvec3& t : mesh.triangles) std::swap(t.x, t.y);
    EXPECT_DOUBLE_EQ(signed_volume(mesh.positions, mesh.triangles), -1.0);
    EXPECT_EQ(signed_volume(mesh.positions, {}), 0.0);
}

TEST(SharpestEdge, IsTheLeastAngleBetweenFaces) {
    TestMesh mesh = cube();
    EXPECT_DOUBLE_EQ(sine_at_sharpest_edge(mesh.positions, mesh.triangles), 1) << "no edge below 90°";
    for (vec3& p : mesh.positions) p.x += p.z * 3.0f; // sides lean at a slope of 1 : 3
    for (const TestMesh& leaning : {mesh, soup_of(mesh)})
        EXPECT_NEAR(sine_at_sharpest_edge(leaning.positions, leaning.triangles), 1 / std::sqrt(10.0), 1e-12);
    mesh.triangles.emplace_back(0, 1, 2); // the back of a face
    EXPECT_NEAR(sine_at_sharpest_edge(mesh.positions, mesh.triangles), 1 / std::sqrt(10.0), 1e-12);
    EXPECT_EQ(sine_at_sharpest_edge({}, {}), 1);
}

TEST(Degenerate, IsATriangleWithARepeatedCornerOrOnALine) {
    const vec3 a(0.1f, 0.2f, 0.3f), b(3, 1, 4);
    EXPECT_TRUE(is_degenerate(a, a, b));
    EXPECT_TRUE(is_degenerate(a, b, a));
    EXPECT_TRUE(is_degenerate(b, a, a));
    EXPECT_TRUE(is_degenerate({1, 2, 3}, {2, 4, 6}, {5, 10, 15}));
    EXPECT_FALSE(is_degenerate({1, 2, 3}, {2, 4, 6}, {5, 10, std::nextafter(15.0f, 16.0f)}));
    const float tiny = std::numeric_limits<float>::denorm_min();
    EXPECT_FALSE(is_degenerate({0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}));
    EXPECT_FALSE(is_degenerate({-1e12f, 0, 0}, {1e12f, 0, 0}, {0, 1e12f, 0}));
    EXPECT_FALSE(is_degenerate({1e12f, 0, 0}, {0, 1e-12f, 0}, {0, 0, 1e-12f}));
}

TEST(Degenerate, FacesAreDroppedAndTheOthersKeepTheirOrder) {
    TestMesh mesh = cube();
    const std::vector<uvec3> good = mesh.triangles;
    mesh.triangles.insert(mesh.triangles.begin() + 3, {4, 4, 5});
    mesh.triangles.emplace_back(1, 7, 1);
    EXPECT_EQ(drop_degenerate(mesh.positions, mesh.triangles), 2u);
    EXPECT_EQ(mesh.triangles, good);
}

TEST(Angle, AgreesWithTheLibrarysArcTangent) {
    EXPECT_EQ(angle_from(0, 0), 0.0);
    EXPECT_EQ(angle_from(0, 5), 0.0);
    for (int i = 0; i <= 4000; ++i) {
        const double angle = std::numbers::pi * i / 4000;
        const double s = std::fabs(std::sin(angle)), c = std::cos(angle);
        EXPECT_NEAR(angle_from(3 * s, 3 * c), std::atan2(s, c), 1e-14);
    }
}

TEST(SmoothNormals, WeighByAngleSoThatACubesPointAlongItsDiagonals) {
    // Corners have one or two triangles on a side, so weights other than angles give other normals.
    for (const TestMesh& mesh : {cube(), soup_of(cube())}) {
        const std::vector<vec3> normals = smooth_normals(mesh.positions, mesh.triangles);
        for (std::size_t i = 0; i < normals.size(); ++i) {
            const vec3 expected = (mesh.positions[i] * 2.0f - 1.0f) / std::sqrt(3.0f);
            EXPECT_LT(glm::length(normals[i] - expected), 1e-6f) << "vertex " << i;
        }
    }
}

TEST(Creases, LeaveACubeFlatAndATentSmooth) {
    const TestMesh box = cube();
    const CreasedMesh sharp = split_at_creases(box.positions, box.triangles, std::cos(1.0));
    ASSERT_EQ(sharp.source.size(), 24u) << "four vertices for each side";
    for (std::size_t i = 0; i < box.triangles.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t vertex = sharp.triangles[i][k];
            EXPECT_EQ(sharp.source[vertex], box.triangles[i][k]);
            const vec3& n = sharp.normals[vertex];
            EXPECT_EQ(std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)}), 1.0f);
        }
    // At 90° and more the edges of a cube are smooth.
    const CreasedMesh round = split_at_creases(box.positions, box.triangles, -1);
    EXPECT_EQ(round.source.size(), box.positions.size());
    const std::vector<vec3> expected = smooth_normals(box.positions, box.triangles);
    for (std::size_t i = 0; i < round.source.size(); ++i)
        EXPECT_EQ(round.normals[i], expected[round.source[i]]);
}

TEST(SmoothNormals, AreZeroWithoutAFaceAndWhereFacesCancel) {
    const std::vector<vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}};
    const std::vector<vec3> one = smooth_normals(positions, std::vector<uvec3>{{0, 1, 2}, {0, 1, 1}});
    EXPECT_EQ(one[0], vec3(0, 0, 1));
    EXPECT_EQ(one[3], vec3(0, 0, 0));
    const std::vector<vec3> two = smooth_normals(positions, std::vector<uvec3>{{0, 1, 2}, {0, 2, 1}});
    EXPECT_EQ(two[0], vec3(0, 0, 0));
}

/// Triangulates corners 0 … n − 1 and checks the invariants of all polygons; returns the triangles.
std::vector<uvec3> split(const std::vector<vec3>& polygon) {
    std::vector<std::uint32_t> corners(polygon.size());
    for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = static_cast<std::uint32_t>(i);
    std::vector<uvec3> triangles;
    EXPECT_TRUE(triangulate(polygon, corners, triangles));
    EXPECT_EQ(triangles.size(), polygon.size() - 2);
    return triangles;
}

/// Checks that the triangles cover a flat polygon in the plane z = 0 once: all have its orientation, and
/// their areas add up.
void expect_covered(const std::vector<vec3>& polygon) {
    double twice_area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        twice_area += static_cast<double>(a.x) * b.y - static_cast<double>(a.y) * b.x;
    }
    const double direction = twice_area > 0 ? 1 : -1;
    double sum = 0;
    for (const uvec3& t : split(polygon)) {
        const vec3 &a = polygon[t.x], &b = polygon[t.y], &c = polygon[t.z];
        const double z = glm::cross(dvec3(b) - dvec3(a), dvec3(c) - dvec3(a)).z;
        EXPECT_GT(z * direction, 0) << t.x << ' ' << t.y << ' ' << t.z;
        sum += area(a, b, c);
    }
    EXPECT_NEAR(sum, std::fabs(twice_area) / 2, 1e-9 * std::fabs(twice_area));
}

TEST(Polygon, ThatIsConvexBecomesAFan) {
    const std::vector<vec3> pentagon{{0, 0, 1}, {2, 0, 1}, {3, 1, 1}, {1, 3, 1}, {-1, 1, 1}};
    EXPECT_EQ(split(pentagon), (std::vector<uvec3>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
    EXPECT_EQ(split({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), (std::vector<uvec3>{{0, 1, 2}}));
}

TEST(Polygon, ThatIsConcaveIsCoveredOnceFromEveryFirstCorner) {
    const std::vector<std::vector<vec3>> shapes{
        {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}},                                             // dart
        {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}},                       // L
        {{0, 0, 0}, {5, 0, 0}, {5, 3, 0}, {4, 3, 0}, {4, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}, // U
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},  // a corner within a side
        {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}}}; // notch
    for (std::vector<vec3> shape : shapes) {
        for (std::size_t i = 0; i < shape.size(); ++i) {
            expect_covered(shape);
            std::rotate(shape.begin(), shape.begin() + 1, shape.end());
        }
        std::reverse(shape.begin(), shape.end());
        expect_covered(shape);
    }
}

TEST(Polygon, WithAHoleOpenedByABridgeKeepsTheHoleOpen) {
    expect_covered({{0, 0, 0},
                    {6, 0, 0},
                    {6, 6, 0},
                    {0, 6, 0},
                    {0, 0, 0},
                    {2, 2, 0},
                    {2, 4, 0},
                    {4, 4, 0},
                    {4, 2, 0},
                    {2, 2, 0}});
}

TEST(Polygon, ShapedLikeARandomStarIsCoveredOnce) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> radius(0.2, 5.0);
    for (int round = 0; round < 200; ++round) {
        std::vector<vec3> star;
        const int n = 4 + round % 60;
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * i / n, r = radius(random);
            star.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
        }
        expect_covered(star);
    }
}

TEST(Polygon, ShapedLikeACombOfThousandsOfTeethIsCoveredOnce) {
    std::vector<vec3> comb;
    for (int i = 0; i < 2000; ++i) {
        comb.emplace_back(2 * i, 0, 0);
        comb.emplace_back(2 * i + 1, 50, 0);
    }
    comb.emplace_back(2 * 2000, -1, 0);
    comb.emplace_back(-1, -1, 0);
    std::reverse(comb.begin(), comb.end());
    expect_covered(comb);
}

TEST(Polygon, IsSplitAlikeHoweverItStandsInSpace) {
    const std::vector<vec3> flat{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}};
    const std::vector<uvec3> expected = split(flat);
    std::vector<vec3> turned;
    for (const vec3& p : flat) turned.emplace_back(p.y + 7, 3 - p.x, p.x + 2 * p.y);
    const std::vector<uvec3> triangles = split(turned);
    double sum = 0;
    for (const uvec3& t : triangles) sum += area(turned[t.x], turned[t.y], turned[t.z]);
    EXPECT_NEAR(sum, area(turned[0], turned[1], turned[2]) + area(turned[0], turned[2], turned[3]), 1e-9);
    EXPECT_EQ(expected.size(), triangles.size());
}

TEST(Polygon, ThatIsDegenerateStillGivesItsNumberOfTriangles) {
    const vec3 p(1, 2, 3);
    split({p, p, p, p, p});
    split({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5f, 0, 0}});
    split({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}});
    split({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 0}, {2, 2, 0}});
    split({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {1, 1, 0}, {0, 4, 0}, {0, 0, 0}});
    std::mt19937 random(5);
    std::uniform_int_distribution<int> coordinate(0, 3);
    for (int round = 0; round < 2000; ++round) {
        std::vector<vec3> tangle;
        for (int i = 0; i < 4 + round % 12; ++i)
            tangle.emplace_back(coordinate(random), coordinate(random), coordinate(random) == 0);
        split(tangle);
    }
}

TEST(Polygon, WithFewerThanThreeCornersGivesNothing) {
    const std::vector<vec3> positions{{0, 0, 0}, {1, 0, 0}};
    std::vector<uvec3> triangles;
    EXPECT_TRUE(triangulate(positions, std::vector<std::uint32_t>{}, triangles));
    EXPECT_TRUE(triangulate(positions, std::vector<std::uint32_t>{0, 1}, triangles));
    EXPECT_TRUE(triangles.empty());
}

TEST(Polygon, OfManyCornersIsAFanWhenConvexAndRefusedWhenConcave) {
    const std::size_t n = max_concave_corners + 2;
    std::vector<vec3> positions;
    for (std::size_t i = 0; i < n; ++i) {
        const float x = static_cast<float>(i);
        positions.emplace_back(x, x * x, 0);
    }
    EXPECT_EQ(split(positions).size(), n - 2);
    std::vector<std::uint32_t> corners(n);
    for (std::size_t i = 0; i < n; ++i) corners[i] = static_cast<std::uint32_t>(i);
    positions[n / 2].y *= 2;
    std::vector<uvec3> triangles;
    EXPECT_FALSE(triangulate(positions, corners, triangles));
    EXPECT_TRUE(triangles.empty());
}

} // namespace
} // namespace glint::geometry
