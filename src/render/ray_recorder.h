#pragma once
// Listens to an estimator and keeps what each ray met and computed: the ray tree that explains a pixel.
// Recording changes no result; an estimator without a recorder pays one test of a pointer for each call here.

#include "render/ray_tree.h"
#include "render/surface_interaction.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace glint {

class RayRecorder {
  public:
    /// Empties the tree first.
    explicit RayRecorder(RayTree& tree) : tree_(tree) { tree_.nodes.clear(); }

    // One ray: begin_ray(), then what it meets, with its branches between, then end_ray().
    void begin_ray(RayKind kind, int depth, const vec3& origin, const vec3& direction);
    void skip_hidden(const trace::Hit& hit);
    void miss(const InteriorList* interior);
    void hit(const trace::Hit& hit, const SurfaceInteraction& at, const InteriorList* interior);
    void end_at(RayEnd end);
    void bounce(float local_weight, const Bounce& bounce);
    void absorb(const vec3& transmittance);
    void end_ray(const Channels& channels);

    // One light at a hit: begin_light(), its shadow ray if one is sent, end_light().
    void begin_light(std::uint32_t light, const LightArrival& arrival);
    void shadow_ray(const Ray& ray);
    void blocker(const BlockerNode& blocker);
    void end_light(float passing, const ShownLight& shown);

  private:
    RayNode& node() { return tree_.nodes[open_.back()]; }

    RayTree& tree_;
    std::vector<std::size_t> open_; ///< the rays that have begun and not ended, parents first
};

} // namespace glint
