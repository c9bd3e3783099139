// Lists of transformations as matrices.

#include "scene_support.h"

#include <cmath>

namespace glint::test {
namespace {

Mat4 transform(const std::string& list) {
    const std::string text =
        "[material.m]\n[[sphere]]\ncenter = [0,0,0]\nradius = 1\nmaterial = \"m\"\ntransform = ";
    return parse(text + list).description.objects.at(0).transform;
}

Vec3 moved(const std::string& list, const Vec3& p) { return Vec3(transform(list) * glm::dvec4(p, 1)); }

TEST(SceneTransforms, TheFirstEntryIsAppliedFirst) {
    EXPECT_EQ(moved("[{ translate = [1, 0, 0] }, { scale = 2 }]", {1, 1, 1}), Vec3(4, 2, 2));
    EXPECT_EQ(moved("[{ scale = 2 }, { translate = [1, 0, 0] }]", {1, 1, 1}), Vec3(3, 2, 2));
    EXPECT_EQ(moved("[{ translate = [1, 0, 0] }, { rotate = [0, 0, 1], angle = 90 }]", {0, 0, 0}),
              Vec3(0, 1, 0));
}

TEST(SceneTransforms, RotationsTurnCounterClockwiseAndExactlyAtQuarterTurns) {
    EXPECT_EQ(moved("[{ rotate = [0, 0, 1], angle = 90 }]", {1, 2, 3}), Vec3(-2, 1, 3));
    EXPECT_EQ(moved("[{ rotate = [0, 5, 0], angle = 90 }]", {1, 2, 3}), Vec3(3, 2, -1));
    EXPECT_EQ(moved("[{ rotate = [1, 0, 0], angle = 90 }]", {1, 2, 3}), Vec3(1, -3, 2));
    EXPECT_EQ(moved("[{ rotate = [1, 0, 0], angle = -90 }]", {1, 2, 3}), Vec3(1, 3, -2));
    EXPECT_EQ(moved("[{ rotate = [0, 0, -1], angle = 90 }]", {1, 2, 3}), Vec3(2, -1, 3));
    EXPECT_EQ(moved("[{ rotate = [0, 0, 1], angle = 180 }]", {1, 2, 3}), Vec3(-1, -2, 3));
    EXPECT_EQ(transform("[{ rotate = [0, 0, 1], angle = 360 }]"), Mat4(1));
}

TEST(SceneTransforms, ARotationAboutTheDiagonalSwapsAxes) {
    const Vec3 p = moved("[{ rotate = [1, 1, 1], angle = 120 }]", {1, 2, 3});
    EXPECT_NEAR(p.x, 3, 1e-14);
    EXPECT_NEAR(p.y, 1, 1e-14);
    EXPECT_NEAR(p.z, 2, 1e-14);
}

TEST(SceneTransforms, ScalesMayMirrorAndMatricesAreByRows) {
    EXPECT_EQ(moved("[{ scale = [-1, 2, 3] }]", {1, 1, 1}), Vec3(-1, 2, 3));
    EXPECT_EQ(moved("[{ matrix = [1, 2, 3, 4, 0, 5, 6, 7, 0, 0, 8, 9, 0, 0, 0, 1] }]", {1, 1, 1}),
              Vec3(10, 18, 17));
}

TEST(SceneTransforms, TablesOfAListWorkToo) {
    const auto scene =
        parse("[material.m]\n[[sphere]]\ncenter = [0,0,0]\nradius = 1\nmaterial = \"m\"\n"
              "[[sphere.transform]]\nscale = 2\n[[sphere.transform]]\ntranslate = [1, 0, 0]\n");
    EXPECT_EQ(scene.description.objects.at(0).transform[3], glm::dvec4(1, 0, 0, 1));
    EXPECT_EQ(scene.description.objects.at(0).transform[0][0], 2);
}

} // namespace
} // namespace glint::test
