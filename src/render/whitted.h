#pragma once
// Whitted's recursive backward ray tracing: one primary ray in, the light along it out, term by term.
// T. Whitted, "An Improved Illumination Model for Shaded Display", 1980; docs/light-model.md.

#include "render/ray_tree.h"
#include "scene/frozen.h"
#include "scene/media.h"

namespace glint {

struct RayCounts {
    std::uint64_t primary = 0;
    std::uint64_t reflected = 0;
    std::uint64_t refracted = 0;
    std::uint64_t shadow = 0;
};

/// Follows rays through one scene. Holds scratch memory: one tracer for each thread.
class WhittedTracer {
  public:
    explicit WhittedTracer(const FrozenScene& scene, const CancelFlag* cancel = nullptr);

    /// The light that comes back along a camera ray (unit direction), by term. `record`, if given, receives
    /// the whole ray tree; the arithmetic is the same with and without.
    Terms trace(const vec3& origin, const vec3& direction, RayTree* record = nullptr);

    /// Did the last primary ray hit anything?
    bool covered() const { return covered_; }
    const RayCounts& counts() const { return counts_; }

  private:
    /// A ray on its way.
    struct Path {
        vec3 origin;
        vec3 direction;
        const Media* media = nullptr;
        int depth = 0;
        RayKind kind = RayKind::primary;
        int parent = -1;
    };
    /// A hit, ready to be shaded.
    struct Surface {
        const FrozenMaterial* material = nullptr;
        std::uint32_t object = 0;
        SurfacePoint point;
        vec3 v{0.0f};          ///< to the viewer
        vec3 n_g{0.0f};        ///< geometric normal toward the viewer
        vec3 n{0.0f};          ///< shading normal on the side of n_g
        float lit_side = 1.0f; ///< −1: lights find both normals turned away from the viewer (Facing::stored)
        vec3 color{0.0f};
        bool entering = true;
    };
    /// How the light is shared between the two branches of a bounce.
    struct Split {
        float reflected = 0;
        float refracted = 0;
        vec3 direction{0.0f}; ///< of the refracted branch
        const Media* media = nullptr;
        float index_before = 1;
        float index_after = 1;
        bool total = false;
    };

    Terms follow(Path path);
    Hit visible_hit(const Ray& ray, const Media*& media);
    Terms missed(const Path& path, int node);
    Surface surface_at(const Ray& ray, const Hit& hit) const;
    void step_off_edge(const Ray& ray, const Hit& hit, SurfacePoint& point) const;
    void interpolate(const Hit& hit, Surface& surface) const;
    bool enters(const Ray& ray, const Hit& hit) const;
    bool holds_media(std::uint32_t object) const;
    Terms local_terms(const Surface& surface, const Media* media, int node);
    LightNode light_at(std::uint32_t index, const Surface& surface, const Media* media);
    void shade_light(LightNode& light, const Surface& surface) const;
    float shadow_factor(const Surface& surface, const LightNode& light, const Media* media);
    float walk_shadow(const Ray& ray, const Media* media);
    void bounce(const Path& path, const Surface& surface, Terms& terms, int node);
    Split split_at(const Path& path, const Surface& surface);
    bool refract(const Surface& surface, const vec3& n, Split& split) const;
    vec3 branch(const Path& path, const Surface& surface, RayKind kind, const vec3& direction,
                const Media* media, int node);
    void absorb(const Media* media, float distance, Terms& terms, int node) const;
    int start_node(const Path& path);
    RayNode* node_at(int node) const;

    const FrozenScene& scene_;
    const WhittedSettings settings_;
    const CancelFlag* cancel_;
    MediaArena arena_;
    std::vector<Hit> crossings_;
    RayCounts counts_;
    RayTree* record_ = nullptr;
    bool covered_ = false;
};

} // namespace glint
