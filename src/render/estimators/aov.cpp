#include "render/estimators/aov.h"

#include "render/aov.shared.h"

namespace glint::rendering {

using trace::TraceCost;

static_assert(shown_shadows == static_cast<int>(Aov::shadows) &&
              shown_normal == static_cast<int>(Aov::normal) && shown_depth == static_cast<int>(Aov::depth) &&
              shown_cost == static_cast<int>(Aov::cost));

WhittedSettings first_hit_settings(const scene::SceneData& scene) {
    WhittedSettings settings = scene.description.whitted;
    settings.max_depth = 0;
    return settings;
}

AovEstimator::AovEstimator(const scene::SceneData& scene, Aov aov, const CancelFlag* cancel,
                           const KernelChoice& kernel)
    : scene_(scene), aov_(aov), first_hits_(scene, first_hit_settings(scene), cancel, kernel) {}

void AovEstimator::estimate(std::span<const CameraSample> samples, std::span<Channels> out, bool /*terms*/) {
    for (std::size_t i = 0; i < samples.size(); ++i)
        out[i].radiance = aov_ == Aov::cost ? measure_cost(samples[i]) : measure(samples[i]);
}

vec3 AovEstimator::measure_cost(const CameraSample& sample) {
    Ray ray;
    ray.origin = sample.origin;
    ray.direction = sample.direction;
    const TraceCost cost = scene_.world.cost(ray);
    ++cost_counts_.primary;
    return cost_number(cost.nodes, cost.shapes);
}

vec3 AovEstimator::measure(const CameraSample& sample) {
    first_hits_.trace(sample, &tree_);
    if (tree_.nodes.empty()) return vec3(0.0f); // cancelled
    const RayNode& node = tree_.nodes.front();
    float hidden = 0;
    for (const LightNode& light : node.lights) hidden = hidden_with(hidden, light.shadow);
    return first_hit_number(static_cast<int>(aov_), static_cast<bool>(node.hit), node.hit.t,
                            node.shading_normal, hidden);
}

} // namespace glint::rendering
