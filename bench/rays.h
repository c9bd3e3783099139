#pragma once
// Camera rays and their first hits, shared by jobs and frames.

#include "model.h"
#include "peer.h"

namespace glint::bench {

/// Origin for secondary rays, offset to the side of the surface that the camera ray came from.
struct Start {
    vec3 origin{0.0f};
    vec3 normal{0.0f}; ///< unit, facing the incoming ray
};

vec3 origin_of(const Ray& ray);
vec3 direction_of(const Ray& ray);
Ray make_ray(const vec3& origin, const vec3& direction, float tmax);

/// The camera ray through the centre of a pixel.
Ray camera_ray(const Camera& camera, int size, int x, int y);

/// Returns false if the triangle is degenerate.
bool find_start(const Model& model, const Ray& ray, const Hit& hit, Start& start);

/// All camera rays of the picture in tiles of 8 × 8 pixels, and their hits.
struct FirstHits {
    std::vector<Ray> rays;
    std::vector<Start> starts;      ///< of rays that hit
    std::vector<std::uint32_t> ray; ///< index of the ray of each start
};
FirstHits find_first_hits(const Model& model, const tracing::Mesh& reference, int size);

} // namespace glint::bench
