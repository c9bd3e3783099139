// Rays of little weight are left out, and what that takes from a sample has a bound (docs/light-model.md).

#include "scene_kit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace glint::rendering {
namespace {

using namespace kit;

/// Balls and boxes of glass, mirror and matte things in a room of mirrors, at random.
SceneDescription random_room(unsigned seed) {
    std::mt19937 bits(seed);
    const auto number = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(bits()) / 4294967296.0;
    };
    SceneDescription scene = empty_scene(Vec3(0, -3.5, 0), Vec3(0, 1, 0), 8, 70);
    Material wall = mirror(number(0.1, 0.9));
    wall.ambient = wall.diffuse = 0.2;
    wall.color = Vec3(0.9, 0.6, 0.3);
    add(scene, PolyhedronShape{.size = Vec3(8)}, wall);
    for (int i = 0; i < 6; ++i) {
        Material m = glass(number(1, 2), number(0, 1));
        m.reflectivity = 1 - m.transparency;
        m.fresnel = bits() % 2 == 0;
        m.absorption = Vec3(number(0, 2), number(0, 0.2), 0);
        if (i % 3 == 2) m = matte(number(0.2, 0.9));
        add(scene, SphereShape{Vec3(number(-3, 3), number(-2, 3), number(-3, 3)), number(0.3, 1.5)}, m);
    }
    add_light(scene, Vec3(3.5, -3, 3.5), 20);
    add_ambient(scene, Vec3(0.3));
    scene.whitted.max_depth = 8;
    return scene;
}

std::vector<CameraSample> camera_rays(const Scene& scene) {
    std::vector<CameraSample> rays;
    for (int i = 0; i < 64; ++i)
        rays.push_back(camera_ray(vec3(scene.camera().eye), normalize(vec3(0.2f * float(i % 8) - 0.7f, 1,
                                                                           0.2f * float(i / 8) - 0.7f))));
    return rays;
}

WhittedSettings with_min_weight(const Scene& scene, double min_weight) {
    WhittedSettings settings = scene.description().whitted;
    settings.min_weight = min_weight;
    return settings;
}

float largest(const vec3& v) { return std::max({v.x, v.y, v.z}); }

class MinWeight : public testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(RandomRooms, MinWeight, testing::Range(0u, 12u));

TEST_P(MinWeight, LeavesOutTheBranchesBelowItAndNoOthers) {
    const Scene scene = build_scene(random_room(GetParam()));
    constexpr float min_weight = 0.01f;
    Whitted tracer(scene.data(), with_min_weight(scene, min_weight));
    std::uint64_t left_out = 0;
    for (const CameraSample& sample : camera_rays(scene)) {
        RayTree tree;
        tracer.trace(sample, &tree);
        std::vector<vec3> weights(tree.nodes.size(), vec3(1.0f));
        for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
            const RayNode& node = tree.nodes[i];
            for (const auto& [child, share] : {std::pair(node.reflected, node.reflected_weight),
                                               std::pair(node.refracted, node.refracted_weight)}) {
                if (!(share > 0.0f)) continue;
                const vec3 weight = weights[i] * node.transmittance * share;
                EXPECT_EQ(child >= 0, largest(weight) >= min_weight);
                if (child >= 0) weights[static_cast<std::size_t>(child)] = weight;
                left_out += child >= 0 ? 0 : 1;
            }
        }
    }
    EXPECT_GT(left_out, 0u);
    EXPECT_EQ(tracer.counts().left_out, left_out);
}

TEST_P(MinWeight, TakesNoMoreThanItsBound) {
    const Scene scene = build_scene(random_room(GetParam()));
    Whitted all(scene.data(), with_min_weight(scene, 0));
    for (const double min_weight : {1e-5, 1e-3, 0.1}) {
        Whitted most(scene.data(), with_min_weight(scene, min_weight));
        for (const CameraSample& sample : camera_rays(scene)) {
            RayTree tree;
            const vec3 whole = all.trace(sample, &tree).radiance;
            float brightest = 0;
            for (const RayNode& node : tree.nodes) brightest = std::max(brightest, largest(node.radiance));
            const std::uint64_t before = most.counts().left_out;
            const vec3 missing = whole - most.trace(sample).radiance;
            const auto count = static_cast<double>(most.counts().left_out - before);
            const double rounding = 1e-5 * brightest;
            EXPECT_LE(largest(missing), count * min_weight * brightest + rounding);
            EXPECT_LE(largest(-missing), rounding) << "nothing gets brighter";
        }
    }
    EXPECT_EQ(all.counts().left_out, 0u);
}

TEST_P(MinWeight, IsTheSameForAWavefront) {
    const Scene scene = build_scene(random_room(GetParam()));
    for (const double min_weight : {0.0, 1e-3, 0.1}) {
        const WhittedSettings settings = with_min_weight(scene, min_weight);
        Whitted single(scene.data(), settings);
        WhittedWavefront wavefront(scene.data(), settings);
        const std::vector<CameraSample> samples = camera_rays(scene);
        std::vector<Channels> out(samples.size());
        wavefront.estimate(samples, out);
        for (std::size_t i = 0; i < samples.size(); ++i)
            ASSERT_EQ(out[i].terms.value, single.trace(samples[i]).terms.value) << "ray " << i;
        EXPECT_EQ(wavefront.counts().left_out, single.counts().left_out);
        EXPECT_EQ(wavefront.counts().total(), single.counts().total());
    }
}

TEST(MinWeight, TreesWithoutAnEndEnd) {
    // At 50 bounces all rays of a pixel would be up to 2^50.
    SceneDescription scene = random_room(1);
    for (Material& m : scene.materials)
        if (m.transparency > 0) m.transparency = m.reflectivity = 0.5;
    scene.whitted.max_depth = 50;
    scene.whitted.min_weight = 0.01;
    scene.render.width = scene.render.height = 4;
    const Picture picture = rendered(scene);
    EXPECT_GT(picture.stats.left_out_rays, 0u);
    EXPECT_LT(picture.stats.rays(), 1'000'000u);
}

} // namespace
} // namespace glint::rendering
