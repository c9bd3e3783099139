// Mirrors, and the outline that the camera draws of a sphere.

#include "gallery.h"
#include "scene_kit.h"

#include "glint/image.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glint {
namespace {

using namespace kit;

Image flipped(const Image& image) {
    Image result(image.width, image.height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c) result.at(x, y)[c] = image.at(image.width - 1 - x, y)[c];
    return result;
}

double mean(const Image& image) {
    double sum = 0;
    for (const float v : image.pixels) sum += v;
    return sum / static_cast<double>(image.pixels.size());
}

TEST(G4, APlaneMirrorShowsWhatTheReflectedCameraSees) {
    for (const Exhibit& exhibit : gallery()) {
        if (exhibit.name != "matte_solids" && exhibit.name != "highlights" && exhibit.name != "points")
            continue;
        SceneDescription direct = exhibit.scene;
        direct.whitted.max_depth = 4;
        direct.render.width = 160;
        direct.render.height = 120;
        for (Material& m : direct.materials) m.reflectivity = 0;

        // The mirror stands one unit before the direct camera; the other one looks into it from the front.
        SceneDescription mirrored = direct;
        CameraDescription& camera = *mirrored.camera;
        const Vec3 n = glm::normalize(Vec3(0.05, -1, 0.02));
        const double offset = glm::dot(n, camera.eye) - 1;
        camera.eye -= n * (2 * (glm::dot(n, camera.eye) - offset));
        camera.direction -= n * (2 * glm::dot(n, camera.direction));
        camera.up -= n * (2 * glm::dot(n, camera.up));
        add(mirrored, PlaneShape{n, offset}, mirror());
        mirrored.whitted.max_depth = 5;
        // All lights are in front of the mirror as well, so that it throws no shadow on what is seen.
        for (const Light& light : direct.lights)
            if (const auto* p = std::get_if<PointLight>(&light.kind)) {
                ASSERT_LT(glm::dot(n, p->position), offset);
            }

        const Image seen = flipped(rendered(mirrored).image);
        const Image expected = rendered(direct).image;
        const Comparison c = compare(seen, expected, 1.0 / 255, 1);
        EXPECT_LE(c.share, 0.001) << exhibit.name;
        EXPECT_NEAR(mean(seen), mean(expected), 1e-4 * mean(expected)) << exhibit.name;
        EXPECT_GT(mean(expected), 0.05);
    }
}

/// Two mirrors face each other; after `bounces` of them the ray leaves through a lamp that hangs on its way.
double light_between_mirrors(int bounces, int max_depth, double k) {
    SceneDescription scene = empty_scene();
    scene.whitted.max_depth = max_depth;
    add(scene, PlaneShape{Vec3(1, 0, 0), 0}, mirror(k));
    add(scene, PlaneShape{Vec3(-1, 0, 0), -1}, mirror(k));
    // Each way across rises by 1: the lamp is halfway up the one after the last bounce.
    add(scene, PlaneShape{Vec3(0, 0, 1), bounces - 0.5}, lamp(Vec3(1)));
    return look(scene, Vec3(0.5, 0, -0.5), Vec3(1, 0, 1)).light.x;
}

TEST(G4b, FacingMirrorsMultiplyOncePerBounce) {
    for (const double k : {0.5, 0.8})
        for (const int bounces : {1, 2, 3, 5, 10}) {
            const double expected = std::pow(static_cast<float>(k), bounces);
            EXPECT_NEAR(light_between_mirrors(bounces, bounces, k), expected, expected * 1e-6);
            EXPECT_EQ(light_between_mirrors(bounces, bounces - 1, k), 0);
        }
}

TEST(G13, TheOutlineOfASphereHasTheRightRadius) {
    SceneDescription scene = empty_scene(Vec3(0), Vec3(0, 1, 0), 1000, 40);
    add(scene, SphereShape{Vec3(0, 5, 0), 1}, lamp(Vec3(1)));
    const Image image = rendered(scene).image;
    double area = 0;
    for (const float v : image.pixels) area += v / 3;
    EXPECT_NEAR(area, 247028, 247028 * 5e-4);
    EXPECT_NEAR(std::sqrt(area / pi), 280.4132, 280.4132 * 5e-4);
    double width = 0, height = 0;
    for (int i = 0; i < 1000; ++i) {
        width += image.at(i, 500)[0];
        height += image.at(500, i)[0];
    }
    EXPECT_NEAR(width / 2, 280.4132, 1);
    EXPECT_NEAR(height / 2, 280.4132, 1);
}

} // namespace
} // namespace glint
