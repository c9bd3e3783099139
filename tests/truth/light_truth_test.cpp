// Light that arrives from lights: closed forms for diffuse light, shadows, terminators and highlights.

#include "scene_kit.h"

#include "imaging/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace glint {
namespace {

using namespace kit;

void expect_relative(double value, double expected, double tolerance) {
    EXPECT_NEAR(value, expected, std::abs(expected) * tolerance);
}

TEST(G1, APlaneShowsCosineOverSquaredDistance) {
    SceneDescription scene = empty_scene();
    add(scene, PlaneShape{}, matte());
    add_light(scene, Vec3(0, 0, 2));
    expect_relative(look(scene, Vec3(0, 0, 1), Vec3(0, 0, -1)).light.x, 0.25, 1e-6);
    expect_relative(look(scene, Vec3(2, 0, 1), Vec3(0, 0, -1)).light.x, 0.0883883476483184, 1e-6);
}

TEST(G1b, ASphereShowsTheLightOnItsAxis) {
    SceneDescription scene = empty_scene();
    add(scene, SphereShape{}, matte());
    add_light(scene, Vec3(0, 0, 3));
    const double degrees[] = {0, 30, 60, 70};
    const double expected[] = {0.25, 0.1517797, 0.0269975, 0.00116307};
    for (int i = 0; i < 4; ++i) {
        const double a = degrees[i] * pi / 180;
        const double c = std::cos(a);
        const Vec3 out(std::sin(a), 0, c);
        const double exact = (3 * c - 1) / std::pow(10 - 6 * c, 1.5);
        expect_relative(exact, expected[i], 1e-5);
        // Seen from the side, so that the eye does not stand in the light.
        const Vec3 eye = out * 1.2 + Vec3(0, 0.3, 0);
        expect_relative(look(scene, eye, out - eye).light.x, exact, degrees[i] < 70 ? 1e-5 : 1e-4);
    }
}

/// A picture and what it should show: lit[x, y] by closed form.
struct Outline {
    Image image;
    std::function<bool(int, int)> lit;
};

/// Pixels farther than one pixel from the expected outline that show the other side.
int wrong_beyond_one_pixel(const Outline& e) {
    int wrong = 0;
    for (int y = 1; y + 1 < e.image.height; ++y)
        for (int x = 1; x + 1 < e.image.width; ++x) {
            int neighbours = 0;
            for (int k = 0; k < 9; ++k) neighbours += e.lit(x + k % 3 - 1, y + k / 3 - 1) ? 1 : 0;
            const bool shows = e.image.at(x, y)[0] > 0;
            if (neighbours == 9 && !shows) ++wrong;
            if (neighbours == 0 && shows) ++wrong;
        }
    return wrong;
}

dvec3 pixel_direction(const SceneDescription& scene, int x, int y) {
    const CameraDescription& c = *scene.camera;
    const dvec3 f = glm::normalize(c.direction);
    const dvec3 right = glm::normalize(glm::cross(f, c.up));
    const dvec3 up = glm::cross(right, f);
    const double t = std::tan(c.fov * pi / 360);
    const int n = scene.render.width;
    return f + right * (t * (2 * x + 1 - n) / n) - up * (t * (2 * y + 1 - n) / n);
}

TEST(G2, TheTerminatorLiesWhereTheLightGrazes) {
    SceneDescription scene = empty_scene(Vec3(8, 0, 0), Vec3(-1, 0, 0), 400, 15);
    add(scene, SphereShape{}, matte());
    add_light(scene, Vec3(0, 0, 3));
    EXPECT_NEAR(std::acos(1.0 / 3) * 180 / pi, 70.528779, 1e-6);
    const auto lit = [&](int x, int y) {
        const dvec3 d = glm::normalize(pixel_direction(scene, x, y));
        const double b = 8 * d.x;
        const double root = b * b - 63;
        if (root < 0) return false;
        return (d * (-b - std::sqrt(root))).z > 1.0 / 3;
    };
    EXPECT_EQ(wrong_beyond_one_pixel({rendered(scene).image, lit}), 0);
}

TEST(G2, TheShadowOfASphereIsADiscOfTheRightSize) {
    const double fov = 2 * std::atan(2.0) * 180 / pi;
    SceneDescription scene = empty_scene(Vec3(0, 0, 1.5), Vec3(0, 0, -1), 400, fov);
    add(scene, PlaneShape{}, matte());
    add(scene, SphereShape{Vec3(0, 0, 3), 1}, matte());
    add_light(scene, Vec3(0, 0, 6));
    const double radius = 6 / std::sqrt(8.0);
    EXPECT_NEAR(radius, 2.1213203, 1e-7);
    const auto lit = [&](int x, int y) {
        const dvec3 d = pixel_direction(scene, x, y);
        return 1.5 * std::hypot(d.x, d.y) > radius;
    };
    EXPECT_EQ(wrong_beyond_one_pixel({rendered(scene).image, lit}), 0);
}

TEST(G2b, NoLightLeaksOverTheGeometricHorizonOfASmoothMesh) {
    SceneDescription scene = empty_scene(Vec3(5, 1, 1), Vec3(-5, -1, -1), 200, 25);
    add(scene, mesh_of(sphere_mesh(1, 6)), matte());
    add_light(scene, Vec3(0, 0, 3));
    const Scene scene_data = build_scene(scene);
    rendering::Whitted tracer(scene_data.data());
    int leaking = 0;
    int smoothly_lit = 0;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) {
            rendering::RayTree tree;
            const vec3 direction(glm::normalize(pixel_direction(scene, x, y)));
            const vec3 light = tracer.trace(camera_ray(vec3(5, 1, 1), direction), &tree).radiance;
            const rendering::RayNode& node = tree.nodes.at(0);
            if (!node.hit) continue;
            const vec3 to_light = vec3(0, 0, 3) - node.position;
            const bool below = dot(node.geometric_normal, to_light) <= 0;
            // The shading normal alone would light these.
            if (below && dot(node.shading_normal, to_light) > 0) ++smoothly_lit;
            if (below && light.x != 0) ++leaking;
        }
    EXPECT_EQ(leaking, 0);
    EXPECT_GT(smoothly_lit, 100);
}

