#pragma once
// The simplest path tracer, to be read first and to check path.h against: the rendering equation by paths
// from the camera, one after another, whose directions the materials sample alone. J. T. Kajiya, "The
// Rendering Equation", SIGGRAPH 1986.

#include "render/estimators/path_walk.h"

#include <span>

namespace glint::rendering {

/// Holds scratch memory: one for each thread. The scene must outlive it.
class PathSimple {
  public:
    PathSimple(const scene::SceneData& scene, const CancelFlag* cancel, const KernelChoice& kernel);

    /// `out` has an element for each sample. All light counts as emission. Incomplete if `cancel` was set.
    void estimate(std::span<const CameraSample> samples, std::span<Channels> out, bool terms = true);
    const RayCounts& counts() const { return counts_; }

  private:
    Channels trace(const CameraSample& sample);
    vec3 light_of_points(const PathVertex& vertex);
    bool cancelled() const { return cancel_ != nullptr && cancel_->load(std::memory_order_relaxed); }

    const scene::SceneData& scene_;
    const PathSettings settings_;
    const CancelFlag* cancel_;
    const KernelChoice kernel_;
    PathWalk walk_;
    RayCounts counts_;
};

} // namespace glint::rendering
