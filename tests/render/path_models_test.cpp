// Models of materials along paths: what comes back from a whole object in a scene.

#include "scene_kit.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glint::rendering {
namespace {

using namespace kit;

Material of_roughness(MaterialModel model, const Vec3& color, double roughness) {
    Material m;
    m.model = model;
    m.color = color;
    m.roughness = roughness;
    return m;
}

SceneDescription path_traced(SceneDescription scene, int spp, Integrator integrator = Integrator::path) {
    scene.render.integrator = integrator;
    scene.render.spp = spp;
    scene.path.roulette_depth = 1000; // roulette only adds noise
    return scene;
}

double mean_red(const SceneDescription& scene) {
    const Picture picture = rendered(scene);
    double sum = 0;
    const int width = picture.image.width, height = picture.image.height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) sum += static_cast<double>(picture.image.at(x, y)[0]);
    return sum / (width * height);
}

/// The pictures are filled by a ball.
SceneDescription ball_in_sky(const Material& material) {
    SceneDescription scene = empty_scene(Vec3(0, -6, 0), Vec3(0, 1, 0), 16, 12);
    scene.render.background = Vec3(1);
    add(scene, SphereShape{}, material);
    return scene;
}

TEST(PathTracedBall, IsInvisibleInAUniformSkyIfItLosesNothing) {
    for (const MaterialModel model : {MaterialModel::conductor, MaterialModel::dielectric,
                                      MaterialModel::plastic, MaterialModel::diffuse})
        for (const double roughness : {0.0, 0.1, 0.5, 1.0}) {
            if (model == MaterialModel::diffuse && roughness > 0) continue;
            const Material white = of_roughness(model, Vec3(1), roughness);
            // What single scattering loses of a rough coat is not given back.
            if (model == MaterialModel::plastic && roughness > 0.2) continue;
            EXPECT_NEAR(mean_red(path_traced(ball_in_sky(white), 64)), 1, 0.006)
                << name_of(model) << roughness;
        }
}

TEST(PathTracedLamp, ShinesFromItsFrontAlone) {
    for (const bool turned : {false, true}) {
        SceneDescription scene = empty_scene(Vec3(3, 0, 1), Vec3(-3, 0, -1), 8, 20);
        add(scene, PlaneShape{}, of_roughness(MaterialModel::diffuse, Vec3(0.5), 0));
        Material m = lamp(Vec3(5));
        m.emission_sides = EmissionSides::front;
        const Vec3 u(2, 0, 0), v(0, 2, 0); // u × v is up
        add(scene, RectangleShape{Vec3(-1, -1, 2), turned ? v : u, turned ? u : v}, m);
        const double by_lights = mean_red(path_traced(scene, 64));
        const double by_materials = mean_red(path_traced(scene, 256, Integrator::path_simple));
        EXPECT_NEAR(by_lights, by_materials, 0.1 * by_lights);
        EXPECT_EQ(by_lights > 0, turned);
    }
}

TEST(PathTracedOpacity, IsTheShareThatIsThere) {
    Material m = black();
    m.opacity = 0.25;
    SceneDescription scene = in_sky();
    add(scene, PlaneShape{Vec3(0, 1, 0), 1}, m);
    EXPECT_NEAR(mean_red(path_traced(scene, 256)), 0.75, 0.01);

    // It lets the same share of a light through.
    SceneDescription lit = empty_scene(Vec3(3, 0, 1), Vec3(-3, 0, -1), 8, 20);
    add(lit, PlaneShape{}, of_roughness(MaterialModel::diffuse, Vec3(0.5), 0));
    add_light(lit, Vec3(0, 0, 3), 10);
    const double open = mean_red(path_traced(lit, 1, Integrator::direct));
    add(lit, RectangleShape{Vec3(-5, -5, 2), Vec3(10, 0, 0), Vec3(0, 10, 0)}, m);
    EXPECT_NEAR(mean_red(path_traced(lit, 1, Integrator::direct)), 0.75 * open, 1e-5 * open);
}

} // namespace
} // namespace glint::rendering
