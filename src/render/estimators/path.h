#pragma once
// All of light by paths from the camera: at each vertex lights are sampled, and the material samples the
// direction in which the path goes on; multiple importance sampling weighs light that both may find. E.
// Veach, Robust Monte Carlo Methods for Light Transport Simulation, 1997. path_simple.h is the same without
// sampling of lights.

#include "render/estimators/path_walk.h"

#include <span>
#include <vector>

namespace glint::rendering {

/// Traces many paths at once, vertex by vertex: the rays of all paths together, then all shadow rays. With
/// Kernel::scalar it traces one path after another. Holds scratch memory: one for each thread. The scene must
/// outlive it.
class PathTracer {
  public:
    PathTracer(const scene::SceneData& scene, const CancelFlag* cancel, const KernelChoice& kernel);

    /// `out` has an element for each sample. Incomplete if `cancel` was set.
    void estimate(std::span<const CameraSample> samples, std::span<Channels> out, bool terms = true);
    const RayCounts& counts() const { return counts_; }

  private:
    /// A path on its way.
    struct Path {
        SampleNumbers numbers;
        PathLength length;
        const InteriorList* interior = nullptr; ///< around its ray
        vec3 throughput{1.0f};                  ///< the share of its ray's light that reaches the sample
        float radiance_scale = 1;               ///< the factor of it that refraction undoes on leaving
        BsdfValue shares{};                     ///< of the lobes of the first hit in its light
        scene::LightReceiver from;              ///< its last vertex
        float pdf = 0;              ///< with which that sampled the ray; 0 where no light was sampled
        bool through_glass = false; ///< a shadow ray may have brought the light of its ray
        bool covered = false;
        Terms terms{}; ///< what it has gathered
    };
    /// A shadow ray: what its light adds to a path if nothing is in between.
    struct Shadow {
        std::size_t path = 0;
        const InteriorList* interior = nullptr;
        BsdfValue light{};
        PathTerm term = PathTerm::direct_diffuse; ///< of its diffuse part
        float mis_weight = 1;                     ///< in the light: 1 if no path will find it
    };

    void trace(std::span<const CameraSample> samples, std::span<Channels> out);
    void start(std::span<const CameraSample> samples);
    void extend_paths();
    bool extend(std::size_t path, const Ray& ray, trace::Hit& hit, Ray& next);
    static void add_light(Path& path, const vec3& light);
    float weight_of_emission(const Path& path, const PathVertex& vertex, const trace::Hit& hit) const;
    void sample_lights(std::size_t path, const PathVertex& vertex);
    void sample_point(std::size_t path, const PathVertex& vertex, const LightRecord& light,
                      float probability);
    void sample_emitter(std::size_t path, const PathVertex& vertex);
    void add_shadow(std::size_t path, const PathVertex& vertex, const BsdfValue& value, const vec3& light,
                    const Ray& ray, float mis_weight = 1);
    void trace_shadows();
    bool go_on(Path& path, const PathVertex& vertex, Ray& next);
    bool survives(Path& path, int vertex) const;
    void clamp_indirect(Terms& terms);
    bool cancelled() const { return cancel_ != nullptr && cancel_->load(std::memory_order_relaxed); }

    const scene::SceneData& scene_;
    const scene::LightSet& lights_;
    const PathSettings settings_;
    const CancelFlag* cancel_;
    const KernelChoice kernel_;
    PathWalk walk_;
    RayCounts counts_;

    std::vector<Path> paths_;
    std::vector<std::size_t> alive_; ///< the paths that have a ray
    std::vector<Ray> rays_;          ///< theirs
    std::vector<trace::Hit> hits_;
    std::vector<Shadow> shadows_;
    std::vector<Ray> shadow_rays_;
    std::vector<std::uint8_t> blocked_;
    trace::World::Scratch scratch_;
};

} // namespace glint::rendering
