// Path tracing against closed forms, the simplest path tracer, and Whitted's model.

#include "path_kit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace glint::rendering {
namespace {

using namespace kit;

/// Radiance of one camera ray, by many samples; the mean over the channels.
double radiance(const SceneDescription& scene, int count, const vec3& origin, const vec3& direction) {
    const Scene built = build_scene(scene);
    Estimator estimator = make_estimator(built.data(), Aov::final, nullptr, {});
    std::vector<CameraSample> batch;
    for (int i = 0; i < count; ++i) {
        batch.push_back(camera_ray(origin, direction));
        batch.back().index = static_cast<std::uint32_t>(i);
    }
    std::vector<Channels> out(batch.size());
    estimate(estimator, batch, out, false);
    double sum = 0;
    for (const Channels& channels : out) sum += dot(channels.radiance, vec3(1.0f / 3));
    return sum / count;
}

/// As seen by the scene's camera.
double radiance(const SceneDescription& scene, int count) {
    return radiance(scene, count, vec3(scene.camera->eye), normalize(vec3(scene.camera->direction)));
}

struct Mean {
    double value = 0;
    double error = 0; ///< standard error
};

/// The mean over the picture, and its error by the scatter between seeds.
Mean picture_mean(SceneDescription scene, Integrator integrator, int seeds) {
    scene.render.integrator = integrator;
    std::vector<double> means;
    for (int seed = 0; seed < seeds; ++seed) {
        scene.render.seed = static_cast<std::uint64_t>(seed + 1);
        const Image image = rendered(scene).image;
        double sum = 0;
        for (const float v : image.pixels) sum += v;
        means.push_back(sum / static_cast<double>(image.pixels.size()));
    }
    Mean mean;
    for (const double m : means) mean.value += m / seeds;
    for (const double m : means) mean.error += (m - mean.value) * (m - mean.value);
    mean.error = std::sqrt(mean.error / (seeds * (seeds - 1.0)));
    return mean;
}

void expect_same(const Mean& a, const Mean& b, const std::string& what) {
    const double error = std::sqrt(a.error * a.error + b.error * b.error);
    EXPECT_NEAR(a.value, b.value, 4 * error + 1e-6) << what;
    EXPECT_LT(error, 0.04 * std::abs(b.value) + 1e-6) << what << ": too noisy to tell";
}

constexpr Integrator all_integrators[] = {Integrator::path, Integrator::path_simple};

// ── Skies and cavities ──

TEST(G7, AConvexDiffuseObjectUnderAUniformSkyShowsItsAlbedo) {
    for (const Integrator integrator : all_integrators)
        for (const double albedo : {0.25, 1.0}) {
            SceneDescription scene = in_sky();
            scene.render.integrator = integrator;
            add(scene, SphereShape{Vec3(0, 5, 0), 1.5}, matte(albedo));
            EXPECT_NEAR(radiance(scene, 256), albedo, 1e-4 * albedo);
        }
}

/// Emission 1 and ρ = 1/2: 1, 3/2, 7/4 … after 0, 1, 2 … bounces, of which the last is one more than
/// max_depth.
TEST(G7b, AnEmittingCavityAddsOneTermForEachBounce) {
    for (const Integrator integrator : all_integrators)
        for (const auto& [depth, expected] :
             {std::pair{0, 1.5}, std::pair{1, 1.75}, std::pair{2, 1.875}, std::pair{40, 2.0}}) {
            SceneDescription scene = path_scene();
            scene.render.integrator = integrator;
            scene.path.max_depth = depth;
            Material wall = matte(0.5);
            wall.emission = Vec3(1);
            add(scene, SphereShape{}, wall);
            EXPECT_NEAR(radiance(scene, 4096), expected, 4e-3) << depth;
        }
}

TEST(G7b, ALightInTheMiddleOfACavityIsReflectedOnceForEachBounce) {
    for (const Integrator integrator : all_integrators)
        for (const auto& [depth, expected] : {std::pair{0, 0.5}, std::pair{1, 0.75}, std::pair{2, 0.875}}) {
            SceneDescription scene = path_scene(Vec3(0, 0.5, 0));
            scene.render.integrator = integrator;
            scene.path.max_depth = depth;
            add(scene, SphereShape{}, matte(0.5));
            add_light(scene, Vec3(0), 1);
            EXPECT_NEAR(radiance(scene, 256), expected, 1e-4) << depth;
        }
}

TEST(Path, AMirrorAtDepthZeroShowsWhatEmitsAndTheBackground) {
    SceneDescription scene = path_scene();
    scene.render.background = Vec3(0.25);
    scene.path.max_depth = 0;
    add(scene, PlaneShape{Vec3(0, 1, 0), 2}, mirror(0.5));
    EXPECT_NEAR(radiance(scene, 16), 0.125, 1e-6);
    add(scene, PlaneShape{Vec3(0, 1, 0), -2}, lamp(Vec3(3)));
    EXPECT_NEAR(radiance(scene, 16), 1.5, 1e-6);
    add(scene, PlaneShape{Vec3(0, 1, 0), -1}, mirror(1));
    EXPECT_EQ(radiance(scene, 16), 0);
}

TEST(Path, DiffuseBouncesAreLimitedAlone) {
    // A mirror shows a wall that is lit by a lamp, and by light from a second wall.
    SceneDescription scene = path_scene(Vec3(0), Vec3(1, 0, 0));
    add(scene, PlaneShape{Vec3(1, 0, 0), 1}, mirror(1));
    add(scene, PlaneShape{Vec3(1, 0, 0), -1}, matte(0.5));
    add_light(scene, Vec3(0, 0.5, 0), 1);
    const double whole = radiance(scene, 4096);
    scene.render.integrator = Integrator::direct;
    const double direct = radiance(scene, 4096);
    scene.render.integrator = Integrator::path;
    scene.path.max_diffuse_bounces = 0;
    EXPECT_EQ(radiance(scene, 4096), direct);
    EXPECT_LT(direct, 0.97 * whole);
    EXPECT_NEAR(direct, 0.5 / std::pow(1.25, 1.5), 1e-3); // cos θ / r²
}

// ── Lamps of some size ──

/// Radiance · 1 of the square of G8 above a white receiver, which shows E / π.
SceneDescription under_square(const Vec3& point, const Vec3& normal) {
    const Vec3 n = glm::normalize(normal);
    SceneDescription scene = path_scene(point + n * 0.01, -n);
    add(scene, PlaneShape{n, glm::dot(n, point)}, matte(1));
    add(scene, RectangleShape{Vec3(-0.5, -0.5, 1), Vec3(1, 0, 0), Vec3(0, 1, 0)}, lamp(Vec3(1)));
    return scene;
}

struct Receiver {
    Vec3 point;
    Vec3 normal;
    double irradiance;
};

TEST(G8, ASquareLampGivesItsIrradiance) {
    const Receiver receivers[] = {
        {Vec3(0), Vec3(0, 0, 1), 0.7522747},        {Vec3(0.5, 0.5, 0), Vec3(0, 0, 1), 0.4352099},
        {Vec3(2, 0, 0), Vec3(0, 0, 1), 0.0437426},  {Vec3(2, 0, 0), Vec3(-1, 0, 1), 0.0888323},
        {Vec3(1, 0, 0), Vec3(-1, 0, 0), 0.2260633}, {Vec3(0), Vec3(1, 0, 0), 0.0875103}};
    for (const Receiver& r : receivers) {
        SceneDescription scene = under_square(r.point, r.normal);
        scene.path.max_depth = 0;
        EXPECT_NEAR(pi * radiance(scene, 16384), r.irradiance, 1e-3 * r.irradiance);
        scene.render.integrator = Integrator::path_simple;
        EXPECT_NEAR(pi * radiance(scene, 16384), r.irradiance, 0.04 * r.irradiance);
    }
}

TEST(G8c, ADiskAndASphereGiveTheirIrradiance) {
    SceneDescription disk = path_scene(Vec3(0, 0, 0.01), Vec3(0, 0, -1));
    add(disk, PlaneShape{}, matte(1));
    SceneDescription sphere = disk;
    add(disk, DiskShape{Vec3(0, 0, 2), Vec3(0, 0, 1), 1}, lamp(Vec3(1)));
    add(sphere, SphereShape{Vec3(0, 0, 4), 1}, lamp(Vec3(1)));
    for (SceneDescription* scene : {&disk, &sphere}) {
        const double expected = scene == &disk ? 0.2 : 0.0625;
        scene->path.max_depth = 0;
        EXPECT_NEAR(radiance(*scene, 16384), expected, 1e-3 * expected);
        scene->render.integrator = Integrator::path_simple;
        EXPECT_NEAR(radiance(*scene, 16384), expected, 0.04 * expected);
    }
}

/// Mean over a unit square of E / (π L) from another.
double mean_between_squares(const RectangleShape& receiver, const RectangleShape& lamp_shape) {
    SceneDescription scene = path_scene();
    scene.path.max_depth = 0;
    add(scene, receiver, matte(1));
    add(scene, lamp_shape, lamp(Vec3(1)));
    const Scene built = build_scene(scene);
    Estimator estimator = make_estimator(built.data(), Aov::final, nullptr, {});
    const Vec3 n = glm::cross(receiver.u, receiver.v);
    constexpr int side = 64, drawn = 16;
    double sum = 0;
    std::vector<CameraSample> batch(drawn);
    std::vector<Channels> out(drawn);
    for (int i = 0; i < side * side; ++i) {
        const Vec3 p =
            receiver.corner + receiver.u * ((i % side + 0.5) / side) + receiver.v * ((i / side + 0.5) / side);
        for (int k = 0; k < drawn; ++k) {
            CameraSample& sample = batch[static_cast<std::size_t>(k)];
            sample = camera_ray(vec3(p + n * 1e-3), vec3(-n));
            sample.pixel = {i % side, i / side};
            sample.index = static_cast<std::uint32_t>(k);
        }
        estimate(estimator, batch, out, false);
        for (const Channels& channels : out) sum += static_cast<double>(channels.radiance.x);
    }
    return sum / (side * side * drawn);
}

TEST(G9, SquaresExchangeLightByTheirFormFactors) {
    const RectangleShape floor{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    EXPECT_NEAR(mean_between_squares(floor, {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 1, 0)}), 0.1998249, 2e-4);
    EXPECT_NEAR(mean_between_squares(floor, {Vec3(0), Vec3(0, 1, 0), Vec3(0, 0, 1)}), 0.2000438, 2e-4);
}

/// A sphere about the origin in two meshes: a cap about +z, and the rest.
struct CutSphere {
    Mesh cap, rest;
    double share = 0; ///< of the cap in the area
};

CutSphere cut_sphere(unsigned rings, unsigned cap_rings) {
    CutSphere cut;
    cut.cap = cut.rest = sphere_mesh(1, rings);
    cut.cap.triangles.clear();
    cut.rest.triangles.clear();
    double area[2] = {};
    for (const glm::uvec3& t : sphere_mesh(1, rings).triangles) {
        const std::vector<glm::vec3>& p = cut.cap.positions;
        const bool in_cap = std::min({t.x, t.y, t.z}) < cap_rings * 2 * rings;
        (in_cap ? cut.cap : cut.rest).triangles.push_back(t);
        area[in_cap ? 0 : 1] += static_cast<double>(length(cross(p[t.y] - p[t.x], p[t.z] - p[t.x])));
    }
    cut.share = area[0] / (area[0] + area[1]);
    return cut;
}

/// Every point of a sphere sees the cap by its share f of the area: ρ f + ρ f ρ (1 − f) + …
TEST(G7c, ACapLightsASphereAlikeEverywhere) {
    const CutSphere cut = cut_sphere(64, 9);
    const double f = cut.share;
    EXPECT_NEAR(f, 0.048, 1e-3);
    for (const double albedo : {0.5, 0.8}) {
        SceneDescription scene = path_scene(Vec3(0, 0, 0), Vec3(0.3, 0.9, -0.2));
        add(scene, mesh_of(cut.cap), lamp(Vec3(1)));
        add(scene, mesh_of(cut.rest), matte(albedo));
        double expected = 0, order = albedo * f;
        for (int depth = 0; depth < 4; ++depth) {
            scene.path.max_depth = depth;
            expected += order;
            order *= albedo * (1 - f);
            EXPECT_NEAR(radiance(scene, 4096), expected, 0.015 * expected) << depth;
        }
        scene.path.max_depth = 100;
        EXPECT_NEAR(radiance(scene, 8192), albedo * f / (1 - albedo * (1 - f)), 0.02 * expected);
    }
}

/// By how much errors fall when samples double, as a power of their number.
TEST(G20, ErrorsFallFasterThanThoseOfRandomNumbers) {
    SceneDescription scene = under_square(Vec3(2, 0, 0), Vec3(-1, 0, 1));
    scene.path.max_depth = 0;
    const auto error = [&](int count) {
        double squares = 0;
        for (int seed = 0; seed < 32; ++seed) {
            scene.render.seed = static_cast<std::uint64_t>(seed);
            squares += std::pow(pi * radiance(scene, count) / 0.0888323 - 1, 2) / 32;
        }
        return std::sqrt(squares);
    };
    const double slope = std::log2(error(2048) / error(32)) / 6;
    EXPECT_LT(slope, -0.6);
}

// ── The same light in several ways ──

TEST(Path, TheSimplestPathTracerFindsTheSameLight) {
    expect_same(picture_mean(room(), Integrator::path, 8), picture_mean(room(), Integrator::path_simple, 12),
                "room");
    SceneDescription bulbs = room();
    bulbs.objects[5].visible = false;
    for (int i = 0; i < 12; ++i)
        add(bulbs, SphereShape{Vec3(0.3 * (i % 4) - 0.5, 0.3 * (i / 4) - 0.5, 1.7), 0.1},
            lamp(Vec3(2, 1 + i, 3)));
    expect_same(picture_mean(bulbs, Integrator::path, 8), picture_mean(bulbs, Integrator::path_simple, 12),
                "bulbs");
}

TEST(Path, RouletteAndChoicesOfLightsChangeNoMean) {
    SceneDescription scene = room();
    add_light(scene, Vec3(0.3, -0.5, 1.5), 0.2);
    const Mean usual = picture_mean(scene, Integrator::path, 8);
    scene.path.roulette_depth = 1;
    expect_same(picture_mean(scene, Integrator::path, 8), usual, "roulette at once");
    for (const LightSampling sampling : {LightSampling::uniform, LightSampling::power}) {
        scene.path.light_sampling = sampling;
        expect_same(picture_mean(scene, Integrator::path, 8), usual, std::string(name_of(sampling)));
    }
}

TEST(Path, WhittedAndDirectLightAgreeOnMatteSurfacesMirrorsAndGlass) {
    SceneDescription scene = room();
    scene.objects[5].visible = false;
    add_light(scene, Vec3(0.3, -0.5, 1.5), 1);
    add_light(scene, Vec3(-0.6, 0.5, 0.3), 0.5);
    scene.whitted.shadows = Shadows::opaque;
    scene.whitted.energy = Energy::balanced;
    scene.whitted.max_depth = 16;
    scene.whitted.min_weight = 0;
    scene.path.max_depth = 16;
    scene.objects.back().visible = false; // a pane: Whitted's opaque shadows are not exact there
    expect_same(picture_mean(scene, Integrator::direct, 12), picture_mean(scene, Integrator::whitted, 12),
                "direct");
}

TEST(Path, CoefficientsOfTheReportShowWhatWhittedShows) {
    SceneDescription scene = empty_scene(Vec3(0, -3, 1), Vec3(0, 1, -0.3), 24, 50);
    Material paint = matte(0.6);
    paint.color = Vec3(0.9, 0.5, 0.2);
    paint.highlight = 0.4;
    paint.shininess = 30;
    add(scene, SphereShape{Vec3(0, 0, 0), 1}, paint);
    add(scene, PlaneShape{Vec3(0, 0, 1), -1}, paint);
    add_light(scene, Vec3(2, -2, 3), 4);
    scene.lights.push_back({DirectionalLight{Vec3(1, 2, -3), Vec3(0.5, 1, 0.5), 0.7}, {}});
    scene.lights.push_back({SpotLight{.position = Vec3(-2, -2, 2), .direction = Vec3(2, 2, -2)}, {}});
    for (const HighlightModel model : {HighlightModel::blinn, HighlightModel::phong}) {
        scene.whitted.highlight_model = model;
        scene.render.integrator = Integrator::whitted;
        const Image expected = rendered(scene).image;
        scene.render.integrator = Integrator::direct;
        const Image image = rendered(scene).image;
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            EXPECT_NEAR(image.pixels[i], expected.pixels[i], 1e-5 * expected.pixels[i] + 1e-7);
    }
}

// ── Shadows ──

TEST(Path, ThinPanesLetTheirShareThroughAndSolidGlassBlocks) {
    SceneDescription scene = path_scene(Vec3(0, 0, 0.5), Vec3(0, 0, -1));
    add(scene, PlaneShape{}, matte(1));
    add_light(scene, Vec3(0, 0, 2), 4);
    scene.path.max_depth = 0;
    const double lit = radiance(scene, 1);
    EXPECT_NEAR(lit, 1, 1e-6);
    SceneDescription pane = scene;
    add(pane, DiskShape{Vec3(0, 0, 1), Vec3(0, 0, 1), 1}, glass(1.5, 0.25));
    EXPECT_NEAR(radiance(pane, 1), 0.25, 1e-6);
    SceneDescription ball = scene;
    add(ball, SphereShape{Vec3(0, 0, 1.2), 0.3}, glass(1.5, 0.5));
    EXPECT_EQ(radiance(ball, 1), 0);
    ball.path.shadows = PathShadows::transmissive;
    EXPECT_NEAR(radiance(ball, 1), 0.25, 1e-6);
}

TEST(Path, TransmissiveShadowsCountNoLightTwice) {
    // Glass of index 1 bends nothing: lamps shine through it alike by shadow rays and by paths.
    SceneDescription scene = path_scene(Vec3(0, 0, 0.2), Vec3(0, 0, -1));
    add(scene, PlaneShape{}, matte(1));
    add(scene, DiskShape{Vec3(0, 0, 2), Vec3(0, 0, 1), 1}, lamp(Vec3(1)));
    add(scene, SphereShape{Vec3(0, 0, 1.2), 0.6}, glass(1, 1));
    for (const PathShadows shadows : {PathShadows::exact, PathShadows::transmissive}) {
        scene.path.shadows = shadows;
        EXPECT_NEAR(radiance(scene, 16384), 0.2, 2e-3);
    }
}

TEST(Path, MediaAbsorbOnTheWayToLights) {
    SceneDescription scene = path_scene(Vec3(0, 0, 1), Vec3(0, 0, -1));
    Material water = glass(1, 1);
    water.absorption = Vec3(0.5);
    add(scene, SphereShape{Vec3(0), 10}, water);
    add(scene, PlaneShape{}, matte(1));
    add_light(scene, Vec3(0, 0, 2), 4);
    EXPECT_NEAR(radiance(scene, 1), std::exp(-0.5 * 3), 1e-5);
}

TEST(Path, IndirectLightIsClampedAndItsLossIsTold) {
    SceneDescription scene = room();
    scene.render.integrator = Integrator::path;
    RenderOptions options;
    options.terms = true;
    const Picture whole = rendered(scene, options);
    EXPECT_EQ(clamped_share(whole.stats), 0);
    scene.path.clamp_indirect = 0.25;
    scene.render.spp = 1;
    const Picture one = rendered(scene, options);
    for (std::size_t i = 0; i < one.image.pixels.size(); ++i)
        EXPECT_LE(one.terms[3].pixels[i] + one.terms[4].pixels[i] + one.terms[5].pixels[i], 0.25001f);
    scene.render.spp = 16;
    const Picture clamped = rendered(scene, options);
    const auto sum = [](const Image& image) {
        double all = 0;
        for (const float v : image.pixels) all += static_cast<double>(v);
        return all;
    };
    EXPECT_EQ(picture_hash(clamped.terms[0]), picture_hash(whole.terms[0]));
    const double share = 1 - sum(clamped.image) / sum(whole.image);
    EXPECT_GT(share, 0.01);
    EXPECT_NEAR(clamped_share(clamped.stats), share, 1e-4);
}

} // namespace
} // namespace glint::rendering
