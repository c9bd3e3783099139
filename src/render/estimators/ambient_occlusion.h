#pragma once
// Ambient occlusion: the share of the cosine-weighted hemisphere about a first hit's normal in which nothing
// is near. S. Zhukov, A. Iones, G. Kronin, "An Ambient Light Illumination Model", 1998.

#include "render/estimators/whitted.h"

#include <span>
#include <vector>

namespace glint::rendering {

/// Holds scratch memory: one for each thread. The scene must outlive it.
class AmbientOcclusion {
  public:
    AmbientOcclusion(const scene::SceneData& scene, const CancelFlag* cancel, const KernelChoice& kernel);

    /// One ray into the hemisphere for each sample: radiance is 0 or 1, or the colour of the surface; the
    /// background where nothing is hit. All of it counts as emission.
    void estimate(std::span<const CameraSample> samples, std::span<Channels> out, bool terms = true);
    RayCounts counts() const { return counts_; }

  private:
    void find_hits(std::span<const CameraSample> samples);
    void start_ray(const CameraSample& sample, std::size_t i, Channels& out);

    const scene::SceneData& scene_;
    const float distance_;
    const bool colored_;
    const KernelChoice kernel_;
    Whitted single_; ///< finds what is seen among surfaces that hide each other
    const InteriorList* around_eye_ = nullptr;
    RayCounts counts_;
    std::vector<Ray> camera_rays_;
    std::vector<trace::Hit> hits_;
    std::vector<Ray> rays_; ///< into the hemispheres
    std::vector<std::size_t> sample_of_ray_;
    std::vector<std::uint8_t> blocked_;
    trace::World::Scratch scratch_;
};

} // namespace glint::rendering
