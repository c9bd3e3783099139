#pragma once
// Rays and surfaces: what the reference tracer and the frames share.

#include "model.h"
#include "peer.h"

namespace glint::bench {

/// A point to start rays from, off the surface on the side that was seen.
struct Start {
    vec3 origin{0.0f};
    vec3 normal{0.0f}; ///< unit, towards where the ray came from
};

vec3 origin_of(const Ray& ray);
vec3 direction_of(const Ray& ray);
Ray make_ray(const vec3& origin, const vec3& direction, float tmax);

/// Through the middle of a pixel.
Ray camera_ray(const Camera& camera, int size, int x, int y);

/// False where the triangle has no area.
bool find_start(const Model& model, const Ray& ray, const Hit& hit, Start& start);

/// All rays of the picture in tiles of 8 × 8 pixels, and where they hit.
struct FirstHits {
    std::vector<Ray> rays;
    std::vector<Start> starts;      ///< of the rays that hit
    std::vector<std::uint32_t> ray; ///< whose start each is
};
FirstHits find_first_hits(const Model& model, const tracing::Mesh& reference, int size);

} // namespace glint::bench
