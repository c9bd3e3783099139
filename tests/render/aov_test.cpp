// What pictures show beside the light.

#include "glint/pick.h"

#include "gallery.h"
#include "scene_kit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace glint::rendering {
namespace {

using namespace kit;

Image shown(const SceneDescription& scene, Aov aov, int threads = 1) {
    RenderOptions options;
    options.show = aov;
    options.threads = threads;
    return render(build_scene(scene), options).image;
}

/// A ball over a floor, the eye above the ball; one light stands beside the other's shadow.
SceneDescription ball_over_floor() {
    SceneDescription scene = empty_scene(Vec3(0, 0, 10), Vec3(0, 0, -1), 65, 90);
    scene.camera->up = Vec3(0, 1, 0);
    add(scene, PlaneShape{Vec3(0, 0, 1), 0}, matte());
    add(scene, SphereShape{Vec3(0, 0, 3), 1}, matte());
    add_light(scene, Vec3(0, 0, 9), 50);
    add_light(scene, Vec3(6, 0, 6), 50);
    return scene;
}

TEST(Aovs, ATermIsItsLayer) {
    for (const Exhibit& exhibit : gallery()) {
        RenderOptions options;
        options.terms = true;
        const Picture whole = render(build_scene(exhibit.scene), options);
        for (int i = 0; i < term_count; ++i) {
            const auto aov = static_cast<Aov>(i + 1);
            EXPECT_STREQ(aov_name(aov), term_name(static_cast<Term>(i)));
            EXPECT_EQ(picture_hash(shown(exhibit.scene, aov)),
                      picture_hash(whole.terms[static_cast<std::size_t>(i)]))
                << exhibit.name << " " << aov_name(aov);
        }
    }
}

TEST(Aovs, ThreadsKernelsSamplesAndCropsChangeNoNumber) {
    SceneDescription scene = gallery().front().scene;
    for (const Aov aov : {Aov::shadows, Aov::normal, Aov::depth, Aov::cost}) {
        const Image expected = shown(scene, aov);
        EXPECT_EQ(picture_hash(shown(scene, aov, 5)), picture_hash(expected));
        RenderOptions options;
        options.show = aov;
        options.kernel.kernel = Kernel::scalar;
        EXPECT_EQ(picture_hash(render(build_scene(scene), options).image), picture_hash(expected));
        options.crop = Rect{3, 5, 7, 9};
        const Image part = render(build_scene(scene), options).image;
        for (int y = 0; y < 9; ++y)
            for (int x = 0; x < 7; ++x) EXPECT_EQ(part.at(x, y)[0], expected.at(x + 3, y + 5)[0]);
        if (aov == Aov::cost) continue; // trees may be better where more rays are to come
        SceneDescription finer = scene;
        finer.render.spp = 9;
        EXPECT_EQ(picture_hash(shown(finer, aov)), picture_hash(expected));
    }
}

TEST(Aovs, DepthIsTheDistanceToTheFirstHit) {
    const Image depth = shown(ball_over_floor(), Aov::depth);
    EXPECT_NEAR(depth.at(32, 32)[0], 6, 1e-5);
    const double cosine = 1 / std::sqrt(1 + std::pow(32 * 2.0 / 65, 2));
    EXPECT_NEAR(depth.at(64, 32)[0], 10 / cosine, 1e-4);
    EXPECT_EQ(shown(empty_scene(), Aov::depth).at(3, 3)[1], std::numeric_limits<float>::infinity());
}

TEST(Aovs, NormalsFaceTheViewer) {
    const Image normal = shown(ball_over_floor(), Aov::normal);
    EXPECT_NEAR(normal.at(32, 32)[2], 1, 1e-6);
    EXPECT_EQ(normal.at(64, 0)[2], 1);
    EXPECT_EQ(shown(empty_scene(), Aov::normal).at(3, 3)[2], 0);
}

TEST(Aovs, ShadowsCountTheLightsThatAreHidden) {
    const SceneDescription scene = ball_over_floor();
    const Image hidden = shown(scene, Aov::shadows);
    const auto at = [&](double x, double y) {
        // Pixels of points on the floor, seen from 10 above: half of the picture is 10 wide.
        const auto pixel = [](double on_floor) { return static_cast<int>(32.5 + on_floor / 10 * 32.5); };
        return hidden.at(pixel(x), pixel(-y))[0];
    };
    EXPECT_EQ(at(0, 8), 0);
    EXPECT_EQ(at(-6, 0), 1) << "in the ball's shadow of the light at the side";
    SceneDescription glassy = scene;
    glassy.materials[1] = glass(1, 0.75);
    glassy.materials[1].name = scene.materials[1].name;
    const Image part = shown(glassy, Aov::shadows);
    EXPECT_NEAR(part.at(static_cast<int>(32.5 - 0.6 * 32.5), 32)[0], 1 - 0.75 * 0.75, 1e-6);
}

TEST(Aovs, CostCountsEveryPlaneAndNeverLessThanWhatIsHit) {
    const Image cost = shown(ball_over_floor(), Aov::cost);
    for (int i = 0; i < 65; ++i) EXPECT_EQ(cost.at(i, i)[1], 2) << "a plane and a sphere";
    SceneDescription scene = empty_scene(Vec3(0, -4, 0));
    add(scene, mesh_of(sphere_mesh(1, 40)), matte());
    const Image steps = shown(scene, Aov::cost);
    EXPECT_GE(steps.at(8, 8)[0], 2);
    EXPECT_GE(steps.at(8, 8)[1], 1);
    EXPECT_LT(steps.at(8, 8)[1], 400) << "that is what the tree is for";
    EXPECT_EQ(steps.at(0, 0)[1], 0) << "nothing is near";
}

TEST(Aovs, VisiblePicturesLieBetweenBlackAndWhite) {
    const Scene scene = build_scene(ball_over_floor());
    for (const Aov aov : {Aov::shadows, Aov::normal, Aov::depth, Aov::cost}) {
        RenderOptions options;
        options.show = aov;
        const Image picture = visible(render(scene, options).image, aov, scene);
        for (const float value : picture.pixels) {
            EXPECT_GE(value, 0) << aov_name(aov);
            EXPECT_LE(value, 1) << aov_name(aov);
        }
    }
}

TEST(Pick, FindsObjectMaterialAndPlace) {
    const Scene scene = build_scene(ball_over_floor());
    const auto ball = pick(scene, 32.5, 32.5);
    ASSERT_TRUE(ball);
    EXPECT_EQ(ball->object, 1u);
    EXPECT_EQ(ball->material, 1u);
    EXPECT_NEAR(ball->distance, 6, 1e-5);
    EXPECT_NEAR(ball->position.z, 4, 1e-5);
    const auto floor = pick(scene, 64.99, 0);
    ASSERT_TRUE(floor);
    EXPECT_EQ(floor->object, 0u);
    EXPECT_FALSE(pick(scene, 65, 3)) << "beside the picture";
    EXPECT_FALSE(pick(build_scene(empty_scene()), 3, 3)) << "nothing is there";
}

} // namespace
} // namespace glint::rendering
