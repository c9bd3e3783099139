// The steps of a bounce for one ray (shading/whitted.shared.h).

#include "shading/light_gain.h"
#include "shading/whitted.shared.h"

#include <gtest/gtest.h>

#include <limits>

namespace glint {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
const WhittedModes report{1, 0, 0, highlight_blinn};

/// At the origin, upright, seen from above.
SurfaceRecord ground() {
    SurfaceRecord s{};
    s.n_g = s.n = s.v = vec3(0, 0, 1);
    s.color = vec3(0.5f);
    s.lit_side = 1;
    return s;
}

MaterialRecord matte() {
    MaterialRecord m{};
    m.diffuse = 1;
    m.reflected_tint = m.transmitted_tint = vec3(1);
    m.index = 1.5f;
    return m;
}

LightRecord lamp(int kind) {
    LightRecord light{};
    light.kind = kind;
    light.position = vec3(0, 0, 2);
    light.direction = vec3(0, 0, -1);
    light.strength = vec3(8);
    light.cos_outer = 0.5f;
    light.cos_inner = 0.9f;
    return light;
}

TEST(LightArrivalStep, KnowsTheKindsOfLights) {
    SurfaceRecord s = ground();
    EXPECT_EQ(light_arrival(lamp(light_point), s).arriving, vec3(2));
    EXPECT_EQ(light_arrival(lamp(light_spot), s).arriving, vec3(2));
    EXPECT_EQ(light_arrival(lamp(light_directional), s).arriving, vec3(8));
    EXPECT_EQ(light_arrival(lamp(light_point), s).distance, 2);
    EXPECT_EQ(light_arrival(lamp(light_directional), s).distance, infinity);
    s.p = vec3(20, 0, 0);
    EXPECT_GT(light_arrival(lamp(light_point), s).arriving.x, 0);
    EXPECT_EQ(light_arrival(lamp(light_spot), s).arriving, vec3(0)) << "outside the cone";
    s.lit_side = -1;
    EXPECT_EQ(light_arrival(lamp(light_point), s).arriving, vec3(0)) << "lit from below alone";
}

TEST(ShadowRay, EndsAtALightWithAPosition) {
    const SurfaceRecord s = ground();
    for (const int kind : {light_point, light_spot, light_directional}) {
        const LightRecord light = lamp(kind);
        const SpawnedRay ray = shadow_ray(light, s, light_arrival(light, s));
        EXPECT_GE(ray.origin.z, 0);
        EXPECT_EQ(ray.tmax, kind == light_directional ? infinity : 1);
        const vec3 end = kind == light_directional ? vec3(0, 0, 1) : light.position - ray.origin;
        EXPECT_EQ(ray.direction, end);
    }
}

TEST(ShadowRay, IsSentForLightThatArrivesAndIsShown) {
    SurfaceRecord s = ground();
    MaterialRecord m = matte();
    s.v = normalize(vec3(1, 0, 1));
    const auto is_sent = [&] {
        return is_worth_shadow_ray(WhittedModes{}, s, m, light_arrival(lamp(light_point), s));
    };
    EXPECT_TRUE(is_sent());
    m.diffuse = 0;
    EXPECT_FALSE(is_sent());
    m.highlight = 0.1f;
    m.shininess = 10;
    EXPECT_TRUE(is_sent());
    m.shininess = 1e6f;
    EXPECT_FALSE(is_sent()) << "the highlight is elsewhere";
    m.diffuse = 0.1f;
    EXPECT_TRUE(is_sent());
    s.p.z = 3;
    EXPECT_FALSE(is_sent()) << "the light is below";
}

TEST(ShadowTransmittance, IsTheTransparencyUnlessShadowsAreOpaque) {
    WhittedModes modes = report;
    EXPECT_EQ(shadow_transmittance(modes, 0.7f), 0);
    modes.opaque_shadows = 0;
    EXPECT_EQ(shadow_transmittance(modes, 0.7f), 0.7f);
    EXPECT_EQ(shadow_transmittance(modes, 0), 0);
}

TEST(ShownLightStep, TakesTheShadowThenTheClamp) {
    const SurfaceRecord s = ground();
    MaterialRecord m = matte();
    WhittedModes modes = report;
    const LightArrival arrival = light_arrival(lamp(light_directional), s);
    EXPECT_EQ(shown_light(modes, s, m, arrival, vec3(1)).diffuse, vec3(4));
    EXPECT_EQ(shown_light(modes, s, m, arrival, vec3(0.125f)).diffuse, vec3(0.5f));
    EXPECT_EQ(shown_light(modes, s, m, arrival, vec3(0)).diffuse, vec3(0));
    EXPECT_EQ(shown_light(modes, s, m, arrival, vec3(1)).highlight, vec3(0));
    m.highlight = 0.5f;
    modes.clamp = 1;
    EXPECT_EQ(shown_light(modes, s, m, arrival, vec3(1)).diffuse, vec3(1));
    EXPECT_EQ(shown_light(modes, s, m, arrival, vec3(0.125f)).diffuse, vec3(0.5f));
    EXPECT_EQ(shown_light(modes, s, m, arrival, vec3(1)).highlight, vec3(4)) << "limited with the sum alone";
}

TEST(ShownLightStep, ChoosesTheLobe) {
    SurfaceRecord s = ground();
    s.v = vec3(0.6f, 0, 0.8f);
    MaterialRecord m = matte();
    m.highlight = 1;
    m.shininess = 20;
    WhittedModes modes = report;
    const LightArrival arrival = light_arrival(lamp(light_directional), s);
    const float blinn = shown_light(modes, s, m, arrival, vec3(1)).highlight.x;
    EXPECT_EQ(blinn, 8 * lobe_of(blinn_cosine(s.n, arrival.direction, s.v), 20));
    modes.highlight = highlight_phong;
    EXPECT_EQ(shown_light(modes, s, m, arrival, vec3(1)).highlight.x,
              8 * lobe_of(phong_cosine(s.n, arrival.direction, s.v), 20));
    EXPECT_NE(shown_light(modes, s, m, arrival, vec3(1)).highlight.x, blinn);
    m.reflected_tint = vec3(1, 0.5f, 0.25f);
    const vec3 tinted = shown_light(modes, s, m, arrival, vec3(1)).highlight;
    EXPECT_EQ(tinted.y, 0.5f * tinted.x);
    EXPECT_EQ(tinted.z, 0.25f * tinted.x);
}

TEST(LimitedTerms, SumToOneWhereTheModelClamps) {
    WhittedModes modes = report;
    const LocalTerms local{vec3(0.25f), vec3(1), vec3(1e30f), vec3(0)};
    EXPECT_EQ(limited_terms(modes, local).clamp, vec3(0));
    EXPECT_EQ(limited_terms(modes, local).highlight, vec3(1e30f));
    modes.clamp = 1;
    const LocalTerms limited = limited_terms(modes, local);
    EXPECT_EQ(local_sum(limited) + limited.clamp, vec3(1));
}

TEST(LocalWeight, LeavesRoomForTheMirrorRayWhereEnergyIsBalanced) {
    MaterialRecord m = matte();
    m.reflectivity = 0.5f;
    m.transparency = 0.25f;
    WhittedModes modes = report;
    EXPECT_EQ(local_weight(modes, m), 0.75f);
    modes.balanced = 1;
    EXPECT_EQ(local_weight(modes, m), 0.25f);
}

TEST(LightGain, WeighsDiffuseLightLikeTheEstimator) {
    for (const bool balanced : {false, true})
        for (const float reflectivity : {0.0f, 0.3f, 0.7f})
            for (const float transparency : {0.0f, 0.2f, 0.3f, 0.5f}) {
                const float weight = local_weight(reflectivity, transparency, balanced);
                EXPECT_EQ(shading::light_gain(0.8f, 0.9f, reflectivity, transparency, balanced),
                          weight * 0.8f * 0.9f + reflectivity + transparency);
            }
    EXPECT_DOUBLE_EQ(shading::light_gain(1.0, 1.0, 0.5, 0.0, false), 1.5);
    EXPECT_DOUBLE_EQ(shading::light_gain(1.0, 1.0, 0.5, 0.0, true), 1);
}

TEST(RefractionStep, FallsBackToTheGeometricNormal) {
    SurfaceRecord s = ground();
    EXPECT_EQ(refraction_at(s, 0.5f).n, s.n);
    s.n = vec3(0.96f, 0, -0.28f);
    EXPECT_EQ(refraction_at(s, 0.5f).n, s.n_g) << "the viewer is below the shading normal";
    s.n = vec3(0.96f, 0, 0.28f);
    s.v = vec3(-0.1f, 0, 0.995f);
    EXPECT_EQ(refraction_at(s, 0.01f).n, s.n) << "nearly against the shading normal: below the surface";
    s.v = vec3(-0.28f, 0, 0.96f);
    s.n = normalize(vec3(1, 0, 0.35f));
    const Refraction r = refraction_at(s, 4.0f);
    EXPECT_TRUE(r.total);
    EXPECT_EQ(r.n, s.n);
}

TEST(SplitAtSolid, SharesByFresnelOrAllToTheMirrorRay) {
    MaterialRecord m = matte();
    m.reflectivity = 0.25f;
    m.transparency = 0.5f;
    SurfaceRecord s = ground();
    Split split = split_at_solid(m, refraction_at(s, 1 / 1.5f), 1, 1.5f);
    EXPECT_EQ(split.reflected, 0.25f);
    EXPECT_EQ(split.refracted, 0.5f);
    m.flags = material_fresnel;
    split = split_at_solid(m, refraction_at(s, 1 / 1.5f), 1, 1.5f);
    EXPECT_NEAR(split.reflected, 0.75f * 0.04f, 1e-6f);
    EXPECT_NEAR(split.refracted, 0.75f * 0.96f, 1e-6f);
    s.v = vec3(0.96f, 0, 0.28f);
    split = split_at_solid(m, refraction_at(s, 1.5f), 1.5f, 1);
    EXPECT_EQ(split.reflected, 0.75f);
    EXPECT_EQ(split.refracted, 0);
}

TEST(SplitAtSheet, GoesStraightOn) {
    MaterialRecord m = matte();
    m.transparency = 0.5f;
    SurfaceRecord s = ground();
    s.v = vec3(0.6f, 0, 0.8f);
    const Split split = split_at_sheet(s, m);
    EXPECT_EQ(split.direction, vec3(-0.6f, 0, -0.8f));
    EXPECT_EQ(split.refracted, 0.5f);
    EXPECT_EQ(split.reflected, 0);
}

} // namespace
} // namespace glint
