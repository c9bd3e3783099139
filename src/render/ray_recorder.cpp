#include "render/ray_recorder.h"

#include <utility>

namespace glint::rendering {

using trace::Hit;

void RayRecorder::begin_ray(RayKind kind, int depth, const SpawnedRay& spawned) {
    const std::size_t index = tree_.nodes.size();
    RayNode ray;
    ray.kind = kind;
    ray.depth = depth;
    ray.origin = spawned.origin;
    ray.direction = spawned.direction;
    if (!open_.empty()) {
        ray.parent = static_cast<int>(open_.back());
        (kind == RayKind::reflected ? node().reflected : node().refracted) = static_cast<int>(index);
    }
    tree_.nodes.push_back(std::move(ray));
    open_.push_back(index);
}

void RayRecorder::pass_over(const Hit& hit) { node().passed_over.push_back(hit); }

void RayRecorder::miss(std::vector<std::uint32_t> interiors) {
    node().end = interiors.empty() ? RayEnd::background : RayEnd::absorbed;
    node().interiors = std::move(interiors);
}

void RayRecorder::hit(const Hit& hit, const SurfaceInteraction& at, std::vector<std::uint32_t> interiors) {
    RayNode& ray = node();
    ray.hit = hit;
    ray.position = at.surface.p;
    ray.geometric_normal = at.surface.n_g;
    ray.shading_normal = at.surface.n;
    ray.color = at.surface.color;
    ray.lit_side = at.surface.lit_side;
    ray.entering = at.entering;
    ray.interiors = std::move(interiors);
}

void RayRecorder::end_at(RayEnd end) { node().end = end; }

void RayRecorder::refract(const Refraction& refraction, float index_before, float index_after) {
    RayNode& ray = node();
    ray.refraction = refraction;
    ray.total_reflection = refraction.total;
    ray.index_before = index_before;
    ray.index_after = index_after;
}

void RayRecorder::bounce(float local_weight, const Bounce& bounce, const MaterialRecord& material) {
    RayNode& ray = node();
    ray.end = RayEnd::bounced;
    ray.local_weight = local_weight;
    ray.reflected_weight = bounce.split.reflected;
    ray.refracted_weight = bounce.split.refracted;
    ray.reflected_tint = material.reflected_tint;
    ray.refracted_tint = bounce.tint;
}

void RayRecorder::absorb(const vec3& transmittance) { node().transmittance = transmittance; }

void RayRecorder::end_ray(const Channels& channels) {
    RayNode& ray = node();
    if (ray.reflected < 0 && ray.reflected_weight > 0.0f) ++ray.left_out;
    if (ray.refracted < 0 && ray.refracted_weight > 0.0f) ++ray.left_out;
    if (ray.left_out > 0 && ray.reflected < 0 && ray.refracted < 0) ray.end = RayEnd::min_weight;
    ray.terms = channels.terms;
    ray.radiance = channels.radiance;
    open_.pop_back();
}

void RayRecorder::begin_light(const LightArrival& arrival) {
    LightNode& light = node().lights.emplace_back();
    light.direction = arrival.direction;
    light.distance = arrival.distance;
    light.cosine = arrival.cosine;
    light.arriving = arrival.arriving;
}

void RayRecorder::shadow_ray(const Ray& ray) {
    LightNode& light = node().lights.back();
    light.asked = true;
    light.shadow_origin = ray.origin;
    light.shadow_direction = ray.direction;
}

void RayRecorder::blocker(const Hit& hit, float transparency, bool passed_over) {
    Blocker& blocker = node().lights.back().blockers.emplace_back();
    blocker.object = hit.object;
    blocker.distance = hit.t;
    blocker.transparency = transparency;
    blocker.passed_over = passed_over;
}

void RayRecorder::end_light(const vec3& passing, const ShownLight& shown) {
    LightNode& light = node().lights.back();
    light.shadow = std::max({passing.x, passing.y, passing.z});
    light.passing = passing;
    light.diffuse = shown.diffuse;
    light.highlight = shown.highlight;
}

} // namespace glint::rendering
