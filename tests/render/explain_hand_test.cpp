// A scene small enough for pencil and paper: a glass ball before a mirror, one lamp that shines freely, one
// through the glass, one behind a pebble.

#include "scene_kit.h"

#include "glint/explain.h"

#include <gtest/gtest.h>

namespace glint::rendering {
namespace {

using namespace kit;

/// All in the plane y = 0. From (0, 0, 5) the eye looks down at the middle of a glass ball of radius 1 about
/// the origin, so that no ray is bent, and through it at a floor z = −3 with ρ = 0.5 that sends the ray back
/// up.
SceneDescription ball_before_a_mirror() {
    SceneDescription scene = empty_scene(Vec3(0, 0, 5), Vec3(0, 0, -1), 1, 1);
    scene.whitted.max_depth = 3;
    scene.render.background = Vec3(0.25, 0.5, 1);
    Material glass_ball = glass(1.5, 0.5);
    glass_ball.name = "glass";
    add(scene, SphereShape{Vec3(0), 1}, glass_ball).name = "ball";
    Material floor = matte(0.5);
    floor.color = Vec3(1, 0.5, 0.25);
    floor.ambient = 1;
    floor.reflectivity = 0.5;
    floor.name = "polished";
    add(scene, PlaneShape{Vec3(0, 0, 1), -3}, floor).name = "floor";
    // Lamp 1 stands at distance 5 from (0, 0, −3): 3 to the side, 4 above. The ball is not in its way.
    add_light(scene, Vec3(3, 0, 1), 50);
    // Lamp 2 stands straight above the ball: its light crosses the glass twice.
    add_light(scene, Vec3(0, 0, 1.5), 16);
    // Lamp 3 stands behind a small opaque ball.
    add_light(scene, Vec3(-4, 0, 0), 100);
    add(scene, SphereShape{Vec3(-2, 0, -1.5), 0.1}, black()).name = "pebble";
    add_ambient(scene, Vec3(0.1, 0.2, 0.4));
    return scene;
}

const Step& step_of(const std::vector<Step>& steps, const std::string& symbol) {
    for (const Step& step : steps)
        if (step.symbol == symbol) return step;
    throw std::runtime_error("no step " + symbol);
}

void expect_near(const glm::vec3& found, const glm::vec3& expected) {
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(found[i], expected[i], 2e-6f * std::max(1.0f, std::abs(expected[i])));
}

class ByHand : public testing::Test {
  protected:
    const Explanation e_ = explain(build_scene(ball_before_a_mirror()), 0, 0);
    const ExplainedSample& sample_ = e_.samples.at(0);
    const ExplainedRay& ray(std::size_t i) const { return sample_.rays.at(i); }
};

// Eye → ball (in) → ball (out) → floor → back up: at the third bounce the depth ends.
TEST_F(ByHand, TheTreeHasTheRaysOfTheDrawing) {
    ASSERT_EQ(sample_.rays.size(), 4u);
    const char* kinds[] = {"primary", "refracted", "refracted", "reflected"};
    const char* labels[] = {"sphere \"ball\"", "sphere \"ball\"", "plane \"floor\"", "sphere \"ball\""};
    const float distances[] = {4, 2, 2, 2};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_STREQ(ray_kind_name(ray(i).kind), kinds[i]) << i;
        EXPECT_EQ(ray(i).label, labels[i]) << i;
        EXPECT_NEAR(ray(i).distance, distances[i], 1e-5) << i;
        EXPECT_EQ(ray(i).depth, static_cast<int>(i));
    }
    EXPECT_TRUE(ray(0).entering);
    EXPECT_FALSE(ray(1).entering);
    EXPECT_EQ(ray(1).inside, std::vector<std::string>{"sphere \"ball\""});
    EXPECT_EQ(ray(3).end, RayEnd::depth_limit);
}

// The mirror ray of the ball weighs 0.1, the ray out of the ball 0.25.
TEST(LeftOut, RaysAreNamedWhereTheyWouldBegin) {
    SceneDescription scene = ball_before_a_mirror();
    scene.materials.front().reflectivity = 0.1;
    scene.whitted.min_weight = 0.3;
    const Explanation e = explain(build_scene(scene), 0, 0);
    const std::vector<ExplainedRay>& rays = e.samples.at(0).rays;
    ASSERT_EQ(rays.size(), 2u);
    EXPECT_EQ(rays[0].end, RayEnd::bounced);
    EXPECT_EQ(rays[0].why, "goes on; the mirror ray has a weight below min_weight, and is left out");
    EXPECT_STREQ(step_of(rays[0].steps, "W_R").note, "below min_weight: this ray is left out");
    EXPECT_STREQ(step_of(rays[0].steps, "W_T").note, "");
    EXPECT_EQ(rays[0].left_out, 1);
    EXPECT_EQ(rays[1].left_out, 2);
    EXPECT_EQ(rays[1].end, RayEnd::min_weight);
    EXPECT_EQ(rays[1].why, "ends: what would go on has a weight below min_weight, and is left out");
    expect_near(step_of(rays[1].steps, "W_T").result.value, glm::vec3(0.25f));
}

TEST_F(ByHand, WeightsHalveAtEachSurface) {
    expect_near(ray(0).weight, glm::vec3(1));
    expect_near(ray(1).weight, glm::vec3(0.5f));
    expect_near(ray(2).weight, glm::vec3(0.25f));
    expect_near(ray(3).weight, glm::vec3(0.125f));
}

TEST_F(ByHand, IndicesTurnOverAtTheFarSide) {
    EXPECT_EQ(ray(0).index_before, 1);
    EXPECT_EQ(ray(0).index_after, 1.5f);
    EXPECT_EQ(ray(1).index_before, 1.5f);
    EXPECT_EQ(ray(1).index_after, 1);
    // arcsin(2/3)
    EXPECT_NEAR(ray(1).critical_degrees, 41.8103149f, 1e-5);
    EXPECT_EQ(ray(0).critical_degrees, 90);
}

// Lamp 1: r = 5, n·l = 4/5, 36.87°, E = 50 · 0.8/25 = 1.6, D = 1.6 · (1, 0.5, 0.25) · 0.5.
TEST_F(ByHand, TheFirstLampArrivesWhole) {
    const ExplainedLight& lamp = ray(2).lights.at(0);
    EXPECT_EQ(lamp.label, "point light.0");
    EXPECT_NEAR(lamp.distance, 5, 1e-5);
    EXPECT_NEAR(lamp.cosine, 0.8, 1e-6);
    EXPECT_NEAR(lamp.degrees, 36.8698976, 1e-4);
    EXPECT_NEAR(lamp.attenuation, 0.04, 1e-6);
    EXPECT_TRUE(lamp.asked);
    EXPECT_TRUE(lamp.blockers.empty());
    expect_near(lamp.arriving, glm::vec3(1.6f));
    expect_near(lamp.diffuse, {0.8f, 0.4f, 0.2f});
}

// Lamp 2: r = 4.5, n·l = 1, E = 16/20.25; the glass is crossed at distances 2 and 4: s = 0.5 · 0.5.
TEST_F(ByHand, TheSecondLampIsWeakenedTwiceByTheGlass) {
    const ExplainedLight& lamp = ray(2).lights.at(1);
    ASSERT_EQ(lamp.blockers.size(), 2u);
    EXPECT_NEAR(lamp.blockers[0].distance, 2, 1e-5);
    EXPECT_NEAR(lamp.blockers[1].distance, 4, 1e-5);
    for (const Blocker& b : lamp.blockers) {
        EXPECT_EQ(b.label, "sphere \"ball\"");
        EXPECT_EQ(b.material, "glass");
        EXPECT_EQ(b.transparency, 0.5f);
    }
    EXPECT_EQ(lamp.shadow, 0.25f);
    expect_near(lamp.arriving, glm::vec3(0.790123457f));
    expect_near(lamp.diffuse, {0.0987654321f, 0.0493827160f, 0.0246913580f});
}

// Lamp 3: r = 5, n·l = 3/5, E = 100 · 0.6/25 = 2.4, all of it kept by the pebble half-way.
TEST_F(ByHand, TheThirdLampIsBehindThePebble) {
    const ExplainedLight& lamp = ray(2).lights.at(2);
    expect_near(lamp.arriving, glm::vec3(2.4f));
    ASSERT_EQ(lamp.blockers.size(), 2u);
    EXPECT_EQ(lamp.blockers[0].label, "sphere \"pebble\"");
    EXPECT_NEAR(lamp.blockers[0].distance, 2.4, 1e-5);
    EXPECT_NEAR(lamp.blockers[1].distance, 2.6, 1e-5);
    EXPECT_EQ(lamp.shadow, 0);
    expect_near(lamp.diffuse, glm::vec3(0));
}

// Floor: ambient (0.1, 0.2, 0.4) ⊙ (1, 0.5, 0.25); the mirror ray meets the black ball at the depth limit: 0.
// What the eye gets: 0.25 of the floor's.
TEST_F(ByHand, TheSumIsThatOnPaper) {
    expect_near(ray(2).terms[0], {0.1f, 0.1f, 0.1f});
    expect_near(ray(2).terms[1], {0.898765432f, 0.449382716f, 0.224691358f});
    expect_near(ray(2).radiance, {0.998765432f, 0.549382716f, 0.324691358f});
    expect_near(e_.color, {0.249691358f, 0.137345679f, 0.0811728395f});
    expect_near(e_.terms[static_cast<std::size_t>(Term::transmission)], e_.color);
    // (1 − 0) · 1 · 0.5 + 0.5 + 0
    EXPECT_FLOAT_EQ(ray(2).gain, 1.0f);
}

TEST_F(ByHand, TheFormulasAreThoseOfTheReport) {
    const ExplainedLight& lamp = ray(2).lights.at(0);
    const Step& arriving = step_of(lamp.steps, "E");
    EXPECT_EQ(arriving.formula, "I · (cosθ / r²)");
    EXPECT_STREQ(arriving.section, "2.2");
    EXPECT_EQ(step_of(lamp.steps, "D").formula, "E ⊙ c · k_d · s");
    EXPECT_EQ(step_of(ray(2).lights.at(1).steps, "s").formula, "τ₁ · τ₂");
    EXPECT_EQ(step_of(ray(2).steps, "ΣD").formula, "D₀ + D₁ + D₂");
    EXPECT_EQ(step_of(ray(2).steps, "reflection").formula, "L_R · w_R");
    EXPECT_EQ(step_of(ray(0).steps, "transmission").formula, "L_T · w_T");
    EXPECT_EQ(step_of(ray(2).steps, "L").formula, "ambient + diffuse + reflection");
}

} // namespace
} // namespace glint::rendering
