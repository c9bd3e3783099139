#include "render/surface_interaction.h"

#include "geometry/surface.shared.h"

namespace glint {

using trace::Hit;
using trace::PrimKind;
namespace {

void step_off_edge(const SceneData& scene, const Ray& ray, const Hit& hit, SurfacePoint& point) {
    Hit middle = hit;
    middle.u = 1.0f / 3.0f;
    middle.v = 1.0f / 3.0f;
    point = moved_off_edge(point, scene.world.surface(ray, middle).p);
}

vec3 vertex_normal(const SceneData& scene, const Hit& hit, const std::vector<vec3>& normals,
                   std::uint32_t vertex) {
    const vec3& n = normals[vertex];
    const std::int32_t matrix = scene.objects[hit.object].normal_matrix;
    if (matrix == no_normal_matrix) return n;
    return transformed_normal(scene.normal_matrices[static_cast<std::size_t>(matrix)], n);
}

/// Colour and shading normal, where the mesh has them by vertex. A cloud of spheres has a colour for each.
void interpolate_vertices(const SceneData& scene, const Hit& hit, SurfaceRecord& s) {
    const MeshAttributes& attributes =
        scene.attributes[static_cast<std::size_t>(scene.objects[hit.object].attributes)];
    if (hit.kind == PrimKind::quadric) {
        s.color = attributes.mesh->colors[hit.prim];
        return;
    }
    const uvec3 corner = attributes.mesh->triangles[hit.prim];
    if (attributes.colored) {
        const std::vector<vec3>& c = attributes.mesh->colors;
        s.color = interpolated(c[corner.x], c[corner.y], c[corner.z], hit.u, hit.v);
    }
    if (attributes.normals == nullptr) return;
    const auto normal = [&](std::uint32_t vertex) {
        return vertex_normal(scene, hit, *attributes.normals, vertex);
    };
    s.n = shading_normal(interpolated(normal(corner.x), normal(corner.y), normal(corner.z), hit.u, hit.v),
                         s.n_g);
}

} // namespace

SurfaceInteraction surface_interaction(const SceneData& scene, const Ray& ray, const Hit& hit) {
    const ObjectData& object = scene.objects[hit.object];
    SurfacePoint point = scene.world.surface(ray, hit);
    if (hit.on_edge) step_off_edge(scene, ray, hit, point);
    SurfaceInteraction at;
    at.object = hit.object;
    at.material = &scene.materials[object.material];
    at.entering = dot(point.n, ray.direction) < 0.0f;
    SurfaceRecord& s = at.surface;
    s.p = point.p;
    s.p_error = point.p_error;
    s.v = -ray.direction;
    s.n_g = at.entering ? point.n : -point.n;
    s.n = s.n_g;
    s.color = at.material->color;
    s.lit_side = object.lit_as_stored && at.entering == object.turned ? -1.0f : 1.0f;
    if (object.attributes != no_attributes) interpolate_vertices(scene, hit, s);
    return at;
}

bool enters(const SceneData& scene, const Ray& ray, const Hit& hit) {
    return dot(scene.world.surface(ray, hit).n, ray.direction) < 0.0f;
}

} // namespace glint
