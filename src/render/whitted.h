#pragma once
// Whitted's recursive backward ray tracing: one primary ray in, the light along it out, term by term.
// T. Whitted, "An Improved Illumination Model for Shaded Display", 1980; docs/light-model.md.

#include "glint/render.h"
#include "render/camera_sample.h"
#include "render/flights.h"
#include "render/ray_tree.h"
#include "scene/frozen.h"
#include "scene/media.h"

#include <memory>
#include <span>
#include <vector>

namespace glint {

struct ShadeKernels;

/// Follows rays through one scene. Holds scratch memory: one tracer for each thread.
class WhittedTracer {
  public:
    explicit WhittedTracer(const FrozenScene& scene, const CancelFlag* cancel = nullptr,
                           const KernelChoice& kernel = {})
        : WhittedTracer(scene, scene.description.whitted, cancel, kernel) {}
    /// With settings other than the scene's.
    WhittedTracer(const FrozenScene& scene, const WhittedSettings& settings,
                  const CancelFlag* cancel = nullptr, const KernelChoice& kernel = {});

    /// The light that comes back along a camera ray (unit direction), by term. `record`, if given, receives
    /// the whole ray tree; the arithmetic is the same with and without. `covered` says whether the ray hit
    /// anything.
    Terms trace(const vec3& origin, const vec3& direction, RayTree* record = nullptr,
                bool* covered = nullptr);
    /// The same for many, to the bit, level by level: all primary rays, their shadow rays, their branches …
    /// With Kernel::scalar one after another.
    /// `out` has an element for each sample. `terms` says whether they are wanted beside the radiance.
    void estimate(std::span<const CameraSample> samples, std::span<Channels> out, bool terms = true);

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
        SurfacePoint point;
        const MaterialRecord* material = nullptr;
        std::uint32_t object = 0;
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

    // One ray, its branches by recursion.
    Terms follow(Path path, bool* covered = nullptr);
    void light_surface(const Surface& surface, const Media* media, Terms& terms, int node);
    void branch(const Path& path, const Surface& surface, Terms& terms, int node);

    // A batch of rays, level by level (whitted_batch.cpp).
    void estimate_alone(std::span<const CameraSample> samples, std::span<Channels> out);
    void start(std::span<const CameraSample> samples);
    void finish(std::span<Channels> out, bool terms);
    void find_hits(Level level);
    void choose_materials(Level level);
    bool is_special(std::uint32_t object) const;
    void set_up_alone(std::size_t i);
    void add_light(const LightRecord& light, Level level);
    Level grow(Level level, int depth);
    void cross_alone(std::size_t i, int depth, Level& next);
    void launch(const Path& path, std::size_t parent, Term term, float weight, Level& next);
    void branch_alone(std::size_t i, int depth);
    Path path_of(std::size_t i, int depth) const;
    Surface surface_of(std::size_t i) const;
    Terms terms_of(std::size_t i) const;
    void put_terms(const Terms& terms, std::size_t i);
    void gather();

    // The steps of both. `node` is the ray's in the record, or −1. What is large is written where it stays:
    // copying what was just written number by number makes the processor wait.
    void start_primary(const vec3& origin, const vec3& direction, Path& path);
    void pass_hidden(const Ray& ray, Hit& hit, const Media*& media, int node = -1);
    Terms missed(const Path& path, int node) const;
    Surface surface_at(const Ray& ray, const Hit& hit) const;
    void step_off_edge(const Ray& ray, const Hit& hit, SurfacePoint& point) const;
    void interpolate(const Hit& hit, Surface& surface) const;
    bool enters(const Ray& ray, const Hit& hit) const;
    bool holds_media(std::uint32_t object) const;
    void start_terms(const Surface& surface, Terms& terms) const;
    bool reaches(std::uint32_t index, const Surface& surface, LightNode& node) const;
    void arrive(const LightRecord& light, const Surface& surface, LightNode& node) const;
    void aim(const Surface& surface, const LightNode& light, Ray& ray);
    float behind_blockers(const Ray& ray, const Surface& surface, const Media* media,
                          ShadowNode* record = nullptr);
    float walk_shadow(const Ray& ray, const Media* media, ShadowNode* record);
    void add_light(LightNode& light, const Surface& surface, Terms& terms) const;
    void limit_terms(Terms& terms) const;
    bool goes_on(const Path& path, const Surface& surface, int node) const;
    Split split_at(const Path& path, const Surface& surface, Terms& terms, int node);
    void cross(const Path& path, const Surface& surface, Split& split);
    bool refract(const Surface& surface, const vec3& n, Split& split) const;
    void reflect(const Path& path, const Surface& surface, int node, Path& next);
    void transmit(const Path& path, const Surface& surface, const Split& split, int node, Path& next);
    void absorb(const Media* media, float distance, Terms& terms, int node) const;

    // The record.
    int start_node(const Path& path);
    void note_surface(const Path& path, const Hit& hit, const Surface& surface, int node) const;
    void note_media(const Media* media, RayNode& record) const;
    void note_terms(const Terms& terms, int node) const;
    RayNode* node_at(int node) const;

    const FrozenScene& scene_;
    const WhittedSettings settings_;
    const WhittedModes modes_;
    const CancelFlag* cancel_;
    const KernelChoice kernel_;
    MediaArena arena_;
    std::vector<Hit> crossings_;
    RayCounts counts_;
    RayTree* record_ = nullptr;
    const ShadeKernels* shade_;
    MaterialRecord background_{}; ///< what is behind everything, as if it were a surface
    MaterialRecord darkness_{};
    std::unique_ptr<Flights> flights_; ///< made for the first batch, used again and again
    std::vector<Level> levels_;
    World::Scratch scratch_;
};

} // namespace glint
