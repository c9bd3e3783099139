// How Whitted's light model reads the models of materials (docs/light-model.md).

#include "scene_kit.h"

#include <gtest/gtest.h>

namespace glint::rendering {
namespace {

using namespace kit;

/// The ground, lit from above at a distance of 2, seen at an angle.
Look lit_ground(const Material& material, const Vec3& from = Vec3(1, 0, 1)) {
    SceneDescription scene = empty_scene();
    add(scene, PlaneShape{}, material);
    add_light(scene, Vec3(0, 0, 2), 8);
    return look(scene, from, -from);
}

TEST(WhittedReading, OfDiffuseIsACoefficientOf1) {
    EXPECT_EQ(lit_ground(modelled(MaterialModel::diffuse, Vec3(0.5, 0.25, 1))).light, vec3(1, 0.5f, 2));
}

TEST(WhittedReading, OfSmoothMetalIsATintedMirror) {
    SceneDescription scene = in_sky(Vec3(2));
    add(scene, PlaneShape{}, modelled(MaterialModel::conductor, Vec3(1, 0.5, 0.25)));
    const Look seen = look(scene, Vec3(-3, 0, 4), Vec3(3, 0, -4));
    EXPECT_EQ(seen.terms[Term::reflection], vec3(2, 1, 0.5f));
    EXPECT_EQ(seen.light, vec3(2, 1, 0.5f));
}

TEST(WhittedReading, OfNamedMetalHasItsReflectanceAtNormalIncidence) {
    Material silver = modelled(MaterialModel::conductor);
    silver.metal = Metal::silver;
    SceneDescription scene = in_sky();
    add(scene, PlaneShape{}, silver);
    const vec3 light = look(scene, Vec3(0, 0, 1), Vec3(0, 0, -1)).light;
    EXPECT_NEAR(light.x, 0.990, 1e-3);
    EXPECT_NEAR(light.y, 0.983, 1e-3);
    EXPECT_NEAR(light.z, 0.980, 1e-3);
}

TEST(WhittedReading, OfRoughMetalIsATintedHighlight) {
    const Look seen = lit_ground(modelled(MaterialModel::conductor, Vec3(1, 0.5, 0.25), 0.5), Vec3(0, 0, 1));
    // α = 1/4, m = 30; seen from where the light is.
    EXPECT_EQ(seen.terms[Term::highlight], vec3(2, 1, 0.5f));
    EXPECT_EQ(seen.terms[Term::diffuse], vec3(0));
}

TEST(WhittedReading, OfPlasticIsABodyWithAHighlight) {
    const Look seen = lit_ground(modelled(MaterialModel::plastic, Vec3(0.5), 0.5), Vec3(0, 0, 1));
    EXPECT_EQ(seen.terms[Term::diffuse], vec3(1));
    EXPECT_NEAR(seen.terms[Term::highlight].x, 2 * 0.04, 1e-6);
}

TEST(WhittedReading, OfADielectricIsGlassWithItsColorOnceAPaneAndTwiceASolid) {
    SceneDescription pane = in_sky();
    add(pane, PlaneShape{}, modelled(MaterialModel::dielectric, Vec3(0.5, 1, 0.25)));
    EXPECT_EQ(look(pane, Vec3(0, 0, 1), Vec3(0, 0, -1)).light, vec3(0.5f, 1, 0.25f));

    SceneDescription ball = in_sky();
    ball.whitted.max_depth = 2;
    add(ball, SphereShape{}, modelled(MaterialModel::dielectric, Vec3(0.5, 1, 0.25)));
    const vec3 through = look(ball, Vec3(0, -3, 0), Vec3(0, 1, 0)).terms[Term::transmission];
    // What the far side reflects ends inside at this depth.
    EXPECT_NEAR(through.y, 0.96 * 0.96, 1e-5);
    EXPECT_NEAR(through.x / through.y, 0.25, 1e-6);
    EXPECT_NEAR(through.z / through.y, 0.0625, 1e-6);
}

TEST(WhittedReading, GlassThrowsShadowsOfItsColor) {
    SceneDescription scene = empty_scene();
    add(scene, PlaneShape{}, matte());
    add(scene, RectangleShape{Vec3(-9, -9, 1.5), Vec3(18, 0, 0), Vec3(0, 18, 0)},
        modelled(MaterialModel::dielectric, Vec3(0.5, 1, 0.25)));
    add_light(scene, Vec3(0, 0, 2), 8);
    EXPECT_EQ(look(scene, Vec3(1, 0, 1), Vec3(-1, 0, -1)).terms[Term::diffuse], vec3(1, 2, 0.5f));
    scene.whitted.shadows = Shadows::opaque;
    EXPECT_EQ(look(scene, Vec3(1, 0, 1), Vec3(-1, 0, -1)).light, vec3(0));
}

TEST(WhittedReading, OfPrincipledIsTheSumOfItsParts) {
    Material m = modelled(MaterialModel::principled, Vec3(0.5), 0.5);
    EXPECT_EQ(lit_ground(m).terms[Term::diffuse], vec3(1));
    m.metallic = 0.5;
    EXPECT_EQ(lit_ground(m).terms[Term::diffuse], vec3(0.5f));
    m.metallic = 0;
    m.transmission = 0.25;
    EXPECT_NEAR(lit_ground(m).terms[Term::diffuse].x, 0.75, 1e-6);
    SceneDescription scene = in_sky();
    add(scene, PlaneShape{}, m);
    EXPECT_EQ(look(scene, Vec3(0, 0, 1), Vec3(0, 0, -1)).terms[Term::transmission], vec3(0.125f));
}

TEST(Emission, MayComeFromTheFrontAlone) {
    Material m = lamp(Vec3(3));
    for (const EmissionSides sides : {EmissionSides::both, EmissionSides::front}) {
        m.emission_sides = sides;
        SceneDescription scene = empty_scene();
        add(scene, PlaneShape{}, m);
        EXPECT_EQ(look(scene, Vec3(0, 0, 1), Vec3(0, 0, -1)).light, vec3(3));
        const vec3 behind = sides == EmissionSides::both ? vec3(3) : vec3(0);
        EXPECT_EQ(look(scene, Vec3(0, 0, -1), Vec3(0, 0, 1)).light, behind);
    }
}

} // namespace
} // namespace glint::rendering
