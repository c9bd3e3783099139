// Orbit, pan, zoom and flight.

#include "session/camera.h"
#include "session/times.h"

#include "scene_kit.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace glint::viewer {
namespace {

constexpr double pi = kit::pi;

CameraDescription some_camera(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-5, 5);
    CameraDescription camera;
    camera.eye = Vec3(place(random), place(random), place(random));
    camera.direction = Vec3(place(random), place(random), 0.5 * place(random));
    camera.fov = 20 + std::abs(place(random)) * 10;
    return camera;
}

Vec3 right_of(const CameraDescription& c) { return glm::normalize(glm::cross(c.direction, c.up)); }

/// Tolerance in scene units; the scenes are about 1 in size.
void expect_near(const Vec3& a, const Vec3& b, double tolerance = 1e-9) {
    EXPECT_LE(glm::length(a - b), tolerance)
        << a.x << " " << a.y << " " << a.z << " is not " << b.x << " " << b.y << " " << b.z;
}

TEST(CameraControl, OrbitKeepsTargetDistanceAndUp) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> angle(-2, 2);
    for (int i = 0; i < 200; ++i) {
        CameraControl control(some_camera(random), 3);
        const Vec3 target = control.target();
        for (int k = 0; k < 10; ++k) control.orbit(angle(random), angle(random));
        expect_near(control.target(), target);
        EXPECT_NEAR(glm::length(control.camera().eye - target), 3, 1e-9);
        EXPECT_EQ(control.camera().up, Vec3(0, 0, 1));
    }
}

TEST(CameraControl, NoOrbitTurnsThePictureOver) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> angle(-1, 1);
    for (int i = 0; i < 100; ++i) {
        CameraControl control(some_camera(random), 2);
        control.orbit(0, 10);
        for (int k = 0; k < 50; ++k) {
            const Vec3 before = right_of(control.camera());
            control.orbit(0, angle(random) * 3);
            expect_near(right_of(control.camera()), before, 1e-6);
        }
    }
}

TEST(CameraControl, AWholeTurnComesBack) {
    std::mt19937 random(3);
    for (int i = 0; i < 50; ++i) {
        const CameraDescription home = some_camera(random);
        CameraControl control(home, 4);
        for (int k = 0; k < 36; ++k) control.orbit(pi / 18, 0);
        expect_near(control.camera().eye, home.eye);
    }
}

TEST(CameraControl, OrbitingToTheRightMovesTheEyeToTheRight) {
    CameraDescription home;
    home.eye = Vec3(0, -3, 0);
    home.direction = Vec3(0, 1, 0);
    CameraControl control(home, 3);
    control.orbit(0.1, 0);
    EXPECT_GT(control.camera().eye.x, 0);
    control.reset();
    control.orbit(0, 0.1);
    EXPECT_GT(control.camera().eye.z, 0);
}

TEST(CameraControl, PanningAPictureHeightShowsTheNextOne) {
    CameraDescription home;
    home.eye = Vec3(0, -5, 0);
    home.direction = Vec3(0, 7, 0);
    home.fov = 90;
    CameraControl control(home, 5);
    control.pan(0, 1);
    expect_near(control.camera().eye, Vec3(0, -5, 10));
    expect_near(control.target(), Vec3(0, 0, 10));
    control.pan(-0.5, -1);
    expect_near(control.camera().eye, Vec3(-5, -5, 0));
}

TEST(CameraControl, ZoomGoesToTheTargetAndBack) {
    std::mt19937 random(4);
    for (int i = 0; i < 50; ++i) {
        const CameraDescription home = some_camera(random);
        CameraControl control(home, 4);
        const Vec3 target = control.target();
        control.zoom(100);
        EXPECT_GT(control.target_distance(), 0);
        expect_near(control.target(), target);
        control.zoom(-100);
        expect_near(control.camera().eye, home.eye);
        control.zoom(1);
        EXPECT_NEAR(glm::length(control.camera().eye - target), 3.6, 1e-9);
    }
}

