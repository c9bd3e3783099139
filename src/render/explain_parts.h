#pragma once
// The parts of explain(): from a recorded ray tree to steps with formulas. Every result is the recorded one,
// or comes from the functions of shading/ that the estimator called, with the recorded numbers.

#include "glint/explain.h"
#include "render/ray_recorder.h"
#include "scene/scene_data.h"

#include <string>
#include <vector>

namespace glint::rendering {

/// Parts of a scene that explanations need.
struct ExplainedScene {
    explicit ExplainedScene(const scene::SceneData& scene);

    std::string label(std::uint32_t object) const {
        return object_label(scene.description.objects[object], numbers[object]);
    }
    const std::string& material_name(std::uint32_t object) const;
    const MaterialRecord& material(std::uint32_t object) const {
        return scene.materials[scene.objects[object].material];
    }

    const scene::SceneData& scene;
    const WhittedSettings& settings;
    const WhittedModes modes;                 ///< of the settings
    const std::vector<std::uint32_t> numbers; ///< of the objects within their types of table
    std::vector<std::uint32_t> light_numbers; ///< by SceneData::lights: index in SceneDescription::lights
};

/// "τ₁₂"
std::string numbered(const char* symbol, std::size_t number);

/// The light of number `index` at a hit: its own formulas and its shadow ray.
ExplainedLight explain_light(const ExplainedScene& scene, const RayNode& node, std::size_t index);

/// Adds the steps of mirror and refracted ray: directions, and shares of the light.
void explain_bounce(const ExplainedScene& scene, const RayTree& tree, const RayNode& node, ExplainedRay& ray);

/// All rays of a recorded tree; those of less weight without lights and steps.
std::vector<ExplainedRay> explain_tree(const ExplainedScene& scene, const RayTree& tree, float min_weight,
                                       const CancelFlag* cancel);

/// Throws Error(cancelled) once the flag, if any, is set.
inline void stop_if_cancelled(const CancelFlag* cancel) {
    if (cancel != nullptr && cancel->load(std::memory_order_relaxed))
        throw Error(ErrorKind::cancelled, "explaining was cancelled");
}

} // namespace glint::rendering
