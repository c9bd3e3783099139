// The meshes that tools/meshgen makes for the scenes.

#include "geometry/mesh.h"
#include "request.h"
#include "scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace glint::meshgen {
namespace {

Request request(Kind kind, double triangles) {
    Request r;
    r.kind = kind;
    r.triangles = triangles;
    r.colors = true;
    return r;
}

constexpr Kind closed_kinds[] = {Kind::gyroid, Kind::knot, Kind::torus, Kind::shell, Kind::icosphere};

TEST(Meshgen, SolidsAreClosedAndFaceOutward) {
    for (Kind kind : closed_kinds) {
        const Mesh mesh = make_mesh(request(kind, 8000));
        EXPECT_TRUE(geometry::is_closed(mesh.positions, mesh.triangles)) << static_cast<int>(kind);
        EXPECT_GT(geometry::signed_volume(mesh.positions, mesh.triangles), 0) << static_cast<int>(kind);
    }
}

TEST(Meshgen, MakesAboutAsManyTrianglesAsAskedFor) {
    for (Kind kind : {Kind::gyroid, Kind::knot, Kind::torus, Kind::shell, Kind::terrain}) {
        const auto made = static_cast<double>(make_mesh(request(kind, 100000)).triangles.size());
        EXPECT_NEAR(made, 100000, 8000) << static_cast<int>(kind);
    }
    EXPECT_EQ(make_mesh(request(Kind::icosphere, 20000)).triangles.size(), 20480u);
}

TEST(Meshgen, HasNoDegenerateTriangles) {
    for (Kind kind : {Kind::gyroid, Kind::knot, Kind::torus, Kind::shell, Kind::icosphere, Kind::terrain}) {
        Mesh mesh = make_mesh(request(kind, 120000));
        EXPECT_EQ(geometry::drop_degenerate(mesh.positions, mesh.triangles), 0u) << static_cast<int>(kind);
    }
}

TEST(Meshgen, VerticesHaveNormalsAndColoursOnlyWhereAskedFor) {
    Request r = request(Kind::shell, 2000);
    const Mesh full = make_mesh(r);
    EXPECT_EQ(full.normals.size(), full.positions.size());
    EXPECT_EQ(full.colors.size(), full.positions.size());
    r.colors = false;
    r.flat = true;
    const Mesh bare = make_mesh(r);
    EXPECT_TRUE(bare.normals.empty());
    EXPECT_TRUE(bare.colors.empty());
    EXPECT_EQ(bare.positions, full.positions);
}

TEST(Meshgen, TorusHasItsVolume) {
    const Mesh mesh = make_mesh(request(Kind::torus, 200000));
    EXPECT_NEAR(geometry::signed_volume(mesh.positions, mesh.triangles),
                2 * std::numbers::pi * std::numbers::pi * 0.16, 1e-2);
}

TEST(Meshgen, GyroidStaysInItsBall) {
    for (const vec3& p : make_mesh(request(Kind::gyroid, 20000)).positions) EXPECT_LT(glm::length(p), 1.01f);
}

TEST(Meshgen, SeedMakesAnotherIsland) {
    Request r = request(Kind::terrain, 2000);
    const Mesh one = make_mesh(r);
    EXPECT_EQ(make_mesh(r).positions, one.positions);
    r.seed = 2;
    EXPECT_NE(make_mesh(r).positions, one.positions);
}

TEST(Meshgen, FlakeHasNineBallsOnEach) {
    const std::string text = sphere_flake_scene(2);
    std::size_t balls = 0;
    for (std::size_t at = text.find("[[sphere]]"); at != std::string::npos;
         at = text.find("[[sphere]]", at + 1))
        ++balls;
    EXPECT_EQ(balls, 1u + 9u + 81u);
}

std::string refusal(const std::vector<std::string>& arguments) {
    try {
        parse_request(arguments);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        return error.diagnostics().at(0).message + " | " + error.diagnostics().at(0).hint;
    }
    return "";
}

TEST(Meshgen, RefusesWhatItDoesNotUnderstand) {
    EXPECT_EQ(refusal({}), "no shape given | expected glint-meshgen SHAPE -o FILE; see --help");
    EXPECT_EQ(refusal({"gyriod"}), "there is no shape called 'gyriod' | did you mean \"gyroid\"?");
    EXPECT_EQ(refusal({"torus"}), "no output given | add -o FILE.ply");
    EXPECT_EQ(refusal({"torus", "--colours", "-o", "x.ply"}),
              "unknown option --colours | did you mean \"--colors\"?");
    EXPECT_EQ(refusal({"torus", "-o"}), "-o needs a value | see glint-meshgen --help");
    EXPECT_EQ(refusal({"torus", "--triangles", "many"}),
              "'many' is no value for --triangles | expected a whole number from 20 to 20000000");
    EXPECT_EQ(refusal({"torus", "--format", "obj"}),
              "'obj' is no value for --format | expected ascii, binary or big-endian");
    EXPECT_EQ(refusal({"knot", "-o", "x.ply", "-p", "4", "-q", "6"}),
              "-p and -q have a common divisor: that is a link of several knots | take coprime numbers, such "
              "as 2 and 3");
}

TEST(Meshgen, ReadsEveryOption) {
    const auto r = parse_request({"knot", "--triangles", "500", "--colors", "--flat", "--format", "ascii",
                                  "-p", "3", "-q", "7", "--seed", "9", "-o", "x.ply"});
    ASSERT_TRUE(r.has_value());
    EXPECT_EQ(r->kind, Kind::knot);
    EXPECT_EQ(r->triangles, 500);
    EXPECT_TRUE(r->colors && r->flat);
    EXPECT_EQ(r->format, PlyFormat::ascii);
    EXPECT_EQ(r->p, 3);
    EXPECT_EQ(r->q, 7);
    EXPECT_EQ(r->seed, 9u);
    EXPECT_EQ(r->output, "x.ply");
    EXPECT_FALSE(parse_request({"torus", "--help"}).has_value());
}

} // namespace
} // namespace glint::meshgen
