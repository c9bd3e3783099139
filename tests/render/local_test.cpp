// What a surface shows of the lights: ambient, diffuse and highlight, clamp, emission (docs/light-model.md).

#include "scene_kit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace glint::rendering {
namespace {

using namespace kit;

/// A floor at z = 0 of this material, seen from above its origin, one unit high.
SceneDescription floor_scene(const Material& material) {
    SceneDescription scene = empty_scene();
    add(scene, PlaneShape{}, material);
    return scene;
}

Look from_above(const SceneDescription& scene) { return look(scene, Vec3(0, 0, 1), Vec3(0, 0, -1)); }

void expect_color(const vec3& value, const Vec3& expected) {
    for (int c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(value[c], static_cast<float>(expected[c])) << "channel " << c;
}

TEST(Ambient, IsAProductOfLightColourAndCoefficient) {
    Material m = black();
    m.color = Vec3(0.5, 0.25, 1);
    m.ambient = 0.5;
    SceneDescription scene = floor_scene(m);
    add_ambient(scene, Vec3(0.4, 0.8, 0.2));
    expect_color(from_above(scene).terms[Term::ambient], Vec3(0.1, 0.1, 0.1));
}

TEST(Ambient, ShowsWhereDiffuseIsZero) {
    Material m;
    m.color = Vec3(1);
    m.diffuse = 0;
    SceneDescription scene = floor_scene(m);
    add_ambient(scene, Vec3(0.3));
    add_light(scene, Vec3(0, 0, 2));
    expect_color(from_above(scene).light, Vec3(0.3));
}

TEST(Ambient, LightsAddUp) {
    SceneDescription scene = floor_scene(Material{});
    add_ambient(scene, Vec3(0.1, 0.2, 0.3));
    add_ambient(scene, Vec3(0.4, 0.3, 0.2));
    expect_color(from_above(scene).light, Vec3(0.5) * 0.8);
}

TEST(Diffuse, IsLightTimesColourTimesCoefficient) {
    Material m = black();
    m.color = Vec3(0.5, 1, 0.25);
    m.diffuse = 0.5;
    SceneDescription scene = floor_scene(m);
    add_light(scene, Vec3(0, 0, 2), 8, Vec3(1, 0.5, 0.25));
    expect_color(from_above(scene).terms[Term::diffuse], Vec3(0.5, 0.5, 0.0625));
}

TEST(Diffuse, IntensityOneShowsOneAtDistanceOne) {
    SceneDescription scene = floor_scene(matte());
    add_light(scene, Vec3(0, 0, 1));
    expect_color(look(scene, Vec3(0.3, 0, 0.7), Vec3(-0.3, 0, -0.7)).light, Vec3(1));
}

TEST(Diffuse, LightFromBelowTheSurfaceAddsNothing) {
    SceneDescription scene = floor_scene(matte());
    add_light(scene, Vec3(0, 0, -2));
    EXPECT_EQ(from_above(scene).light, vec3(0.0f));
}

TEST(Diffuse, BothSidesOfAPlaneAreLit) {
    SceneDescription scene = floor_scene(matte());
    add_light(scene, Vec3(0, 0, -2));
    expect_color(look(scene, Vec3(0, 0, -1), Vec3(0, 0, 1)).light, Vec3(0.25));
}

TEST(Diffuse, ALightAtTheHitItselfAddsNothing) {
    Material m = matte();
    m.highlight = 1;
    SceneDescription scene = floor_scene(m);
    add_light(scene, Vec3(0, 0, 0));
    const Look seen = from_above(scene);
    EXPECT_EQ(seen.node(0).position, vec3(0.0f));
    EXPECT_EQ(seen.light, vec3(0.0f));
}

/// A wall of one triangle at x = 0 that fills the view, its vertex normals all leaning by `lean`.
SceneDescription leaning_normals(const Vec3& lean) {
    Mesh mesh;
    mesh.positions = {{0, -9, -9}, {0, 9, -9}, {0, 0, 9}};
    mesh.normals.assign(3, glm::vec3(lean));
    mesh.triangles = {{0, 1, 2}};
    SceneDescription scene = empty_scene();
    add(scene, mesh_of(mesh), matte());
    return scene;
}

TEST(Diffuse, TheShadingNormalDecidesTheCosine) {
    SceneDescription scene = leaning_normals(Vec3(0.8, 0.6, 0));
    add_light(scene, Vec3(1, 0, 0));
    EXPECT_FLOAT_EQ(look(scene, Vec3(2, 0.1, 0), Vec3(-2, -0.1, 0)).light.x, 0.8f);
}

TEST(Diffuse, TheShadingNormalIsTurnedToTheSideOfTheViewer) {
    SceneDescription scene = leaning_normals(Vec3(-0.8, -0.6, 0));
    add_light(scene, Vec3(1, 0, 0));
    EXPECT_FLOAT_EQ(look(scene, Vec3(2, 0.1, 0), Vec3(-2, -0.1, 0)).light.x, 0.8f);
}

TEST(Diffuse, LightBelowTheGeometricHorizonAddsNothing) {
    SceneDescription scene = leaning_normals(Vec3(0.1, 1, 0));
    add_light(scene, Vec3(-0.5, 4, 0));
    const Look seen = look(scene, Vec3(2, 0, 0), Vec3(-1, 0, 0));
    EXPECT_GT(dot(seen.node(0).shading_normal, vec3(-0.5f, 4, 0)), 0);
    EXPECT_EQ(seen.light, vec3(0.0f));
}

TEST(Diffuse, VertexColoursReplaceTheMaterials) {
    Mesh mesh;
    mesh.positions = {{0, -9, -9}, {0, 9, -9}, {0, 0, 9}};
    mesh.colors = {{1, 0, 0}, {1, 0, 0}, {0, 0.5, 0.25}};
    mesh.triangles = {{0, 1, 2}};
    SceneDescription scene = empty_scene();
    add(scene, mesh_of(mesh), matte());
    add_light(scene, Vec3(1, 0, 0));
    expect_color(look(scene, Vec3(2, 0, 0), Vec3(-1, 0, 0)).light, Vec3(0.5, 0.25, 0.125));
    std::get<MeshShape>(scene.objects[0].shape).vertex_colors = VertexColors::ignore;
    expect_color(look(scene, Vec3(2, 0, 0), Vec3(-1, 0, 0)).light, Vec3(1));
}

// ── Other lights

TEST(DirectionalLight, ArrivesWithTheCosineFromAnyDistance) {
    SceneDescription scene = floor_scene(matte());
    DirectionalLight sun;
    sun.direction = Vec3(3, 0, -4);
    sun.irradiance = 2;
    sun.color = Vec3(1, 0.5, 0);
    scene.lights.push_back({sun, {}});
    expect_color(from_above(scene).light, Vec3(1.6, 0.8, 0));
    expect_color(look(scene, Vec3(1e6, 0, 1), Vec3(0, 0, -1)).light, Vec3(1.6, 0.8, 0));
}

/// What a floor shows of a spot light straight above, `degrees` off its axis, relative to a point light.
double spot_share(double degrees, double angle, double blend) {
    SceneDescription scene = floor_scene(matte());
    SceneDescription plain = scene;
    SpotLight spot;
    spot.position = Vec3(0, 0, 1);
    spot.angle = angle;
    spot.blend = blend;
    scene.lights.push_back({spot, {}});
    add_light(plain, spot.position);
    const double x = std::tan(degrees * pi / 180);
    const Vec3 eye(x + 0.2, 0, 1);
    const Vec3 down(-0.2, 0, -1);
    const double base = look(plain, eye, down).light.x;
    return look(scene, eye, down).light.x / base;
}

double smoothstep_in_cosine(double degrees, double outer, double inner) {
    const auto c = [](double a) { return std::cos(a * pi / 180); };
    const double x = (c(degrees) - c(outer)) / (c(inner) - c(outer));
    return x <= 0 ? 0 : x >= 1 ? 1 : x * x * (3 - 2 * x);
}

TEST(SpotLight, FallsSmoothlyInTheCosineBetweenItsCones) {
    for (const double degrees : {5.0, 14.9, 15.5, 20.0, 25.0, 29.9, 30.1, 50.0})
        EXPECT_NEAR(spot_share(degrees, 30, 0.5), smoothstep_in_cosine(degrees, 30, 15), 1e-5) << degrees;
}

TEST(SpotLight, BlendZeroEndsSharply) {
    EXPECT_EQ(spot_share(29.99, 30, 0), 1);
    EXPECT_EQ(spot_share(30.01, 30, 0), 0);
}

TEST(SpotLight, BlendOneFallsFromTheAxis) {
    EXPECT_NEAR(spot_share(0, 30, 1), 1, 1e-6);
    for (const double degrees : {1.0, 10.0, 20.0})
        EXPECT_NEAR(spot_share(degrees, 30, 1), smoothstep_in_cosine(degrees, 30, 0), 2e-5) << degrees;
}

TEST(SpotLight, NinetyDegreesLightAHalfSpace) {
    EXPECT_EQ(spot_share(89, 90, 0), 1);
    for (const double degrees : {30.0, 60.0, 85.0})
        EXPECT_NEAR(spot_share(degrees, 90, 1), smoothstep_in_cosine(degrees, 90, 0), 1e-5) << degrees;
    SceneDescription scene = floor_scene(matte());
    SpotLight up;
    up.position = Vec3(0, 0, 1);
    up.direction = Vec3(0, 0, 1);
    up.angle = 90;
    up.blend = 0;
    scene.lights.push_back({up, {}});
    EXPECT_EQ(look(scene, Vec3(3, 0, 1), Vec3(0, 0, -1)).light, vec3(0.0f));
}

// ── Highlight

Material polished(double highlight, double shininess) {
    Material m = black();
    m.highlight = highlight;
    m.shininess = shininess;
    return m;
}

TEST(Highlight, HasTheLightsColourNotTheMaterials) {
    Material m = polished(0.5, 3);
    m.color = Vec3(0, 1, 0);
    SceneDescription scene = floor_scene(m);
    add_light(scene, Vec3(0, 0, 2), 4, Vec3(1, 0.5, 0.25));
    expect_color(from_above(scene).light, Vec3(0.5, 0.25, 0.125));
}

TEST(Highlight, CarriesTheLightThatArrives) {
    // Eye and light mirror each other about the normal, so that the lobe is 1 and cosine and distance remain.
    SceneDescription scene = floor_scene(polished(1, 10));
    add_light(scene, Vec3(3, 0, 4));
    EXPECT_NEAR(look(scene, Vec3(-3, 0, 4), Vec3(3, 0, -4)).light.x, 0.8 / 25, 0.8 / 25 * 3e-6);
}

TEST(Highlight, BlinnUsesTheHalfVectorAndPhongTheMirrorDirection) {
    SceneDescription scene = floor_scene(polished(1, 2));
    add_light(scene, Vec3(3, 0, 4));
    const double arriving = 0.8 / 25;
    const double half = (1 + 0.8) / std::sqrt(0.36 + 3.24);
    EXPECT_NEAR(from_above(scene).light.x, arriving * half * half, 1e-7);
    scene.whitted.highlight_model = HighlightModel::phong;
    EXPECT_NEAR(from_above(scene).light.x, arriving * 0.64, 1e-7);
}

TEST(Highlight, PhongsLobeEndsWhereTheMirrorDirectionTurnsAway) {
    SceneDescription scene = floor_scene(polished(1, 2));
    add_light(scene, Vec3(4, 0, 1));
    scene.whitted.highlight_model = HighlightModel::phong;
    EXPECT_EQ(look(scene, Vec3(4, 0, 1), Vec3(-4, 0, -1)).light.x, 0);
    EXPECT_GT(look(scene, Vec3(-4, 0, 1), Vec3(4, 0, -1)).light.x, 0);
}

TEST(Highlight, ZeroToThePowerZeroIsOne) {
    SceneDescription scene = floor_scene(polished(1, 0));
    add_light(scene, Vec3(4, 0, 1));
    scene.whitted.highlight_model = HighlightModel::phong;
    const Look seen = look(scene, Vec3(4, 0, 1), Vec3(-4, 0, -1));
    EXPECT_FLOAT_EQ(seen.light.x, seen.node(0).lights.at(0).arriving.x);
    EXPECT_GT(seen.light.x, 0);
}

TEST(Highlight, IsSkippedWhereItsStrengthIsZero) {
    SceneDescription scene = floor_scene(polished(0, 0));
    add_light(scene, Vec3(0, 0, 2));
    const Look seen = from_above(scene);
    EXPECT_EQ(seen.terms[Term::highlight], vec3(0.0f));
    EXPECT_EQ(seen.counts.shadow, 0u);
}

TEST(Highlight, NeverExceedsItsStrengthHoweverSharp) {
    SceneDescription scene = empty_scene();
    add(scene, PlaneShape{Vec3(0.3, 0.2, 1), 0}, polished(1, 1e9));
    for (unsigned i = 0; i < 200; ++i) {
        const Vec3 n = glm::normalize(Vec3(0.3, 0.2, 1));
        const Vec3 side = Vec3(rotation(i)[0]) * 0.2;
        const Vec3 in = glm::normalize(n + side);
        SceneDescription lit = scene;
        add_light(lit, in * 2.0);
        const Look seen = look(lit, n * (2 * glm::dot(n, in)) - in, in - n * (2 * glm::dot(n, in)));
        const LightNode& light = seen.node(0).lights.at(0);
        EXPECT_LE(light.highlight.x, light.arriving.x);
    }
}

// ── Clamp

TEST(Clamp, LimitsEachLightsDiffuseTermThenTheSum) {
    Material m = polished(0.25, 1);
    m.color = Vec3(1);
    m.ambient = 0.5;
    m.diffuse = 1;
    SceneDescription scene = floor_scene(m);
    scene.whitted.clamp = true;
    add_ambient(scene, Vec3(0.5));
    add_light(scene, Vec3(0, 0, 1), 3);
    add_light(scene, Vec3(0, 0, 1), 0.5);
    const Look seen = from_above(scene);
    expect_color(seen.terms[Term::ambient], Vec3(0.25));
    expect_color(seen.terms[Term::diffuse], Vec3(1.5));
    expect_color(seen.terms[Term::highlight], Vec3(0.875));
    expect_color(seen.terms[Term::clamp], Vec3(-1.625));
    EXPECT_EQ(seen.light, vec3(1.0f));
}

TEST(Clamp, WorksOnEachChannelAlone) {
    SceneDescription scene = floor_scene(matte());
    scene.whitted.clamp = true;
    add_light(scene, Vec3(0, 0, 1), 1, Vec3(4, 0.5, 1));
    expect_color(from_above(scene).light, Vec3(1, 0.5, 1));
}

TEST(Clamp, ComesAfterTheShadow) {
    SceneDescription scene = floor_scene(matte());
    scene.whitted.clamp = true;
    add(scene, PlaneShape{Vec3(0, 0, 1), 1.5}, glass(1, 0.25));
    add_light(scene, Vec3(0, 0, 2), 12);
    expect_color(from_above(scene).light, Vec3(0.75));
}

TEST(Clamp, LeavesReflectionAndTransmissionUnlimited) {
    Material m = matte();
    m.reflectivity = 0.5;
    SceneDescription scene = floor_scene(m);
    scene.whitted.clamp = true;
    scene.render.background = Vec3(4);
    add_light(scene, Vec3(0, 0, 2), 100);
    expect_color(from_above(scene).light, Vec3(3));
}

TEST(Clamp, GivesExactlyOneForStrongLight) {
    Material m = polished(1, 1);
    m.ambient = 1;
    m.color = Vec3(1);
    for (const double strength : {1.3, 17.7, 1234.5, 1e6, 1e9, 1e20, 1e38}) {
        SceneDescription scene = floor_scene(m);
        scene.whitted.clamp = true;
        add_light(scene, Vec3(0, 0, 1), strength);
        EXPECT_EQ(from_above(scene).light, vec3(1.0f)) << strength;
    }
}

TEST(Clamp, OffLeavesLightUnbounded) {
    SceneDescription scene = floor_scene(matte());
    add_light(scene, Vec3(0, 0, 1), 50);
    expect_color(from_above(scene).light, Vec3(50));
}

// ── Emission, background, weights

TEST(Emission, IsSeenFromFrontAndBack) {
    SceneDescription scene = floor_scene(lamp(Vec3(3, 2, 1)));
    EXPECT_EQ(from_above(scene).light, vec3(3, 2, 1));
    EXPECT_EQ(look(scene, Vec3(0, 0, -1), Vec3(0, 0, 1)).light, vec3(3, 2, 1));
}

TEST(Emission, IsNotScaledByWhatGoesThrough) {
    Material m = glass(1, 0.75);
    m.emission = Vec3(2);
    EXPECT_EQ(from_above(floor_scene(m)).light, vec3(2.0f));
}

TEST(Background, IsSeenWhereNothingIsHit) {
    SceneDescription scene = floor_scene(matte());
    scene.render.background = Vec3(0.1, 0.2, 0.3);
    const Look seen = look(scene, Vec3(0, 0, 1), Vec3(0, 0, 1));
    expect_color(seen.light, Vec3(0.1, 0.2, 0.3));
    EXPECT_EQ(seen.node(0).end, RayEnd::background);
    EXPECT_FALSE(static_cast<bool>(seen.node(0).hit));
}

TEST(LocalWeight, IsOneMinusTransparencyWhereTheBounceIsFollowed) {
    Material m = matte();
    m.highlight = 1;
    m.ambient = 1;
    m.transparency = 0.75;
    SceneDescription scene = floor_scene(m);
    add_light(scene, Vec3(0, 0, 2), 4);
    add_ambient(scene, Vec3(0.5));
    const Look seen = from_above(scene);
    expect_color(seen.terms[Term::ambient], Vec3(0.125));
    expect_color(seen.terms[Term::diffuse], Vec3(0.25));
    expect_color(seen.terms[Term::highlight], Vec3(0.25));
}

TEST(LocalWeight, IsWholeAtTheDepthLimit) {
    Material m = matte();
    m.transparency = 0.75;
    m.reflectivity = 0.25;
    for (const Energy energy : {Energy::report, Energy::balanced}) {
        SceneDescription scene = floor_scene(m);
        scene.whitted.energy = energy;
        scene.whitted.max_depth = 0;
        scene.render.background = Vec3(9);
        add_light(scene, Vec3(0, 0, 2), 4);
        const Look seen = from_above(scene);
        EXPECT_EQ(seen.light, vec3(1.0f));
        EXPECT_EQ(seen.node(0).end, RayEnd::depth_limit);
        EXPECT_EQ(seen.tree.nodes.size(), 1u);
    }
}

TEST(LocalWeight, IsNotScaledByReflectivityInTheReport) {
    Material m = matte();
    m.reflectivity = 0.75;
    SceneDescription scene = floor_scene(m);
    add_light(scene, Vec3(0, 0, 2), 4);
    EXPECT_EQ(from_above(scene).light, vec3(1.0f));
}

TEST(LocalWeight, BalancedEnergyKeepsWhatIsNeitherReflectedNorTransmitted) {
    Material m = matte();
    m.reflectivity = 0.25;
    m.transparency = 0.5;
    SceneDescription scene = floor_scene(m);
    scene.whitted.energy = Energy::balanced;
    add_light(scene, Vec3(0, 0, 2), 4);
    EXPECT_EQ(from_above(scene).light, vec3(0.25f));
    // In a furnace of light 1, nothing is gained or lost.
    scene.lights.clear();
    add_ambient(scene, Vec3(1));
    scene.materials[0].ambient = 1;
    scene.render.background = Vec3(1);
    EXPECT_EQ(from_above(scene).light, vec3(1.0f));
}

} // namespace
} // namespace glint::rendering
