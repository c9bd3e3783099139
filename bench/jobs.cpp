// Making the sets of rays.

#include "jobs.h"

#include "math/random.shared.h"
#include "rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace glint::bench {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Cosine-distributed direction about the normal: sample `index` of ray `key`.
vec3 cosine_direction(const vec3& normal, uint key, uint index) {
    const vec2 draw = sample_pair(key, index, 0);
    const vec3 aside = glm::normalize(
        glm::cross(normal, std::abs(normal.x) > 0.5f ? vec3(0.0f, 1.0f, 0.0f) : vec3(1.0f, 0.0f, 0.0f)));
    const vec3 along = glm::cross(normal, aside);
    const float angle = 6.2831853f * draw.x;
    const float radius = std::sqrt(draw.y);
    return aside * (radius * std::cos(angle)) + along * (radius * std::sin(angle)) +
           normal * std::sqrt(1.0f - draw.y);
}

std::vector<Ray> shadow_rays(const Model& model, const FirstHits& first) {
    std::vector<Ray> rays;
    for (const Start& start : first.starts)
        rays.push_back(make_ray(start.origin, model.light - start.origin, 1.0f));
    return rays;
}

std::vector<Ray> scattered_rays(const FirstHits& first, uint count, uint key, float length) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < first.starts.size(); ++i)
        for (uint k = 0; k < count; ++k) {
            const Start& start = first.starts[i];
            const vec3 way = cosine_direction(start.normal, hash_with(key, first.ray[i]), k);
            rays.push_back(make_ray(start.origin, way, length));
        }
    return rays;
}

/// A job over precomputed rays in batches.
Job ray_job(const std::string& name, std::vector<Ray> made, bool any, RayHint hint, std::size_t batch) {
    const auto rays = std::make_shared<const std::vector<Ray>>(std::move(made));
    Job job{name, rays->size(), (rays->size() + batch - 1) / batch, {}, {}};
    if (any)
        job.empty_answers.blocked.resize(rays->size());
    else
        job.empty_answers.hits.resize(rays->size());
    job.run = [=](const Peer& peer, std::size_t number, Answers& answers) {
        const std::size_t first = number * batch;
        const std::size_t count = std::min(batch, rays->size() - first);
        const std::span<const Ray> part(rays->data() + first, count);
        if (any)
            peer.occluded(part, {answers.blocked.data() + first, count}, hint);
        else
            peer.closest(part, {answers.hits.data() + first, count}, hint);
    };
    return job;
}

} // namespace

Job make_job(const std::string& name, const Model& model, const tracing::Mesh& reference,
             const JobOptions& options) {
    if (name == "frame") return frame_job(model, reference, options);
    FirstHits first = find_first_hits(model, reference, options.size);
    if (name == "shadow")
        return ray_job(name, shadow_rays(model, first), true, RayHint::coherent, options.batch);
    if (name == "ao")
        return ray_job(name, scattered_rays(first, 4, 1, 0.1f * model.diagonal), true, RayHint::incoherent,
                       options.batch);
    if (name == "bounce")
        return ray_job(name, scattered_rays(first, 1, 2, infinity), false, RayHint::incoherent,
                       options.batch);
    return ray_job(name, std::move(first.rays), false, RayHint::coherent, options.batch);
}

} // namespace glint::bench
