#pragma once
// Whitted's ray tracing of many camera rays at once: a wave holds paths of one depth. Its rays are traced
// together, then light by light its shadow rays, and shaded in vectors (render/shade_batch.h); then its
// branches are followed in the same way, as many at once as a wave may hold. Results have the bits of
// Whitted, which shades glass, and follows branches for which PathStates has no room.

#include "render/estimators/path_states.h"
#include "render/estimators/whitted.h"

#include <memory>
#include <span>

namespace glint::rendering {

struct ShadeKernels;

/// Holds scratch memory: one for each thread. The scene must outlive it.
class WhittedWavefront {
  public:
    /// `settings` stand for those of the scene's description.
    WhittedWavefront(const scene::SceneData& scene, const WhittedSettings& settings,
                     const CancelFlag* cancel = nullptr, const KernelChoice& kernel = {});

    /// `out` has an element for each sample; its terms are set if `terms`. Unchanged if `cancel` was set.
    void estimate(std::span<const CameraSample> samples, std::span<Channels> out, bool terms = true);

    RayCounts counts() const { return counts_ + single_.counts(); }

  private:
    void estimate_batch(std::span<const CameraSample> samples, std::span<Channels> out, bool terms);
    void follow(Wave wave, int depth);
    void follow_branches(Wave wave, int depth);
    Wave parents_of(Wave wave, std::size_t branches) const;
    std::size_t max_branches(Wave wave) const;
    void start(std::span<const CameraSample> samples);
    void finish(std::span<Channels> out, bool terms);
    void find_hits(Wave wave);
    void choose_materials(Wave wave);
    void locate_surfaces(Wave wave);
    bool needs_attributes(std::uint32_t object) const;
    void put_surface(std::size_t i);
    void add_light(const LightRecord& light, Wave wave);
    void pass_blockers(Wave wave);
    Wave spawn(Wave parents, std::size_t first, int depth);
    void spawn_at_glass(std::size_t i, int depth, Wave& next);
    void spawn(const Whitted::Path& path, std::size_t parent, Term term, const vec3& weight, Wave& next);
    void branch_by_recursion(std::size_t i, int depth);
    void weigh_local_terms(std::size_t i);
    void meet_media(Wave wave);
    void absorb(Wave wave);
    bool is_cancelled() const { return cancel_ != nullptr && cancel_->load(std::memory_order_relaxed); }

    Whitted::Path path_at(std::size_t i, int depth) const;
    SurfaceInteraction surface_at(std::size_t i) const;
    Terms terms_at(std::size_t i) const;
    void put_terms(const Terms& terms, std::size_t i);

    const scene::SceneData& scene_;
    const WhittedModes modes_;
    const int max_depth_;
    const float min_weight_;
    const CancelFlag* cancel_;
    const KernelChoice kernel_;
    const ShadeKernels& shade_;
    Whitted single_;
    RayCounts counts_;            ///< beside those of single_
    MaterialRecord background_{}; ///< for rays that hit nothing
    MaterialRecord darkness_{};   ///< for rays that hit nothing from inside a solid
    std::unique_ptr<PathStates> states_;
    trace::World::Scratch scratch_;
};

} // namespace glint::rendering
