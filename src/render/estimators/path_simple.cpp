#include "render/estimators/path_simple.h"

#include "shading/light_sampling.shared.h"

namespace glint::rendering {

PathSimple::PathSimple(const scene::SceneData& scene, const CancelFlag* cancel, const KernelChoice& kernel)
    : scene_(scene), settings_(path_settings(scene.description)), cancel_(cancel), kernel_(kernel),
      walk_(scene, settings_, cancel, kernel) {}

void PathSimple::estimate(std::span<const CameraSample> samples, std::span<Channels> out, bool /*terms*/) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
        out[i] = trace(samples[i]);
        out[i].terms[Term::emission] = out[i].radiance; // films of several samples sum terms
    }
}

Channels PathSimple::trace(const CameraSample& sample) {
    const SampleNumbers numbers(scene_.description.render, sample.pixel, sample.index);
    Channels out;
    Ray ray = ray_of({sample.origin, sample.direction, infinite_t()});
    const InteriorList* interior = walk_.start();
    vec3 throughput(1.0f); // the share of a ray's light that reaches the sample
    ++counts_.primary;
    for (PathLength length; !cancelled();) {
        // What the ray meets, and what the medium leaves of the light from there.
        trace::Hit hit = scene_.world.closest(ray, kernel_);
        const InteriorList* around = interior;
        PathVertex vertex;
        if (!walk_.find_vertex(ray, hit, interior, vertex)) {
            out.radiance = out.radiance + throughput * walk_.background(around);
            break;
        }
        out.covered = true;
        throughput = throughput * walk_.left_by_medium(interior, hit.t);

        // Light that the surface emits, and what it reflects of lights that no ray can hit.
        vec3 light = vertex.emission;
        if (!length.last) light = light + light_of_points(vertex);
        out.radiance = out.radiance + throughput * light;

        // All other light: from one direction, as likely as the material reflects light from there.
        const PathStep step = walk_.step(vertex, length, numbers);
        throughput = throughput * sum_of(step.sample.weight);
        if (is_dark(throughput) || !length.grow(step, settings_)) break;
        ray = walk_.next_ray(vertex, step.sample, interior);
        ++(step.sample.transmits ? counts_.refracted : counts_.reflected);
    }
    return out;
}

/// Light of all lights without extent that leaves the surface toward the viewer.
vec3 PathSimple::light_of_points(const PathVertex& vertex) {
    vec3 light(0.0f);
    if (!has_spread(vertex.bsdf)) return light;
    for (const LightRecord& source : scene_.lights) {
        const LightArrival arrival = light_arrival(source, vertex.at.surface);
        const vec3 value = sum_of(bsdf_value(vertex.bsdf, arrival.direction));
        if (is_dark(value)) continue;
        const Ray shadow = ray_of(shadow_ray(source, vertex.at.surface, arrival));
        ++counts_.shadow;
        const PassedLight passed =
            walk_.passing(shadow, scene_.world.occluded(shadow, kernel_), vertex.around(arrival.direction));
        light = light + value * facing_irradiance(source, arrival) * passed.share;
    }
    return light;
}

} // namespace glint::rendering
