// The lights that path tracers sample: what is found, and with which probabilities it is chosen.

#include "scene_kit.h"

#include "math/random.shared.h"
#include "scene/light_set.h"
#include "scene/scene_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace glint::scene {
namespace {

using namespace kit;

SceneDescription path_scene() {
    SceneDescription scene = empty_scene();
    scene.render.integrator = Integrator::path;
    return scene;
}

std::vector<int> kinds_of(const SceneDescription& description) {
    std::vector<int> kinds;
    const Scene scene = build_scene(description);
    for (const EmitterRecord& e : scene.data().light_set->emitters) kinds.push_back(e.kind);
    return kinds;
}

TEST(LightSet, HasEveryVisibleOpaqueObjectThatEmits) {
    SceneDescription scene = path_scene();
    add(scene, RectangleShape{}, lamp(Vec3(1)));
    add(scene, TriangleShape{{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)}}, lamp(Vec3(1)));
    add(scene, DiskShape{}, lamp(Vec3(1)));
    add(scene, SphereShape{}, lamp(Vec3(1)));
    add(scene, PolyhedronShape{.kind = PolyhedronKind::tetrahedron}, lamp(Vec3(1)));
    add(scene, SphereShape{}, matte());
    add(scene, PlaneShape{}, lamp(Vec3(1)));
    add(scene, SphereShape{}, lamp(Vec3(1))).visible = false;
    Material glowing = glass(1.5);
    glowing.emission = Vec3(1);
    add(scene, SphereShape{}, glowing);
    EXPECT_EQ(kinds_of(scene), (std::vector{2, 1, 1, 1, 1, 1, 3, 4}));
    const Scene built = build_scene(scene);
    const LightSet& set = *built.data().light_set;
    EXPECT_EQ(set.emitter_of(0, 1), 0u); // both triangles of the rectangle
    EXPECT_EQ(set.emitter_of(4, 2), 4u);
    EXPECT_EQ(set.emitters[set.emitter_of(3, 0)].kind, emitter_sphere);
    EXPECT_EQ(set.emitter_of(5, 0), invalid_index);
    EXPECT_EQ(set.emitter_of(6, 0), invalid_index);
    scene.render.integrator = Integrator::whitted;
    EXPECT_EQ(build_scene(scene).data().light_set, nullptr);
}

TEST(LightSet, FollowsTransformsInstancesAndNewMaterials) {
    SceneDescription scene = path_scene();
    add(scene, mesh_of(box_mesh(Vec3(0), Vec3(2))), lamp(Vec3(1))).name = "box";
    Mat4 turned(1.0);
    turned[0][0] = -2; // mirrored
    turned[3] = glm::dvec4(5, 0, 0, 1);
    add(scene, InstanceShape{"box"}, "").transform = turned;
    add(scene, SphereShape{}, lamp(Vec3(1))).transform[3][2] = 7;
    BuildSceneOptions options;
    options.find_solids = true;
    const Scene built = build_scene(scene, options);
    const LightSet& set = *built.data().light_set;
    ASSERT_EQ(set.emitters.size(), 25u);
    for (std::size_t i = 0; i < 24; ++i) { // normals are outward
        const EmitterRecord& e = set.emitters[i];
        const vec3 middle = e.base + (e.u + e.v) / 3.0f;
        EXPECT_GT(dot(middle - vec3(e.object == 0 ? 0 : 5, 0, 0), e.n), 0.9f) << i;
    }
    EXPECT_EQ(set.emitters[24].base, vec3(0, 0, 7));
    SceneDescription dark = scene;
    for (Material& m : dark.materials) m.emission = Vec3(0);
    EXPECT_TRUE(update_scene(built, dark).data().light_set->emitters.empty());
}

/// Frequencies of choices are their probabilities. What is left of 1 chooses none: the bounds of a node may
/// let light through where those of its children do not.
void expect_proper(const LightSet& set, const LightReceiver& at) {
    const std::size_t count = set.emitters.size();
    std::vector<double> probabilities, found(count + 1, 0);
    for (std::size_t i = 0; i < count; ++i)
        probabilities.push_back(static_cast<double>(set.probability(static_cast<std::uint32_t>(i), at)));
    const double sum = std::accumulate(probabilities.begin(), probabilities.end(), 0.0);
    probabilities.push_back(1 - sum);
    EXPECT_GT(sum, 0.5);
    EXPECT_LT(sum, 1 + 1e-5);
    constexpr int tries = 1 << 16;
    for (int i = 0; i < tries; ++i) {
        const ChosenLight chosen = set.choose(at, (static_cast<float>(i) + 0.5f) / tries);
        const std::size_t light = chosen.probability > 0 ? chosen.light : count;
        if (light < count) {
            ASSERT_NEAR(chosen.probability, probabilities[light], 1e-6);
        }
        found[light] += 1.0 / tries;
    }
    for (std::size_t i = 0; i <= count; ++i) EXPECT_NEAR(found[i], probabilities[i], 1e-3) << i;
}

TEST(LightSet, ChoosesWithTheProbabilitiesThatItSays) {
    SceneDescription scene = path_scene();
    for (int i = 0; i < 40; ++i) {
        const auto number = [i](uint k) {
            return 4.0 * static_cast<double>(unit_float(hash_with(hash_mix(k), static_cast<uint>(i)))) - 2;
        };
        const Vec3 at(number(0), number(1), number(2) + 4);
        if (i % 2 == 0)
            add(scene, SphereShape{at, 0.1}, lamp(Vec3(1 + i)));
        else
            add(scene, DiskShape{at, Vec3(number(3), number(4), number(5)), 0.2}, lamp(Vec3(1)));
    }
    for (const LightSampling sampling : {LightSampling::uniform, LightSampling::power, LightSampling::tree}) {
        scene.path.light_sampling = sampling;
        const Scene built = build_scene(scene);
        const LightSet& set = *built.data().light_set;
        expect_proper(set, {vec3(0.0f), vec3(0, 0, 1)});
        expect_proper(set, {vec3(0, 0, 4), normalize(vec3(1, 1, 0))});
        expect_proper(set, {vec3(9, 0, 4), vec3(0, 0, -1), true});
    }
}

TEST(LightSet, ATreePrefersLightsThatAreNearAndFaceThePoint) {
    SceneDescription scene = path_scene();
    add(scene, DiskShape{Vec3(0, 0, 1), Vec3(0, 0, 1), 0.1}, lamp(Vec3(1)));
    add(scene, DiskShape{Vec3(20, 0, 1), Vec3(0, 0, 1), 0.1}, lamp(Vec3(1)));
    add(scene, DiskShape{Vec3(0, 0, -1), Vec3(0, 0, 1), 0.1}, lamp(Vec3(1)));
    const Scene built = build_scene(scene);
    const LightSet& set = *built.data().light_set;
    const LightReceiver floor{vec3(0.0f), vec3(0, 0, 1)};
    EXPECT_GT(set.probability(0, floor), 0.99f);
    EXPECT_EQ(set.probability(2, floor), 0.0f);
}

} // namespace
} // namespace glint::scene
