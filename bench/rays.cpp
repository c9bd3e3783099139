// Camera rays and first hits.

#include "rays.h"

#include <limits>

namespace glint::bench {

vec3 origin_of(const Ray& ray) { return {ray.origin[0], ray.origin[1], ray.origin[2]}; }
vec3 direction_of(const Ray& ray) { return {ray.direction[0], ray.direction[1], ray.direction[2]}; }

Ray make_ray(const vec3& origin, const vec3& direction, float tmax) {
    return {{origin.x, origin.y, origin.z}, 0.0f, {direction.x, direction.y, direction.z}, tmax};
}

Ray camera_ray(const Camera& camera, int size, int x, int y) {
    const auto pixels = static_cast<float>(size);
    const float right = (2.0f * static_cast<float>(x) + 1.0f - pixels) / pixels * camera.half;
    const float down = (2.0f * static_cast<float>(y) + 1.0f - pixels) / pixels * camera.half;
    const vec3 direction = glm::normalize(camera.forward + camera.right * right - camera.up * down);
    return make_ray(camera.eye, direction, std::numeric_limits<float>::infinity());
}

bool find_start(const Model& model, const Ray& ray, const Hit& hit, Start& start) {
    const uvec3& corner = model.mesh->triangles[hit.triangle];
    const vec3& a = model.mesh->positions[corner.x];
    const vec3 across = glm::cross(model.mesh->positions[corner.y] - a, model.mesh->positions[corner.z] - a);
    const float length = glm::length(across);
    if (!(length > 0.0f)) return false;
    const vec3 direction = direction_of(ray);
    start.normal = across * ((glm::dot(across, direction) > 0.0f ? -1.0f : 1.0f) / length);
    start.origin = origin_of(ray) + direction * hit.t + start.normal * (1e-4f * model.diagonal);
    return true;
}

FirstHits find_first_hits(const Model& model, const tracing::Mesh& reference, int size) {
    FirstHits found;
    const int tiles = size / 8;
    for (int tile = 0; tile < tiles * tiles; ++tile) {
        for (int pixel = 0; pixel < 64; ++pixel) {
            const int x = tile % tiles * 8 + pixel % 8;
            const int y = tile / tiles * 8 + pixel / 8;
            const Ray ray = camera_ray(model.camera, size, x, y);
            const Hit hit = reference.closest(ray);
            Start start;
            if (hit && find_start(model, ray, hit, start)) {
                found.starts.push_back(start);
                found.ray.push_back(static_cast<std::uint32_t>(found.rays.size()));
            }
            found.rays.push_back(ray);
        }
    }
    return found;
}

} // namespace glint::bench
