#include "render/surface_interaction.h"

#include "shading/interaction.shared.h"

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

/// The vectors at the corners of a triangle, as columns.
mat3 at_corners(const std::vector<vec3>& vectors, const uvec3& corner) {
    return {vectors[corner.x], vectors[corner.y], vectors[corner.z]};
}

/// Colour and shading normal, where the mesh has them by vertex. A cloud of spheres has a colour for each.
void interpolate_vertices(const SceneData& scene, const Hit& hit, SurfaceRecord& s) {
    const ObjectData& object = scene.objects[hit.object];
    const MeshAttributes& attributes = scene.attributes[static_cast<std::size_t>(object.attributes)];
    if (hit.kind == PrimKind::quadric) {
        s.color = attributes.mesh->colors[hit.prim];
        return;
    }
    const uvec3 corner = attributes.mesh->triangles[hit.prim];
    if (attributes.colored) s.color = interpolated(at_corners(attributes.mesh->colors, corner), hit.u, hit.v);
    if (attributes.normals == nullptr) return;
    mat3 normals = at_corners(*attributes.normals, corner);
    if (object.normal_matrix != no_normal_matrix)
        normals = transformed_normals(scene.normal_matrices[static_cast<std::size_t>(object.normal_matrix)],
                                      normals);
    s.n = shading_normal(interpolated(normals, hit.u, hit.v), s.n_g);
}

} // namespace

SurfaceInteraction surface_interaction(const SceneData& scene, const Ray& ray, const Hit& hit) {
    const ObjectData& object = scene.objects[hit.object];
    SurfacePoint point = scene.world.surface(ray, hit);
    if (hit.on_edge) step_off_edge(scene, ray, hit, point);
    SurfaceInteraction at;
    at.object = hit.object;
    at.material = &scene.materials[object.material];
    at.entering = enters(point.n, ray.direction);
    at.surface =
        surface_record(point, ray.direction, at.material->color, object.lit_as_stored, object.turned);
    if (object.attributes != no_attributes) interpolate_vertices(scene, hit, at.surface);
    return at;
}

bool enters(const SceneData& scene, const Ray& ray, const Hit& hit) {
    return enters(scene.world.surface(ray, hit).n, ray.direction);
}

} // namespace glint
