// Ground of triangles looks like the plane in which they lie, whatever their size.

#include "scene_kit.h"

#include "imaging/tone.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace glint {

using kit::add;
using kit::mesh_of;
namespace {

/// Balls on a ground at z = 0, seen from above, with shadows and reflections. A large ball far away keeps the
/// scene where it is.
SceneDescription balls_on(const Shape& ground, const Vec3& at) {
    SceneDescription scene = kit::empty_scene(at + Vec3(0, -3, 2.5), Vec3(0, 3, -2.4), 1, 20);
    scene.render.width = 160;
    scene.render.height = 120;
    Material shiny = kit::matte(0.8);
    shiny.reflectivity = 0.3;
    add(scene, ground, shiny);
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y) add(scene, SphereShape{at + Vec3(0.3 * x, 0.3 * y, 0.1), 0.1}, shiny);
    if (at != Vec3(0)) add(scene, SphereShape{-at, 0.2 * at.x}, shiny);
    kit::add_light(scene, at + Vec3(2, -3, 4), 25);
    return scene;
}

/// The share of pixels that are more than 1/255 off the picture of the plane.
double share_off(const Shape& ground, const Vec3& at = Vec3(0)) {
    const Picture plane = kit::rendered(balls_on(PlaneShape{Vec3(0, 0, 1), 0}, at));
    const Picture picture = kit::rendered(balls_on(ground, at));
    std::size_t off = 0;
    for (std::size_t i = 0; i < plane.image.pixels.size(); i += 3) {
        const auto code = [i](const Picture& p) {
            return int{imaging::srgb8_from_linear(p.image.pixels[i])};
        };
        off += std::abs(code(picture) - code(plane)) > 1 ? 1 : 0;
    }
    return static_cast<double>(3 * off) / static_cast<double>(plane.image.pixels.size());
}

constexpr double allowed = 0.0005;

class Ground : public testing::TestWithParam<double> {
  protected:
    const double size = GetParam();
};

TEST_P(Ground, OfABoxIsThePlane) {
    EXPECT_LE(share_off(PolyhedronShape{PolyhedronKind::box, Vec3(0, 0, -size), Vec3(2 * size)}), allowed);
}

TEST_P(Ground, OfAPrismIsThePlane) {
    PolyhedronShape prism{PolyhedronKind::prism, Vec3(size / 5, 0, -size)};
    prism.radius = size;
    prism.height = size;
    EXPECT_LE(share_off(prism), allowed);
}

TEST_P(Ground, OfARectangleIsThePlane) {
    EXPECT_LE(share_off(RectangleShape{Vec3(-size, -0.9 * size, 0), Vec3(2 * size, 0, 0),
                                       Vec3(0.3 * size, 2 * size, 0)}),
              allowed);
}

TEST_P(Ground, OfAMeshIsThePlane) {
    const auto s = static_cast<float>(size);
    Mesh square;
    square.positions = {{-s, -s, 0}, {s, -s, 0}, {s, s, 0}, {-s, s, 0}};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    EXPECT_LE(share_off(mesh_of(square)), allowed);
}

INSTANTIATE_TEST_SUITE_P(Sizes, Ground, testing::Values(12, 30, 100, 300, 1e4, 1e6));

TEST(Ground, IsThePlaneFarFromTheOriginOfCoordinates) {
    for (const double far : {50.0, 500.0, 5000.0, 50000.0})
        for (const double size : {2 * far, 4 * far, 100 * far})
            EXPECT_LE(share_off(PolyhedronShape{PolyhedronKind::box, Vec3(0, 0, -size), Vec3(2 * size)},
                                Vec3(far, 0.6 * far, 0)),
                      allowed)
                << far << ", " << size;
}

TEST(Ground, OfTrianglesOfAllSizesIsThePlane) {
    // Squares in squares, ten times as large each.
    Mesh mesh;
    float size = 1e-4f;
    for (std::uint32_t ring = 0; ring < 11; ++ring, size *= 10) {
        const std::uint32_t first = 4 * ring;
        mesh.positions.insert(mesh.positions.end(),
                              {{-size, -size, 0}, {size, -size, 0}, {size, size, 0}, {-size, size, 0}});
        for (std::uint32_t k = 0; ring > 0 && k < 4; ++k) {
            const std::uint32_t next = (k + 1) % 4;
            mesh.triangles.emplace_back(first + k, first + next, first - 4 + k);
            mesh.triangles.emplace_back(first - 4 + k, first + next, first - 4 + next);
        }
    }
    mesh.triangles.emplace_back(0, 1, 2);
    mesh.triangles.emplace_back(0, 2, 3);
    EXPECT_LE(share_off(mesh_of(mesh)), allowed);
}

} // namespace
} // namespace glint
