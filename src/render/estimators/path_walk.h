#pragma once
// What path tracers share: the surfaces that a path meets, the media that it goes through, how far it goes,
// and the light that reaches its vertices from lights.

#include "render/camera_sampler.h"
#include "render/estimators/whitted.h"
#include "shading/bsdf.shared.h"

#include <functional>
#include <vector>

namespace glint::rendering {

/// The settings of a scene's integrator: those of [path], with what its name changes.
PathSettings path_settings(const SceneDescription& scene);

/// A surface that a path meets.
struct PathVertex {
    SurfaceInteraction at;
    Bsdf bsdf{};
    vec3 emission{0.0f};                  ///< toward the viewer
    const InteriorList* before = nullptr; ///< the solids on the viewer's side
    const InteriorList* beyond = nullptr; ///< and on the other
    bool refracts = false;                ///< bounds a transparent solid; else it is opaque or a thin pane

    /// The solids around a ray that leaves in a direction.
    const InteriorList* around(const vec3& direction) const {
        return dot(direction, at.surface.n_g) > 0.0f ? before : beyond;
    }
};

/// A direction in which a path leaves a vertex.
struct PathStep {
    BsdfSample sample{};
    bool crosses = false; ///< straight through: neither a bounce nor a vertex
};

/// How far a path has come.
struct PathLength {
    int bounces = 0;
    int diffuse = 0;   ///< bounces that are not specular
    int crossed = 0;   ///< surfaces that it went straight through
    bool last = false; ///< its last ray, which collects emission and background alone

    /// Counts a step. False if the path ends before it.
    bool grow(const PathStep& step, const PathSettings& settings);
};

/// What arrives along a shadow ray.
struct PassedLight {
    vec3 share{0.0f};
    bool through_solids = false; ///< of glass, unbent (PathShadows::transmissive)
};

/// Holds scratch memory: one for each thread. The scene must outlive it.
class PathWalk {
  public:
    PathWalk(const scene::SceneData& scene, const PathSettings& settings, const CancelFlag* cancel,
             const KernelChoice& kernel);

    /// Starts a path, or several at once: invalidates all lists, returns that of the solids around the eye.
    const InteriorList* start() { return solids_.start(); }
    /// Sets the vertex where a ray ends that hit something; replaces hits that are not seen, and updates
    /// `interior`, to the end of the ray. False if nothing is seen.
    bool find_vertex(const Ray& ray, trace::Hit& hit, const InteriorList*& interior, PathVertex& vertex);
    /// What the medium around a ray leaves of light over a distance.
    vec3 left_by_medium(const InteriorList* interior, float distance) const;
    /// The background, to a ray that hits nothing; a ray that never leaves a solid sees none.
    vec3 background(const InteriorList* interior) const;

    /// A direction in which the path goes on, with weights that include what coincident surfaces take.
    PathStep step(const PathVertex& from, const PathLength& length, const SampleNumbers& numbers) const;
    /// The ray that leaves the vertex so. Sets `interior` to the solids around it.
    Ray next_ray(const PathVertex& from, const BsdfSample& sample, const InteriorList*& interior) const;

    /// The light that passes along a shadow ray; `occluded`: it hits something.
    PassedLight passing(const Ray& shadow, bool occluded, const InteriorList* interior);

  private:
    Bsdf bsdf_of(const SurfaceInteraction& at, const BsdfSides& sides) const {
        return bsdf_at(*at.material, at.surface, sides, modes_);
    }
    PassedLight passing_all(const Ray& shadow, const InteriorList* interior);
    vec3 passing_panes(const Ray& shadow, const InteriorList* interior);
    vec3 straight_share(const Ray& ray, const trace::Hit& hit, const InteriorList* interior) const;

    const scene::SceneData& scene_;
    const WhittedModes modes_;
    const bool exact_shadows_;
    Whitted solids_; ///< keeps the lists of solids around rays
    std::vector<trace::Hit> blockers_;
    Coincidence met_;
    const trace::EndsSearch ends_shadow_; ///< at a hit that lets no light pass
};

} // namespace glint::rendering
