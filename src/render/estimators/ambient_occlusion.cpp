#include "render/estimators/ambient_occlusion.h"

#include "render/camera_sampler.h"
#include "shading/sampling.shared.h"

#include <algorithm>
#include <limits>

namespace glint::rendering {
namespace {

/// How near what darkens a surface must be.
float reach(const scene::SceneData& scene) {
    const std::optional<double>& distance = scene.description.ambient_occlusion.distance;
    if (distance) return static_cast<float>(*distance);
    const Bounds bounds = scene.world.bounds();
    if (bounds.empty()) return std::numeric_limits<float>::infinity();
    return static_cast<float>(0.1 * glm::length(dvec3(bounds.hi) - dvec3(bounds.lo)));
}

} // namespace

AmbientOcclusion::AmbientOcclusion(const scene::SceneData& scene, const CancelFlag* cancel,
                                   const KernelChoice& kernel)
    : scene_(scene), distance_(reach(scene)), colored_(scene.description.ambient_occlusion.colored),
      kernel_(kernel), single_(scene, scene.description.whitted, cancel, kernel) {}

void AmbientOcclusion::find_hits(std::span<const CameraSample> samples) {
    camera_rays_.assign(samples.size(), Ray{});
    for (std::size_t i = 0; i < samples.size(); ++i) {
        camera_rays_[i].origin = samples[i].origin;
        camera_rays_[i].direction = samples[i].direction;
    }
    hits_.resize(samples.size());
    scene_.world.closest(camera_rays_, hits_, RayHint::coherent, scratch_, kernel_);
    counts_.primary += samples.size();
}

/// Sets what a sample shows if nothing is near, and the ray that finds out.
void AmbientOcclusion::start_ray(const CameraSample& sample, std::size_t i, Channels& out) {
    const InteriorList* interior = around_eye_;
    const Contact contact = single_.find_seen(camera_rays_[i], hits_[i], interior);
    out.covered = static_cast<bool>(hits_[i]);
    out.radiance = scene_.background;
    if (!out.covered) return;
    const SurfaceRecord s = surface_interaction(scene_, camera_rays_[i], hits_[i], contact).surface;
    const vec2 u = SampleNumbers(scene_.description.render, sample.pixel, sample.index).direction(0);
    const SpawnedRay spawned = spawn_ray(s, turned_to(s.n, cosine_sample(u.x, u.y)));
    out.radiance = vec3(0.0f);
    // About a shading normal, directions may lie below the face, which blocks them itself.
    if (!(dot(spawned.direction, s.n_g) > 0.0f)) return;
    out.radiance = colored_ ? s.color : vec3(1.0f);
    Ray ray;
    ray.origin = spawned.origin;
    ray.direction = spawned.direction;
    ray.tmax = distance_;
    rays_.push_back(ray);
    sample_of_ray_.push_back(i);
}

void AmbientOcclusion::estimate(std::span<const CameraSample> samples, std::span<Channels> out,
                                bool /*terms*/) {
    find_hits(samples);
    around_eye_ = single_.start();
    rays_.clear();
    sample_of_ray_.clear();
    for (std::size_t i = 0; i < samples.size(); ++i) start_ray(samples[i], i, out[i]);
    blocked_.resize(rays_.size());
    scene_.world.occluded(rays_, blocked_, RayHint::incoherent, scratch_, kernel_);
    counts_.shadow += rays_.size();
    for (std::size_t r = 0; r < rays_.size(); ++r)
        if (blocked_[r] != 0) out[sample_of_ray_[r]].radiance = vec3(0.0f);
    // Films of several samples sum terms.
    for (Channels& channels : out.first(samples.size())) {
        channels.terms = {};
        channels.terms[Term::emission] = channels.radiance;
    }
}

} // namespace glint::rendering
