#include "render/estimators/path.h"

#include "shading/light_sampling.shared.h"

#include <algorithm>
#include <cmath>

namespace glint::rendering {

using trace::Hit;
namespace {

/// So many lights without extent are summed where the camera looks, directly or by mirrors and glass.
/// Elsewhere one is chosen.
constexpr std::size_t summed_lights = 8;

BsdfValue scaled(const BsdfValue& value, const vec3& factor) {
    return {value.diffuse * factor, value.specular * factor, value.transmission * factor};
}

/// Adds light to the terms of direct or indirect light, of which `diffuse` is the first.
void add(Terms& terms, PathTerm diffuse, const BsdfValue& light) {
    vec3* term = &terms[diffuse];
    term[0] = term[0] + light.diffuse;
    term[1] = term[1] + light.specular;
    term[2] = term[2] + light.transmission;
}

/// What part of the sum each has.
BsdfValue shares_of(const BsdfValue& value) {
    vec3 sum = sum_of(value);
    for (int i = 0; i < 3; ++i)
        if (!(sum[i] > 0.0f)) sum[i] = 1.0f;
    return {value.diffuse / sum, value.specular / sum, value.transmission / sum};
}

scene::LightReceiver receiver_at(const PathVertex& vertex) {
    return {vertex.at.surface.p, vertex.at.surface.n, lets_through(vertex.bsdf.facets)};
}

} // namespace

PathTracer::PathTracer(const scene::SceneData& scene, const CancelFlag* cancel, const KernelChoice& kernel)
    : scene_(scene), lights_(*scene.light_set), settings_(path_settings(scene.description)), cancel_(cancel),
      kernel_(kernel), walk_(scene, settings_, cancel, kernel) {}

void PathTracer::estimate(std::span<const CameraSample> samples, std::span<Channels> out, bool /*terms*/) {
    const std::size_t at_once = kernel_.kernel == Kernel::scalar ? 1 : samples.size();
    for (std::size_t i = 0; i < samples.size(); i += at_once)
        trace(samples.subspan(i, at_once), out.subspan(i, at_once));
}

void PathTracer::trace(std::span<const CameraSample> samples, std::span<Channels> out) {
    start(samples);
    for (RayHint hint = RayHint::coherent; !alive_.empty() && !cancelled(); hint = RayHint::incoherent) {
        hits_.resize(rays_.size());
        scene_.world.closest(rays_, hits_, hint, scratch_, kernel_);
        extend_paths();
        trace_shadows();
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (settings_.clamp_indirect > 0) clamp_indirect(paths_[i].terms);
        out[i] = {paths_[i].terms.sum(), paths_[i].terms, paths_[i].covered};
    }
}

void PathTracer::start(std::span<const CameraSample> samples) {
    const InteriorList* around_eye = walk_.start();
    paths_.assign(samples.size(), {});
    alive_.clear();
    rays_.clear();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const CameraSample& sample = samples[i];
        paths_[i].numbers = SampleNumbers(scene_.description.render, sample.pixel, sample.index);
        paths_[i].interior = around_eye;
        alive_.push_back(i);
        rays_.push_back(ray_of({sample.origin, sample.direction, infinite_t()}));
    }
    counts_.primary += samples.size();
}

/// From the hits of their rays to the next ones; paths that end are dropped.
void PathTracer::extend_paths() {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < alive_.size(); ++k) {
        Ray next;
        if (!extend(alive_[k], rays_[k], hits_[k], next)) continue;
        alive_[kept] = alive_[k];
        rays_[kept] = next;
        ++kept;
    }
    alive_.resize(kept);
    rays_.resize(kept);
}