TEST(CameraControl, FlyingMovesEyeAndTargetAlike) {
    CameraControl control(CameraDescription{}, 2);
    control.fly(0.5, 1, 2);
    expect_near(control.camera().eye, Vec3(1, 4, 2));
    expect_near(control.target(), Vec3(1, 6, 2));
}

TEST(CameraControl, ResetComesBackExactly) {
    std::mt19937 random(5);
    const CameraDescription home = some_camera(random);
    CameraControl control(home, 0.7);
    control.orbit(1, 2);
    control.zoom(3);
    control.pan(1, 1);
    control.fly(1, 2, 3);
    control.set_fov(100);
    control.set_camera(some_camera(random), 9);
    control.reset();
    EXPECT_EQ(control.camera().eye, home.eye);
    EXPECT_EQ(control.camera().direction, home.direction);
    EXPECT_EQ(control.camera().fov, home.fov);
    EXPECT_EQ(control.target_distance(), 0.7);
}

TEST(CameraControl, TheFieldOfViewStaysPossible) {
    CameraControl control(CameraDescription{}, 1);
    control.set_fov(-5);
    EXPECT_EQ(control.camera().fov, 1);
    control.set_fov(1000);
    EXPECT_EQ(control.camera().fov, 170);
    control.set_fov(33);
    EXPECT_EQ(control.camera().fov, 33);
}

TEST(CameraControl, TheTargetIsWhatStandsInTheMiddle) {
    SceneDescription scene = kit::empty_scene();
    kit::add(scene, SphereShape{Vec3(0, 5, 0), 1}, kit::matte());
    EXPECT_NEAR(target_distance(build_scene(scene)), 4, 1e-5);
    scene.camera->direction = Vec3(1, 1, 0);
    EXPECT_NEAR(target_distance(build_scene(scene)), 5 / std::sqrt(2.0), 1e-5);
    EXPECT_EQ(target_distance(build_scene(kit::empty_scene())), 1);
}

// ── Frame times ──────────────────────────────────────────────────────────────────────────────────────────

TEST(FrameTimes, QuantilesAreThoseOfTheSortedTimes) {
    std::mt19937 random(6);
    std::lognormal_distribution<double> time(-4, 1);
    FrameTimes times;
    std::vector<double> all;
    for (int i = 0; i < 5000; ++i) {
        all.push_back(time(random));
        times.add(all.back());
    }
    std::sort(all.begin(), all.end());
    for (const double share : {0.01, 0.5, 0.9, 0.99, 0.999, 1.0}) {
        const double exact = all[static_cast<std::size_t>(std::ceil(share * 5000)) - 1];
        EXPECT_GE(times.quantile(share), exact * (1 - 1e-12));
        EXPECT_LE(times.quantile(share), std::max(exact * 1.0501, 1e-4));
    }
}

TEST(FrameTimes, NoFramesAreNoTrouble) {
    const FrameTimes times;
    EXPECT_EQ(times.quantile(0.5), 0);
    EXPECT_EQ(times.summary(), "no frames");
    EXPECT_EQ(times.histogram(), "");
}

TEST(FrameTimes, TheSummarySaysWhatMatters) {
    FrameTimes times;
    for (int i = 0; i < 999; ++i) times.add(0.010);
    times.add(0.2);
    EXPECT_EQ(times.count(), 1000u);
    EXPECT_NEAR(times.quantile(0.5), 0.010, 0.0005);
    EXPECT_NE(times.summary().find("1000 frames, median 10."), std::string::npos) << times.summary();
    EXPECT_NE(times.summary().find("longest 200.0 ms"), std::string::npos) << times.summary();
    EXPECT_NE(times.histogram().find("999 ####"), std::string::npos) << times.histogram();
}

} // namespace
} // namespace glint::viewer
