#include "render/estimators/path_walk.h"

#include <algorithm>
#include <limits>

namespace glint::rendering {

using scene::SceneData;
using trace::Hit;
namespace {

/// Whitted's settings, with the shadows of paths.
WhittedSettings whitted_settings(const SceneDescription& scene) {
    WhittedSettings settings = scene.whitted;
    settings.shadows = scene.path.shadows == PathShadows::exact ? Shadows::opaque : Shadows::transmissive;
    return settings;
}

} // namespace

PathSettings path_settings(const SceneDescription& scene) {
    PathSettings settings = scene.path;
    if (scene.render.integrator == Integrator::direct) settings.max_diffuse_bounces = 0;
    return settings;
}

bool PathLength::grow(const PathStep& step, const PathSettings& settings) {
    if (step.crosses) {
        ++crossed;
        return true;
    }
    if (last) return false;
    ++bounces;
    if (!step.sample.delta) ++diffuse;
    last = bounces > settings.max_depth || diffuse > settings.max_diffuse_bounces;
    return true;
}

PathWalk::PathWalk(const SceneData& scene, const PathSettings& settings, const CancelFlag* cancel,
                   const KernelChoice& kernel)
    : scene_(scene), modes_(scene::whitted_modes(scene.description.whitted)),
      exact_shadows_(settings.shadows == PathShadows::exact),
      solids_(scene, whitted_settings(scene.description), cancel, kernel),
      ends_shadow_([&scene](const Hit& hit) {
          const MaterialRecord& m = scene.materials[scene.objects[hit.object].material];
          return !(m.transparency > 0.0f) && m.opacity == 1.0f;
      }) {}

bool PathWalk::find_vertex(const Ray& ray, Hit& hit, const InteriorList*& interior, PathVertex& vertex) {
    const Contact contact = solids_.find_seen(ray, hit, interior);
    if (!hit) return false;
    vertex.at = surface_interaction(scene_, ray, hit, contact);
    vertex.before = interior;
    vertex.beyond = solids_.beyond(vertex.at, interior);
    vertex.refracts = contact.refracts || is_dielectric(hit.object, scene_);
    vertex.emission = emitted(*vertex.at.material, vertex.at.entering) * vertex.at.material->opacity;
    const float index_after = refractive_index(vertex.beyond, scene_);
    vertex.bsdf = bsdf_of(vertex.at, {refractive_index(interior, scene_), index_after, vertex.refracts});
    return true;
}

vec3 PathWalk::left_by_medium(const InteriorList* interior, float distance) const {
    return solids_.left_by_medium(interior, std::min(distance, std::numeric_limits<float>::max()));
}

vec3 PathWalk::background(const InteriorList* interior) const {
    return interior == nullptr ? scene_.background : vec3(0.0f);
}

PathStep PathWalk::step(const PathVertex& from, const PathLength& length,
                        const SampleNumbers& numbers) const {
    const float lobe = length.crossed == 0 ? numbers.lobe(length.bounces) : numbers.crossing(length.crossed);
    const vec2 u = numbers.direction(length.bounces);
    PathStep step;
    step.sample = bsdf_sample(from.bsdf, lobe, u.x, u.y);
    if (step.sample.transmits) {
        step.crosses = step.sample.straight;
        step.sample.weight.transmission =
            step.sample.weight.transmission * from.at.contact.others * from.at.contact.tint;
    }
    return step;
}

Ray PathWalk::next_ray(const PathVertex& from, const BsdfSample& sample,
                       const InteriorList*& interior) const {
    interior = sample.transmits ? from.beyond : from.before;
    return ray_of(spawn_ray(from.at.surface, sample.direction));
}

PassedLight PathWalk::passing(const Ray& shadow, bool occluded, const InteriorList* interior) {
    if (!exact_shadows_) return occluded ? passing_all(shadow, interior) : PassedLight{vec3(1.0f)};
    const vec3 left_over = left_by_medium(interior, length(shadow.direction) * shadow.tmax);
    if (!occluded) return {left_over};
    return {scene_.any_see_through ? left_over * passing_panes(shadow, interior) : vec3(0.0f)};
}

/// As by Whitted's model.
PassedLight PathWalk::passing_all(const Ray& shadow, const InteriorList* interior) {
    const PassedLight passed{solids_.light_past_blockers(shadow, interior)};
    if (is_dark(passed.share)) return passed;
    scene_.world.all_hits(shadow, blockers_);
    const auto is_solid = [&](const Hit& hit) { return is_dielectric(hit.object, scene_); };
    return {passed.share, std::any_of(blockers_.begin(), blockers_.end(), is_solid)};
}

/// The product of the shares that thin panes, and surfaces that are not there in part, let through; 0 where
/// anything else is in between.
vec3 PathWalk::passing_panes(const Ray& shadow, const InteriorList* interior) {
    const InteriorArena::Scope lists(solids_.arena());
    if (!scene_.world.all_hits(shadow, blockers_, ends_shadow_)) return vec3(0.0f);
    vec3 passing(1.0f);
    for (std::size_t i = 0; i < blockers_.size(); i += met_.hits.size()) {
        find_coincident(scene_, shadow, blockers_[i], met_);
        for (const Hit& met : met_.hits)
            if (dims_light(met, met_.hits, interior, scene_))
                passing = passing * straight_share(shadow, met, interior);
        if (is_dark(passing)) return passing;
        for (const Hit& met : met_.hits) solids_.cross(shadow, met, interior);
    }
    return passing;
}

/// The share of light that goes through a surface unbent.
vec3 PathWalk::straight_share(const Ray& ray, const Hit& hit, const InteriorList* interior) const {
    if (is_dielectric(hit.object, scene_))
        return vec3(1.0f - scene_.materials[scene_.objects[hit.object].material].opacity);
    SurfaceInteraction at = surface_interaction(scene_, ray, hit);
    at.surface.v = -normalize(ray.direction);
    const float index = refractive_index(interior, scene_);
    const Bsdf bsdf = bsdf_of(at, {index, index, false});
    return bsdf.refracted + vec3(bsdf.through);
}

} // namespace glint::rendering
