#pragma once
// The rays of one sample as a value, which explains a pixel, and the recorder that fills it in while an
// estimator traces the sample. Recording changes no result; an estimator without a recorder pays one test of
// a pointer for each call here.

#include "render/estimators/whitted.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace glint::rendering {

struct LightNode : TracedLight {
    vec3 shadow_direction{0.0f}; ///< up to the light if that has a position, else unit
    vec3 passing{1.0f};          ///< the share that gets through, by channel
};

/// A ray, its hit, and what its explanation needs besides. The distances of blockers are in lengths of
/// `shadow_direction`.
struct RayNode : TracedRay {
    trace::Hit hit;
    float lit_side = 1;                   ///< −1: lights find both normals turned away from the viewer
    std::vector<std::uint32_t> interiors; ///< transparent solids around the ray, the owner of the space first
    std::vector<trace::Hit> passed_over;  ///< hidden inside one of those, or coincident with what is seen
    std::vector<LightNode> lights;        ///< by SceneData::lights
    Refraction refraction{};              ///< at the surface of a transparent solid
    float local_weight = 1;               ///< of ambient, diffuse, highlight and clamp
    float reflected_weight = 0;           ///< above 0 without such a branch: it was left out
    float refracted_weight = 0;
    vec3 reflected_tint{1.0f}; ///< of the branches
    vec3 refracted_tint{1.0f};
    Terms terms{}; ///< weighted, absorption included

    /// Light goes on from here, along branches or along some that were left out.
    bool goes_on() const { return end == RayEnd::bounced || end == RayEnd::min_weight; }
};

/// The weight of a branch of the node, by channel.
inline vec3 branch_weight(const RayNode& node, RayKind kind) {
    return kind == RayKind::reflected ? node.reflected_tint * node.reflected_weight
                                      : node.refracted_tint * node.refracted_weight;
}

struct RayTree {
    std::vector<RayNode> nodes; ///< the first is the primary ray; parents precede their children
};

class RayRecorder {
  public:
    /// Empties the tree first.
    explicit RayRecorder(RayTree& tree) : tree_(tree) { tree_.nodes.clear(); }

    // One ray: begin_ray(), its hit or miss, its branches, end_ray().
    void begin_ray(RayKind kind, int depth, const SpawnedRay& ray);
    void pass_over(const trace::Hit& hit);
    // `interiors` as in RayNode.
    void miss(std::vector<std::uint32_t> interiors);
    void hit(const trace::Hit& hit, const SurfaceInteraction& at, std::vector<std::uint32_t> interiors);
    void end_at(RayEnd end);
    void refract(const Refraction& refraction, float index_before, float index_after);
    void bounce(float local_weight, const Bounce& bounce, const MaterialRecord& material);
    void absorb(const vec3& transmittance);
    void end_ray(const Channels& channels);

    // One light at a hit: begin_light(), its shadow ray if one is sent, end_light().
    void begin_light(const LightArrival& arrival);
    void shadow_ray(const Ray& ray);
    void blocker(const trace::Hit& hit, float transparency, bool passed_over);
    void end_light(const vec3& passing, const ShownLight& shown);

  private:
    RayNode& node() { return tree_.nodes[open_.back()]; }

    RayTree& tree_;
    std::vector<std::size_t> open_; ///< the rays that have begun and not ended, parents first
};

} // namespace glint::rendering
