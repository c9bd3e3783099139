#pragma once
// Whitted's recursive ray tracing: a camera ray in, the light along it out, term by term. One ray after
// another; the page to read first. whitted_wavefront.h traces many rays at once. T. Whitted, "An
// Improved Illumination Model for Shaded Display", 1980; docs/light-model.md.

#include "glint/explanation.h"
#include "glint/render.h"
#include "render/camera_sample.h"
#include "render/contact.h"
#include "render/interior_list.h"
#include "scene/scene_data.h"
#include "shading/whitted.shared.h"
#include "trace/world/world.h"

#include <span>
#include <vector>

namespace glint::rendering {

class RayRecorder;
struct RayTree;

inline Ray ray_of(const SpawnedRay& spawned) {
    Ray ray;
    ray.origin = spawned.origin;
    ray.direction = spawned.direction;
    ray.tmax = spawned.tmax;
    return ray;
}

struct SurfaceInteraction {
    SurfaceRecord surface;
    const MaterialRecord* material = nullptr;
    std::uint32_t object = 0;
    bool entering = true; ///< the ray comes from the object's outer side
    Contact contact;
};

/// The surface at a hit of a ray (unit direction): off the edge that it may lie on, with colour and shading
/// normal of the mesh's vertices.
SurfaceInteraction surface_interaction(const scene::SceneData& scene, const Ray& ray, const trace::Hit& hit,
                                       const Contact& contact = {});

/// The rays that go on from a surface.
struct Bounce {
    Split split;
    const InteriorList* interior = nullptr; ///< behind the surface
    vec3 tint{1.0f};                        ///< of the refracted ray
};

/// Holds scratch memory: one for each thread. The scene must outlive it.
class Whitted {
  public:
    /// A ray on its way.
    struct Path {
        SpawnedRay ray; ///< direction of unit length
        const InteriorList* interior = nullptr;
        vec3 weight{1.0f}; ///< the share of its light that reaches the sample
        int depth = 0;     ///< bounces so far
        RayKind kind = RayKind::primary;
    };

    /// `settings` stand for those of the scene's description.
    Whitted(const scene::SceneData& scene, const WhittedSettings& settings,
            const CancelFlag* cancel = nullptr, const KernelChoice& kernel = {});
    explicit Whitted(const scene::SceneData& scene) : Whitted(scene, scene.description.whitted) {}

    /// `out` has an element for each sample. Terms are always set. Incomplete if `cancel` was set.
    void estimate(std::span<const CameraSample> samples, std::span<Channels> out, bool terms = true);
    /// One sample. `record`, if given, receives its ray tree; the arithmetic is the same with and without.
    Channels trace(const CameraSample& sample, RayTree* record = nullptr);

    const RayCounts& counts() const { return counts_; }
    /// Holds the lists of the solids around rays.
    InteriorArena& arena() { return arena_; }

    // The steps of single rays, for the rays that a wavefront does not shade in vectors.

    /// Starts a camera ray, or a batch of them: invalidates all lists, returns that of the solids around the
    /// eye.
    const InteriorList* start();
    /// Replaces a hit by the next that is seen, if it lies inside a solid of higher rank or coincides with
    /// that; updates `interior`. Returns what is met there.
    Contact find_seen(const Ray& ray, trace::Hit& hit, const InteriorList*& interior);
    /// The list behind a surface, from that before it.
    const InteriorList* beyond(const SurfaceInteraction& at, const InteriorList* interior);
    /// Sets the list to that behind a surface that the ray goes through unbent.
    void cross(const Ray& ray, const trace::Hit& hit, const InteriorList*& interior);
    /// The share of a light that passes the blockers of its shadow ray, which is known to be occluded.
    vec3 light_past_blockers(const Ray& shadow, const SurfaceInteraction& at, const InteriorList* interior);
    /// The same by the list around the ray's origin.
    vec3 light_past_blockers(const Ray& shadow, const InteriorList* interior);
    /// Mirror and refracted ray of a surface: direction and weights.
    Bounce bounce_at(const Path& path, const SurfaceInteraction& at);
    /// Whether a branch is followed that brings this share of its light to the path. Counts those that are
    /// not for their weight.
    bool follows(const Path& path, const vec3& share);
    Path reflected_path(const Path& path, const SurfaceInteraction& at, const vec3& share);
    Path refracted_path(const Path& path, const SurfaceInteraction& at, const Bounce& bounce);
    /// Follows the branches of a bounce to their ends and sets their terms.
    void follow_bounce(const Path& path, const SurfaceInteraction& at, Terms& terms);
    /// What the medium around a ray leaves of light over a distance.
    vec3 left_by_medium(const InteriorList* interior, float distance) const;

  private:
    Channels radiance(Path&& path);
    LocalTerms local_light(const Path& path, const SurfaceInteraction& at);
    vec3 light_passing(const LightRecord& light, const LightArrival& arrival, const Path& path,
                       const SurfaceInteraction& at);
    vec3 walk_shadow(const Ray& shadow, const InteriorList* interior);
    bool any_may_be_hidden(std::span<const trace::Hit> hits, const InteriorList* interior) const;
    bool bounces(const Path& path, const SurfaceInteraction& at);
    Contact contact_of_met(const Ray& ray, const trace::Hit& seen, const InteriorList* interior);
    const MaterialRecord& material_of(const trace::Hit& hit) const {
        return scene_.materials[scene_.objects[hit.object].material];
    }
    bool cancelled() const { return cancel_ != nullptr && cancel_->load(std::memory_order_relaxed); }

    const scene::SceneData& scene_;
    const WhittedModes modes_;
    const int max_depth_;
    const float min_weight_;
    const CancelFlag* cancel_;
    const KernelChoice kernel_;
    InteriorArena arena_;
    const trace::EndsSearch ends_shadow_; ///< at a hit that lets no light pass
    std::vector<trace::Hit> blockers_;
    Coincidence met_;
    RayCounts counts_;
    RayRecorder* recorder_ = nullptr;
};

} // namespace glint::rendering
