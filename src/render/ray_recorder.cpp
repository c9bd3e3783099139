#include "render/ray_recorder.h"

#include <utility>

namespace glint {

using trace::Hit;
namespace {

std::vector<std::uint32_t> objects_of(const InteriorList* interior) {
    std::vector<std::uint32_t> objects;
    for (; interior != nullptr; interior = interior->rest) objects.push_back(interior->object);
    return objects;
}

} // namespace

void RayRecorder::begin_ray(RayKind kind, int depth, const vec3& origin, const vec3& direction) {
    const std::size_t index = tree_.nodes.size();
    RayNode ray;
    ray.kind = kind;
    ray.depth = depth;
    ray.origin = origin;
    ray.direction = direction;
    if (!open_.empty()) {
        ray.parent = static_cast<int>(open_.back());
        (kind == RayKind::reflected ? node().reflected : node().refracted) = static_cast<int>(index);
    }
    tree_.nodes.push_back(std::move(ray));
    open_.push_back(index);
}

void RayRecorder::skip_hidden(const Hit& hit) { node().passed_over.push_back(hit); }

void RayRecorder::miss(const InteriorList* interior) {
    node().end = interior == nullptr ? RayEnd::background : RayEnd::absorbed;
    node().interiors = objects_of(interior);
}

void RayRecorder::hit(const Hit& hit, const SurfaceInteraction& at, const InteriorList* interior) {
    RayNode& ray = node();
    ray.hit = hit;
    ray.position = at.surface.p;
    ray.geometric_normal = at.surface.n_g;
    ray.shading_normal = at.surface.n;
    ray.color = at.surface.color;
    ray.lit_side = at.surface.lit_side;
    ray.entering = at.entering;
    ray.interiors = objects_of(interior);
}

void RayRecorder::end_at(RayEnd end) { node().end = end; }

void RayRecorder::bounce(float local_weight, const Bounce& bounce) {
    RayNode& ray = node();
    ray.end = RayEnd::bounced;
    ray.local_weight = local_weight;
    ray.reflected_weight = bounce.split.reflected;
    ray.refracted_weight = bounce.split.refracted;
    ray.index_before = bounce.index_before;
    ray.index_after = bounce.index_after;
    ray.refraction = bounce.refraction;
    ray.total_reflection = bounce.refraction.total;
}

void RayRecorder::absorb(const vec3& transmittance) { node().transmittance = transmittance; }

void RayRecorder::end_ray(const Channels& channels) {
    node().terms = channels.terms;
    node().radiance = channels.radiance;
    open_.pop_back();
}

void RayRecorder::begin_light(std::uint32_t light, const LightArrival& arrival) {
    LightNode entry;
    entry.light = light;
    entry.direction = arrival.direction;
    entry.distance = arrival.distance;
    entry.cosine = arrival.cosine;
    entry.arriving = arrival.arriving;
    node().lights.push_back(entry);
    node().shadows.emplace_back();
}

void RayRecorder::shadow_ray(const Ray& ray) {
    ShadowNode& shadow = node().shadows.back();
    shadow.asked = true;
    shadow.origin = ray.origin;
    shadow.direction = ray.direction;
}

void RayRecorder::blocker(const BlockerNode& blocker) { node().shadows.back().blockers.push_back(blocker); }

void RayRecorder::end_light(float passing, const ShownLight& shown) {
    LightNode& light = node().lights.back();
    light.shadow = passing;
    light.diffuse = shown.diffuse;
    light.highlight = shown.highlight;
}

} // namespace glint
