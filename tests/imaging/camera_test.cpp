#include "imaging/camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace glint;
using namespace glint::imaging;

constexpr double pi = 3.14159265358979323846;

PinholeCamera looking_along_y(double fov, FovAxis axis, int width, int height) {
    return pinhole_camera({0, 0, 0}, {0, 7, 0}, {0, 0, 2}, fov, axis, width, height);
}

/// Angle between a ray and the y axis.
double angle_from_y(const vec3& d) { return std::atan2(std::hypot(double(d.x), double(d.z)), double(d.y)); }

TEST(Camera, SeesASphereWithTheOutlineOfTheFormula) {
    // r = 1 at 5, vertical field of view 40°, 1000 pixels: 500 · tan(asin(1/5)) / tan(20°).
    const PinholeCamera camera = looking_along_y(40, FovAxis::y, 1400, 1000);
    const double tangent_angle = std::asin(0.2);
    for (const bool sideways : {true, false}) {
        double inside = 0;
        double outside = 500;
        for (int i = 0; i < 40; ++i) {
            const double radius = (inside + outside) / 2;
            const auto r = static_cast<float>(radius);
            // Pixel (699, 499) has its centre half a pixel left of and above the middle of the film.
            const vec3 d = sideways ? pinhole_direction(camera, 699, 499, r + 0.5f, 0.5f)
                                    : pinhole_direction(camera, 699, 499, 0.5f, r + 0.5f);
            (angle_from_y(d) < tangent_angle ? inside : outside) = radius;
        }
        EXPECT_NEAR(inside, 280.4132, 280.4132e-5);
    }
}

TEST(Camera, PutsXToTheRightAndTheFirstRowOnTop) {
    const PinholeCamera camera = looking_along_y(45, FovAxis::y, 640, 480);
    const vec3 corner = pinhole_direction(camera, 0, 0, 0, 0);
    EXPECT_LT(corner.x, 0);
    EXPECT_GT(corner.y, 0);
    EXPECT_GT(corner.z, 0);
    EXPECT_GT(pinhole_direction(camera, 639, 0, 0, 0).x, 0);
    EXPECT_LT(pinhole_direction(camera, 0, 479, 0, 0).z, 0);
    EXPECT_GT(pinhole_direction(camera, 10, 10, 0.25f, 0).x, pinhole_direction(camera, 10, 10, 0, 0).x);
    EXPECT_LT(pinhole_direction(camera, 10, 10, 0, 0.25f).z, pinhole_direction(camera, 10, 10, 0, 0).z);
}

TEST(Camera, MeasuresTheFieldOfViewAlongTheNamedAxis) {
    // The ray through the middle of an edge makes half the angle with the view.
    const auto half_x = [](FovAxis axis, int w, int h) {
        const PinholeCamera c = looking_along_y(60, axis, w, h);
        return angle_from_y(pinhole_direction(c, 0, h / 2, -0.5f, -0.5f)) * 180 / pi;
    };
    const auto half_y = [](FovAxis axis, int w, int h) {
        const PinholeCamera c = looking_along_y(60, axis, w, h);
        return angle_from_y(pinhole_direction(c, w / 2, 0, -0.5f, -0.5f)) * 180 / pi;
    };
    EXPECT_NEAR(half_y(FovAxis::y, 600, 200), 30, 1e-5);
    EXPECT_NEAR(half_x(FovAxis::y, 600, 200), 60, 1e-5);
    EXPECT_NEAR(half_x(FovAxis::x, 600, 200), 30, 1e-5);
    EXPECT_NEAR(half_y(FovAxis::smaller, 600, 200), 30, 1e-5);
    EXPECT_NEAR(half_x(FovAxis::larger, 600, 200), 30, 1e-5);
    EXPECT_NEAR(half_x(FovAxis::smaller, 200, 600), 30, 1e-5);
    EXPECT_NEAR(half_y(FovAxis::larger, 200, 600), 30, 1e-5);
}

TEST(Camera, MirroredPlacesHaveExactlyMirroredDirections) {
    const PinholeCamera camera = looking_along_y(53, FovAxis::y, 65535, 1080);
    const float dx = 0.123456789f;
    const float dy = -1.7654321f;
    for (const int px : {0, 1, 777, 32766, 32767, 40001})
        for (const int py : {0, 333, 539, 540}) {
            const vec3 d = pinhole_direction(camera, px, py, dx, dy);
            const vec3 left_right = pinhole_direction(camera, 65534 - px, py, -dx, dy);
            const vec3 top_bottom = pinhole_direction(camera, px, 1079 - py, dx, -dy);
            EXPECT_EQ(left_right, vec3(-d.x, d.y, d.z)) << px << ", " << py;
            EXPECT_EQ(top_bottom, vec3(d.x, d.y, -d.z)) << px << ", " << py;
        }
}

TEST(Camera, AMirroredSceneHasExactlyMirroredRays) {
    const dvec3 eye(-50, 40, 10);
    const dvec3 view(0.5, -0.4, -0.1);
    const dvec3 up(0.1, 0.2, 1);
    const PinholeCamera camera = pinhole_camera(eye, view, up, 40, FovAxis::y, 64, 48);
    const auto flip = [](const auto& v) { return std::decay_t<decltype(v)>(-v.x, v.y, v.z); };
    const auto swap = [](const auto& v) { return std::decay_t<decltype(v)>(v.y, v.x, v.z); };
    const PinholeCamera flipped = pinhole_camera(flip(eye), flip(view), flip(up), 40, FovAxis::y, 64, 48);
    const PinholeCamera swapped = pinhole_camera(swap(eye), swap(view), swap(up), 40, FovAxis::y, 64, 48);

    for (int py = 0; py < 48; ++py)
        for (int px = 0; px < 64; ++px) {
            const vec3 d = pinhole_direction(camera, px, py, 0, 0);
            EXPECT_EQ(pinhole_direction(flipped, 63 - px, py, 0, 0), flip(d));
            EXPECT_EQ(pinhole_direction(swapped, 63 - px, py, 0, 0), swap(d));
        }
}

TEST(Camera, LengthsOfViewAndUpDoNotMatter) {
    const PinholeCamera a = pinhole_camera({1, 2, 3}, {1, 2, -3}, {0, 0, 1}, 40, FovAxis::y, 64, 48);
    const PinholeCamera b = pinhole_camera({1, 2, 3}, {256, 512, -768}, {0, 0, 0.25}, 40, FovAxis::y, 64, 48);
    EXPECT_EQ(a.forward, b.forward);
    EXPECT_EQ(a.right, b.right);
    EXPECT_EQ(a.up, b.up);
    EXPECT_EQ(a.eye, vec3(1, 2, 3));
}

TEST(Camera, DirectionsHaveUnitLength) {
    const PinholeCamera camera = pinhole_camera({0, 0, 0}, {1, 2, 3}, {0, 1, 0}, 150, FovAxis::x, 99, 77);
    for (int py = 0; py < 77; py += 4)
        for (int px = 0; px < 99; px += 7) {
            const dvec3 d(pinhole_direction(camera, px, py, 0, 0));
            EXPECT_NEAR(glm::length(d), 1, 2e-7);
        }
}

} // namespace
