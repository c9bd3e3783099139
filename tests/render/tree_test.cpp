// The recorded ray tree is what was computed, number by number.

#include "gallery.h"
#include "scene_kit.h"

#include "imaging/camera.h"

#include <gtest/gtest.h>

namespace glint::rendering {
namespace {

using namespace kit;

class RayTreeOf : public testing::TestWithParam<Exhibit> {
  protected:
    /// Calls check(origin, direction, tracer) for rays all over the picture.
    template <class Check>
    void for_rays(const Check& check) {
        const Scene scene = build_scene(GetParam().scene);
        Whitted tracer(scene.data());
        const CameraDescription& c = scene.camera();
        const PinholeCamera camera =
            imaging::pinhole_camera(c.eye, c.direction, c.up, c.fov, FovAxis::y, 97, 83);
        for (int i = 0; i < 300; ++i)
            check(camera.eye, pinhole_direction(camera, (i * 37) % 97, (i * 53) % 83, 0.1f, -0.2f), tracer);
    }
};

INSTANTIATE_TEST_SUITE_P(Gallery, RayTreeOf, testing::ValuesIn(gallery()),
                         [](const auto& exhibit) { return exhibit.param.name; });

TEST_P(RayTreeOf, RecordingChangesNoBit) {
    for_rays([](const vec3& origin, const vec3& direction, Whitted& tracer) {
        RayTree tree;
        const Terms recorded = tracer.trace(camera_ray(origin, direction), &tree).terms;
        const Terms plain = tracer.trace(camera_ray(origin, direction)).terms;
        EXPECT_EQ(recorded.value, plain.value);
        EXPECT_EQ(tree.nodes.at(0).terms.value, plain.value);
        EXPECT_EQ(tree.nodes.at(0).radiance, plain.sum());
    });
}

TEST_P(RayTreeOf, AWavefrontHasTheBitsOfSingleRays) {
    std::vector<CameraSample> samples;
    std::vector<Channels> single;
    for_rays([&](const vec3& origin, const vec3& direction, Whitted& tracer) {
        samples.push_back(camera_ray(origin, direction));
        single.push_back(tracer.trace(samples.back()));
    });
    const Scene scene = build_scene(GetParam().scene);
    WhittedWavefront tracer(scene.data(), scene.data().description.whitted);
    std::vector<Channels> out(samples.size());
    tracer.estimate(samples, out);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        EXPECT_EQ(out[i].terms.value, single[i].terms.value) << "ray " << i;
        EXPECT_EQ(out[i].radiance, single[i].radiance) << "ray " << i;
        EXPECT_EQ(out[i].covered, single[i].covered) << "ray " << i;
    }
}

/// The node's terms, put together from its lights and children alone.
Terms recombined(const RayTree& tree, const RayNode& node, const WhittedSettings& settings) {
    Terms terms = node.terms;
    if (!node.hit) return terms;
    vec3 diffuse(0.0f), highlight(0.0f);
    for (const LightNode& light : node.lights) {
        diffuse = diffuse + light.diffuse;
        highlight = highlight + light.highlight;
    }
    terms[Term::diffuse] = diffuse * node.local_weight * node.transmittance;
    terms[Term::highlight] = highlight * node.local_weight * node.transmittance;
    if (!settings.clamp) {
        EXPECT_EQ(node.terms[Term::clamp], vec3(0.0f));
    }
    const auto branch = [&](int child, RayKind kind) {
        if (child < 0) return vec3(0.0f);
        return tree.nodes.at(static_cast<std::size_t>(child)).radiance * branch_weight(node, kind) *
               node.transmittance;
    };
    terms[Term::reflection] = branch(node.reflected, RayKind::reflected);
    terms[Term::transmission] = branch(node.refracted, RayKind::refracted);
    return terms;
}

TEST_P(RayTreeOf, NodesRecombineToThePixelBitForBit) {
    const WhittedSettings& settings = GetParam().scene.whitted;
    for_rays([&](const vec3& origin, const vec3& direction, Whitted& tracer) {
        RayTree tree;
        tracer.trace(camera_ray(origin, direction), &tree);
        for (const RayNode& node : tree.nodes) {
            EXPECT_EQ(recombined(tree, node, settings).value, node.terms.value);
            EXPECT_EQ(node.terms.sum(), node.radiance);
        }
    });
}

TEST_P(RayTreeOf, ParentsStandBeforeTheirChildrenOneBounceApart) {
    const WhittedSettings& settings = GetParam().scene.whitted;
    for_rays([&](const vec3& origin, const vec3& direction, Whitted& tracer) {
        RayTree tree;
        tracer.trace(camera_ray(origin, direction), &tree);
        EXPECT_EQ(tree.nodes.at(0).parent, -1);
        EXPECT_EQ(tree.nodes.at(0).origin, origin);
        EXPECT_EQ(tree.nodes.at(0).direction, direction);
        for (std::size_t i = 1; i < tree.nodes.size(); ++i) {
            const RayNode& node = tree.nodes[i];
            ASSERT_GE(node.parent, 0);
            ASSERT_LT(node.parent, static_cast<int>(i));
            const RayNode& parent = tree.nodes[static_cast<std::size_t>(node.parent)];
            EXPECT_EQ(node.depth, parent.depth + 1);
            EXPECT_EQ(node.kind == RayKind::reflected ? parent.reflected : parent.refracted,
                      static_cast<int>(i));
            EXPECT_LE(node.depth, settings.max_depth);
        }
    });
}

TEST_P(RayTreeOf, EveryRayGoesToTheSideOfItsKind) {
    for_rays([](const vec3& origin, const vec3& direction, Whitted& tracer) {
        RayTree tree;
        tracer.trace(camera_ray(origin, direction), &tree);
        for (const RayNode& node : tree.nodes) {
            EXPECT_NEAR(dot(node.direction, node.direction), 1, 1e-6);
            if (!node.hit) continue;
            EXPECT_GE(dot(node.shading_normal, node.geometric_normal), 0);
            EXPECT_LE(dot(node.geometric_normal, node.direction), 0);
            const auto side = [&](int child) {
                return dot(node.geometric_normal, tree.nodes[static_cast<std::size_t>(child)].direction);
            };
            if (node.reflected >= 0) {
                EXPECT_GT(side(node.reflected), 0);
            }
            if (node.refracted >= 0) {
                EXPECT_LT(side(node.refracted), 0);
            }
        }
    });
}

} // namespace
} // namespace glint::rendering