/// False if the path ends.
bool PathTracer::extend(std::size_t number, const Ray& ray, Hit& hit, Ray& next) {
    Path& path = paths_[number];
    const InteriorList* around = path.interior;
    PathVertex vertex;
    if (!walk_.find_vertex(ray, hit, path.interior, vertex)) {
        add_light(path, walk_.background(around));
        return false;
    }
    path.covered = true;
    path.throughput = path.throughput * walk_.left_by_medium(path.interior, hit.t);
    if (!is_dark(vertex.emission)) add_light(path, vertex.emission * weight_of_emission(path, vertex, hit));
    if (!path.length.last && has_spread(vertex.bsdf)) sample_lights(number, vertex);
    return go_on(path, vertex, next);
}

/// Adds light that the path's ray has found.
void PathTracer::add_light(Path& path, const vec3& light) {
    const vec3 arriving = path.throughput * light;
    const bool direct = path.length.bounces == 1;
    if (path.length.bounces == 0)
        path.terms[PathTerm::emission] = path.terms[PathTerm::emission] + arriving;
    else
        add(path.terms, direct ? PathTerm::direct_diffuse : PathTerm::indirect_diffuse,
            scaled(path.shares, arriving));
}

/// Of light that sampling has found and that the path's rays may find too.
float PathTracer::weight_of_emission(const Path& path, const PathVertex& vertex, const Hit& hit) const {
    const std::uint32_t number = lights_.emitter_of(hit.object, hit.prim);
    if (number == invalid_index) return 1.0f;
    if (path.through_glass && settings_.shadows == PathShadows::transmissive) return 0.0f;
    if (!(path.pdf > 0.0f)) return 1.0f;
    const SurfaceRecord& s = vertex.at.surface;
    return mis_weight(path.pdf, lights_.probability(number, path.from) *
                                    emitter_pdf(lights_.emitters[number], path.from.p, s.p, s.n_g));
}

/// Scales indirect light down to the largest radiance that it may have.
void PathTracer::clamp_indirect(Terms& terms) {
    vec3* indirect = &terms[PathTerm::indirect_diffuse];
    const vec3 all = terms.sum();
    const float most = static_cast<float>(settings_.clamp_indirect);
    const float largest = max_channel((indirect[0] + indirect[1]) + indirect[2]);
    if (largest > most)
        for (int i = 0; i < 3; ++i) indirect[i] = indirect[i] * (most / largest);
    counts_.light += static_cast<double>(all.x + all.y + all.z);
    counts_.clamped += static_cast<double>(dot(all - terms.sum(), vec3(1.0f)));
}

// ── Sampling of lights ──

void PathTracer::sample_lights(std::size_t number, const PathVertex& vertex) {
    const Path& path = paths_[number];
    if (path.length.diffuse == 0 && scene_.lights.size() <= summed_lights) {
        for (const LightRecord& light : scene_.lights) sample_point(number, vertex, light, 1.0f);
    } else if (!lights_.points.empty()) {
        const auto chosen = lights_.points.choose(path.numbers.point_light(path.length.bounces));
        sample_point(number, vertex, scene_.lights[chosen.light], chosen.probability);
    }
    if (!lights_.emitters.empty()) sample_emitter(number, vertex);
}

void PathTracer::sample_point(std::size_t path, const PathVertex& vertex, const LightRecord& light,
                              float probability) {
    const LightArrival arrival = light_arrival(light, vertex.at.surface);
    add_shadow(path, vertex, bsdf_value(vertex.bsdf, arrival.direction),
               facing_irradiance(light, arrival) / probability,
               ray_of(shadow_ray(light, vertex.at.surface, arrival)));
}

