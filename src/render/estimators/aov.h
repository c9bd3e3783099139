#pragma once
// AOVs (arbitrary output variables) of first hits.

#include "glint/render.h"
#include "render/estimators/whitted.h"
#include "render/ray_recorder.h"

#include <span>

namespace glint::rendering {

/// Whitted's settings for first hits: no bounces.
WhittedSettings first_hit_settings(const scene::SceneData& scene);

/// Measures shadows, normal, depth or cost of first hits. Holds scratch memory: one for each thread.
class AovEstimator {
  public:
    AovEstimator(const scene::SceneData& scene, Aov aov, const CancelFlag* cancel,
                 const KernelChoice& kernel);

    /// Radiance is the AOV. There are no terms.
    void estimate(std::span<const CameraSample> samples, std::span<Channels> out, bool terms = false);
    const RayCounts& counts() const { return aov_ == Aov::cost ? cost_counts_ : first_hits_.counts(); }

  private:
    vec3 measure(const CameraSample& sample);
    vec3 measure_cost(const CameraSample& sample);

    const scene::SceneData& scene_;
    Aov aov_;
    Whitted first_hits_;
    RayTree tree_;
    RayCounts cost_counts_;
};

} // namespace glint::rendering