/// The highlight's factor alone, light and eye in one direction, `degrees` from the normal: h is that
/// direction.
double lobe(double shininess, double degrees) {
    Material m = black();
    m.highlight = 0.7;
    m.shininess = shininess;
    SceneDescription scene = empty_scene();
    add(scene, PlaneShape{}, m);
    const double a = degrees * pi / 180;
    const Vec3 out(std::sin(a), 0, std::cos(a));
    add_light(scene, out * 2.0);
    const Look seen = look(scene, out, -out);
    return seen.light.x / (0.7 * std::cos(a) / 4);
}

/// The same with the eye on the normal and the light alone turned: h turns half as far.
double lobe_of_turned_light(double shininess, double degrees) {
    Material m = black();
    m.highlight = 0.7;
    m.shininess = shininess;
    SceneDescription scene = empty_scene();
    add(scene, PlaneShape{}, m);
    const double a = degrees * pi / 180;
    add_light(scene, Vec3(2 * std::sin(a), 0, 2 * std::cos(a)));
    const Look seen = look(scene, Vec3(0, 0, 1), Vec3(0, 0, -1));
    return seen.light.x / (0.7 * std::cos(a) / 4);
}

/// The angle in degrees at which a falling lobe is half its peak.
double half_angle(const std::function<double(double)>& lobe_at) {
    double low = 0, high = 89;
    for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        (lobe_at(middle) > 0.5 ? low : high) = middle;
    }
    return low;
}

TEST(G6, TheHighlightPeaksAtItsStrengthWhereTheHalfVectorIsTheNormal) {
    for (double n : {1.0, 5.0, 10.0, 50.0, 100.0, 1000.0}) expect_relative(lobe(n, 0), 1, 1e-5);
}

TEST(G6, TheHighlightIsHalfAtTheAngleOfItsExponent) {
    const double exponents[] = {1, 5, 10, 50, 100, 1000};
    const double degrees[] = {60, 29.4773, 21.0874, 9.5183, 6.7383, 2.1330};
    for (int i = 0; i < 6; ++i) {
        const double n = exponents[i];
        EXPECT_NEAR(half_angle([&](double a) { return lobe(n, a); }), degrees[i], 0.01) << n;
    }
}

TEST(G6, TurningTheLightAloneNeedsTwiceTheAngle) {
    const double exponents[] = {5, 10, 50, 100, 1000};
    const double degrees[] = {29.4773, 21.0874, 9.5183, 6.7383, 2.1330};
    for (int i = 0; i < 5; ++i) {
        const double n = exponents[i];
        EXPECT_NEAR(half_angle([&](double a) { return lobe_of_turned_light(n, a); }), 2 * degrees[i], 0.02)
            << n;
    }
}

} // namespace
} // namespace glint