void PathTracer::sample_emitter(std::size_t number, const PathVertex& vertex) {
    const Path& path = paths_[number];
    const SurfaceRecord& s = vertex.at.surface;
    const auto chosen = lights_.choose(receiver_at(vertex), path.numbers.emitter(path.length.bounces));
    if (!(chosen.probability > 0.0f)) return;
    const vec2 u = path.numbers.light(path.length.bounces);
    const EmitterRecord& emitter = lights_.emitters[chosen.light];
    const EmitterSample sample = glint::sample_emitter(emitter, s.p, u.x, u.y);
    if (!(sample.pdf > 0.0f)) return;
    const float pdf = chosen.probability * sample.pdf;
    const float weight = mis_weight(pdf, bsdf_pdf(vertex.bsdf, sample.direction));
    const MaterialRecord& material = scene_.materials[scene_.objects[emitter.object].material];
    const vec3 emission = emitted(material, dot(sample.n, sample.direction) < 0.0f) * material.opacity;
    Ray ray = ray_of(spawn_ray(s, sample.direction));
    ray.direction = end_before(emitter, sample) - ray.origin;
    ray.tmax = 1.0f;
    add_shadow(number, vertex, bsdf_value(vertex.bsdf, sample.direction), emission * (weight / pdf), ray,
               weight);
}

/// Adds light from the direction of a ray to the path, if nothing is on its way.
void PathTracer::add_shadow(std::size_t number, const PathVertex& vertex, const BsdfValue& value,
                            const vec3& light, const Ray& ray, float mis_weight) {
    const Path& path = paths_[number];
    const vec3 sum = sum_of(value);
    if (is_dark(sum) || is_dark(light)) return;
    const bool direct = path.length.bounces == 0;
    const vec3 weight = path.throughput * light;
    shadows_.push_back({number, vertex.around(ray.direction),
                        direct ? scaled(value, weight) : scaled(path.shares, weight * sum),
                        direct ? PathTerm::direct_diffuse : PathTerm::indirect_diffuse, mis_weight});
    shadow_rays_.push_back(ray);
}

void PathTracer::trace_shadows() {
    blocked_.resize(shadow_rays_.size());
    scene_.world.occluded(shadow_rays_, blocked_, RayHint::incoherent, scratch_, kernel_);
    counts_.shadow += shadow_rays_.size();
    for (std::size_t k = 0; k < shadows_.size(); ++k) {
        const Shadow& shadow = shadows_[k];
        const PassedLight passed = walk_.passing(shadow_rays_[k], blocked_[k] != 0, shadow.interior);
        // What shines through solids unbent is not counted where paths find it.
        const vec3 share = passed.through_solids ? passed.share / shadow.mis_weight : passed.share;
        add(paths_[shadow.path].terms, shadow.term, scaled(shadow.light, share));
    }
    shadows_.clear();
    shadow_rays_.clear();
}

// ── The next ray ──

/// False if the path ends.
bool PathTracer::go_on(Path& path, const PathVertex& vertex, Ray& next) {
    const int number = path.length.bounces;
    const PathStep step = walk_.step(vertex, path.length, path.numbers);
    path.throughput = path.throughput * sum_of(step.sample.weight);
    if (is_dark(path.throughput) || !path.length.grow(step, settings_)) return false;
    next = walk_.next_ray(vertex, step.sample, path.interior);
    ++(step.sample.transmits ? counts_.refracted : counts_.reflected);
    if (step.crosses) return true;
    if (number == 0) path.shares = shares_of(step.sample.weight);
    path.from = receiver_at(vertex);
    path.pdf = step.sample.pdf;
    const bool in_glass = step.sample.transmits && vertex.refracts && path.length.diffuse > 0;
    path.through_glass = step.sample.delta && (path.through_glass || in_glass);
    path.radiance_scale = path.radiance_scale * step.sample.radiance_scale;
    return survives(path, number);
}

/// Russian roulette, by what the path can still bring once it has left all glass. What goes on weighs more.
bool PathTracer::survives(Path& path, int vertex) const {
    if (path.length.bounces < settings_.roulette_depth) return true;
    const float survival = std::min(0.95f, max_channel(path.throughput / path.radiance_scale));
    if (path.numbers.roulette(vertex) >= survival) return false;
    path.throughput = path.throughput / survival;
    return true;
}

} // namespace glint::rendering
