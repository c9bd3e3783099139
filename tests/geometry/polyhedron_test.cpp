#include "geometry/polyhedron.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

namespace glint::geometry {
namespace {

struct Named {
    const char* name;
    Polyhedron solid;
    double volume;
};

const dvec3 center(3, -2, 7);

Footing footing(int sides, const dvec3& axis) {
    Footing f;
    f.base = center;
    f.axis = axis;
    f.sides = sides;
    f.radius = 1.5;
    f.height = 2.5;
    return f;
}

double polygon_area(int sides) { return 0.5 * sides * 1.5 * 1.5 * std::sin(2 * std::numbers::pi / sides); }

// Every kind, with the closed form of its volume.
std::vector<Named> all_solids() {
    const double s5 = std::sqrt(5.0);
    const double dodecahedron_edge = 4 / (std::sqrt(3.0) * (1 + s5));
    const double icosahedron_edge = 1 / std::sin(2 * std::numbers::pi / 5);
    std::vector<Named> all;
    all.push_back({"box", make_box(center, dvec3(2, 3, 0.5)), 3.0});
    all.push_back({"tetrahedron", make_tetrahedron(center, 1), 8 * std::sqrt(3.0) / 27});
    all.push_back({"octahedron", make_octahedron(center, 1), 4.0 / 3});
    all.push_back(
        {"dodecahedron", make_dodecahedron(center, 1), (15 + 7 * s5) / 4 * std::pow(dodecahedron_edge, 3)});
    all.push_back(
        {"icosahedron", make_icosahedron(center, 1), 5 * (3 + s5) / 12 * std::pow(icosahedron_edge, 3)});
    for (int sides : {3, 4, 6, 17, 1000}) {
        all.push_back({"prism", make_prism(footing(sides, dvec3(1, 2, -3))), polygon_area(sides) * 2.5});
        all.push_back(
            {"pyramid", make_pyramid(footing(sides, dvec3(0, 0, -1))), polygon_area(sides) * 2.5 / 3});
    }
    return all;
}

double signed_volume(const Polyhedron& p) {
    double sum = 0;
    for (const uvec3& t : p.triangles) {
        const dvec3 a = p.positions[t.x] - center;
        const dvec3 b = p.positions[t.y] - center;
        const dvec3 c = p.positions[t.z] - center;
        sum += glm::dot(a, glm::cross(b, c)) / 6;
    }
    return sum;
}

dvec3 middle(const Polyhedron& p) {
    dvec3 sum(0);
    for (const dvec3& v : p.positions) sum += v;
    return sum / static_cast<double>(p.positions.size());
}

TEST(Polyhedron, IsClosed) {
    for (const Named& s : all_solids()) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (const uvec3& t : s.solid.triangles) {
            ++edges[{t.x, t.y}];
            ++edges[{t.y, t.z}];
            ++edges[{t.z, t.x}];
        }
        for (const auto& [edge, count] : edges) {
            EXPECT_EQ(count, 1) << s.name;
            EXPECT_EQ(edges.count({edge.second, edge.first}), 1u) << s.name;
        }
    }
}

TEST(Polyhedron, ObeysEuler) {
    for (const Named& s : all_solids()) {
        const std::size_t faces = s.solid.triangles.size();
        EXPECT_EQ(s.solid.positions.size() + faces, faces * 3 / 2 + 2) << s.name;
    }
}

TEST(Polyhedron, FacesOutward) {
    for (const Named& s : all_solids()) {
        const dvec3 inside = middle(s.solid);
        for (const uvec3& t : s.solid.triangles) {
            const dvec3 a = s.solid.positions[t.x];
            const dvec3 n = glm::cross(s.solid.positions[t.y] - a, s.solid.positions[t.z] - a);
            EXPECT_GT(glm::dot(n, a - inside), 0) << s.name;
        }
    }
}

TEST(Polyhedron, HasTheVolumeOfItsClosedForm) {
    for (const Named& s : all_solids())
        EXPECT_NEAR(signed_volume(s.solid), s.volume, 1e-12 * s.volume) << s.name;
}

TEST(Polyhedron, PlatonicCornersLieOnTheCircumscribedSphere) {
    const std::array<Polyhedron, 4> solids{make_tetrahedron(center, 2), make_octahedron(center, 2),
                                           make_dodecahedron(center, 2), make_icosahedron(center, 2)};
    for (const Polyhedron& p : solids) {
        for (const dvec3& v : p.positions) EXPECT_NEAR(glm::length(v - center), 2, 1e-14);
    }
}

// The corners nearest to each corner are its neighbours; in a regular solid all have the same number of them,
// at the same distance.
void expect_equal_edges(const Polyhedron& p, int neighbours) {
    double shortest = 1e30;
    for (const dvec3& v : p.positions) {
        const double apart = glm::length(v - p.positions[0]);
        if (apart > 0) shortest = std::min(shortest, apart);
    }
    for (const dvec3& a : p.positions) {
        const auto count = std::count_if(p.positions.begin(), p.positions.end(), [&](const dvec3& b) {
            return std::fabs(glm::length(a - b) - shortest) < 1e-12;
        });
        EXPECT_EQ(count, neighbours);
    }
}

TEST(Polyhedron, PlatonicSolidsAreRegular) {
    expect_equal_edges(make_tetrahedron(dvec3(0), 1), 3);
    expect_equal_edges(make_octahedron(dvec3(0), 1), 4);
    expect_equal_edges(make_dodecahedron(dvec3(0), 1), 3);
    expect_equal_edges(make_icosahedron(dvec3(0), 1), 5);
}

TEST(Polyhedron, FacesOfTheDodecahedronAreFlat) {
    const Polyhedron p = make_dodecahedron(dvec3(0), 1);
    ASSERT_EQ(p.triangles.size(), 36u);
    for (std::size_t face = 0; face < 36; face += 3) {
        const uvec3 t = p.triangles[face];
        const dvec3 a = p.positions[t.x];
        const dvec3 n = glm::normalize(glm::cross(p.positions[t.y] - a, p.positions[t.z] - a));
        for (std::size_t i = face; i < face + 3; ++i) {
            EXPECT_NEAR(glm::dot(n, p.positions[p.triangles[i].z] - a), 0, 1e-15);
        }
    }
}

TEST(Polyhedron, PlatonicSolidsStandAsDocumented) {
    EXPECT_EQ(make_tetrahedron(center, 2).positions[0], center + dvec3(0, 0, 2));
    EXPECT_EQ(make_octahedron(center, 2).positions[0], center + dvec3(0, 0, 2));
    EXPECT_EQ(make_icosahedron(center, 2).positions[0], center + dvec3(0, 0, 2));
    const Polyhedron d = make_dodecahedron(dvec3(0), 1);
    for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(d.positions[k].z, d.positions[0].z);
    EXPECT_EQ(d.positions[0].y, 0);
    EXPECT_GT(d.positions[0].x, 0);
}

TEST(Polyhedron, BoxFillsItsBounds) {
    const Polyhedron p = make_box(center, dvec3(2, 4, 6));
    EXPECT_EQ(p.positions.front(), center - dvec3(1, 2, 3));
    EXPECT_EQ(p.positions.back(), center + dvec3(1, 2, 3));
}

TEST(Polyhedron, FirstCornerLiesTowardX) {
    const Polyhedron p = make_prism(footing(5, dvec3(0, 0, 4)));
    EXPECT_EQ(p.positions[0], center + dvec3(1.5, 0, 0));
    EXPECT_EQ(p.positions[5], center + dvec3(1.5, 0, 2.5));
}

TEST(Polyhedron, FirstCornerTurnsWithTheAxis) {
    const Polyhedron along_x = make_prism(footing(4, dvec3(1, 0, 0)));
    EXPECT_NEAR(glm::length(along_x.positions[0] - (center + dvec3(0, 0, -1.5))), 0, 1e-14);
    const Polyhedron along_y = make_prism(footing(4, dvec3(0, 1, 0)));
    EXPECT_NEAR(glm::length(along_y.positions[0] - (center + dvec3(1.5, 0, 0))), 0, 1e-14);
    const Polyhedron down = make_prism(footing(4, dvec3(0, 0, -1)));
    EXPECT_EQ(down.positions[0], center + dvec3(1.5, 0, 0));
    EXPECT_NEAR(down.positions[1].y, center.y - 1.5, 1e-14);
    EXPECT_EQ(down.positions[4].z, center.z - 2.5);
}

TEST(Polyhedron, AlmostDownwardAxisKeepsItsShape) {
    for (double tilt : {1e-3, 1e-8, 1e-12, 1e-200}) {
        const Polyhedron p = make_prism(footing(4, dvec3(tilt, -tilt, -1)));
        for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_NEAR(glm::length(p.positions[k] - center), 1.5, 1e-12) << tilt;
            EXPECT_NEAR(glm::length(p.positions[k + 4] - p.positions[k]), 2.5, 1e-12) << tilt;
        }
    }
}

TEST(Polyhedron, AxisOfAnyLengthGivesTheDirectionOnly) {
    const Polyhedron unit = make_pyramid(footing(5, dvec3(0.5, 0.5, 1)));
    for (double length : {1e-200, 1e12, 1e200}) {
        const Polyhedron p = make_pyramid(footing(5, dvec3(0.5, 0.5, 1) * length));
        EXPECT_NEAR(glm::length(p.positions[5] - unit.positions[5]), 0, 1e-14) << length;
    }
}

} // namespace
} // namespace glint::geometry
