#pragma once
// The rays of one sample as a value, which explains a pixel, and the recorder that fills it in while an
// estimator traces the sample. Recording changes no result; an estimator without a recorder pays one test of
// a pointer for each call here.

#include "render/estimators/whitted.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace glint {

/// One light at one hit.
struct LightNode {
    std::uint32_t light = 0; ///< number among the lights that are not ambient
    vec3 direction{0.0f};    ///< unit, to the light
    float distance = 0;      ///< infinite for directional lights
    float cosine = 0;        ///< n·l, 0 below the geometric horizon
    vec3 arriving{0.0f};     ///< E, before shadows
    float shadow = 1;        ///< the share that passes the blockers
    vec3 diffuse{0.0f};      ///< after shadow and clamp
    vec3 highlight{0.0f};
};

/// A surface that a shadow ray met.
struct BlockerNode {
    std::uint32_t object = 0;
    float t = 0;              ///< a fraction of the way to a light with a position; otherwise a distance
    float transparency = 0;   ///< τ
    bool passed_over = false; ///< hidden inside a solid of higher rank
};

/// The shadow ray to one light.
struct ShadowNode {
    bool asked = false; ///< it was sent
    vec3 origin{0.0f};
    vec3 direction{0.0f};              ///< up to the light if that has a position, else unit
    std::vector<BlockerNode> blockers; ///< all up to the light, in order
};

/// One ray and its hit. Children are indices into RayTree::nodes, −1 for none.
struct RayNode {
    RayKind kind = RayKind::primary;
    RayEnd end = RayEnd::matte;
    int parent = -1;
    int depth = 0;
    vec3 origin{0.0f};
    vec3 direction{0.0f}; ///< unit
    trace::Hit hit;
    vec3 position{0.0f};
    vec3 geometric_normal{0.0f}; ///< toward the viewer
    vec3 shading_normal{0.0f};
    vec3 color{0.0f};
    float lit_side = 1;                   ///< −1: lights find both normals turned away from the viewer
    bool entering = true;                 ///< from the object's outer side
    std::vector<std::uint32_t> interiors; ///< transparent solids around the ray, the owner of the space first
    std::vector<trace::Hit> passed_over;  ///< hidden inside one of those
    std::vector<LightNode> lights;
    std::vector<ShadowNode> shadows; ///< parallel to lights
    float index_before = 1;          ///< indices of refraction on the two sides, where the ray goes through
    float index_after = 1;
    Refraction refraction{}; ///< at the surface of a transparent solid
    bool total_reflection = false;
    float local_weight = 1; ///< of ambient, diffuse, highlight and clamp
    float reflected_weight = 0;
    float refracted_weight = 0;
    int reflected = -1;
    int refracted = -1;
    vec3 transmittance{1.0f}; ///< of the medium up to the hit
    Terms terms{};            ///< weighted, absorption included
    vec3 radiance{0.0f};      ///< their sum
};

struct RayTree {
    std::vector<RayNode> nodes; ///< the first is the primary ray; parents precede their children
};

class RayRecorder {
  public:
    /// Empties the tree first.
    explicit RayRecorder(RayTree& tree) : tree_(tree) { tree_.nodes.clear(); }

    // One ray: begin_ray(), its hit or miss, its branches, end_ray().
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
