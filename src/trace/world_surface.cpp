// From a hit back to the surface: exact in double, rounded once.

#include "trace/world_data.h"

#include <algorithm>
#include <cmath>

namespace glint {

namespace {

/// Rounds to float, with half a float's spacing and `slack` as the error.
SurfacePoint rounded(const ExactPoint& point, double slack) {
    SurfacePoint result;
    result.p = vec3(point.p);
    result.p_error = glm::abs(result.p) * 0x1p-24f + vec3(static_cast<float>(slack));
    result.n = vec3(point.n);
    return result;
}

/// A ray that starts at the point goes back to the mesh's space, where its origin and direction are rounded
/// and its test displaces triangles: triangle_point_error() has the first and the third, and the direction
/// displaces what it meets of the triangle by 1 u S more than that allows (S as there). A quarter on top
/// covers it and all of second order. What bounds each coordinate there, bounds those here through |linear|.
SurfacePoint instance_surface(const WorldData& world, std::uint32_t instance, const Ray& ray,
                              const Hit& hit) {
    const PlacedMesh& placed = world.instances[instance];
    const TriangleVertices vertices = vertices_of(world, placed, hit.prim);
    const Ray local = world.instance_tree.to_local(instance, ray);
    const ExactPoint point = triangle_point(vertices, double(hit.u), double(hit.v), dvec3(local.direction));
    const dvec3 p = placed.linear * point.p + world.instance_tree.translation(instance);
    const dvec3 normal = glm::transpose(world.instance_tree.inverse(instance)) * point.n;
    const dvec3 unit = normal / std::sqrt(glm::dot(normal, normal));

    const dmat3& m = placed.linear;
    const dvec3 there = dvec3(triangle_point_error(vertices, vec3(point.p))) * 1.25;
    const dvec3 here = glm::abs(m[0]) * there.x + glm::abs(m[1]) * there.y + glm::abs(m[2]) * there.z;
    SurfacePoint result = rounded({p, placed.turned ? -unit : unit}, placed.slack);
    result.p_error += vec3(here);
    return result;
}

SurfacePoint triangle_surface(const WorldData& world, const Ray& ray, const Hit& hit) {
    const std::uint32_t instance = instance_of(world, hit.object);
    if (instance != invalid_index) return instance_surface(world, instance, ray, hit);
    const WorldInput::Triangles& mesh = mesh_of(world, hit.object);
    const TriangleVertices vertices = vertices_of(mesh, hit.prim);
    const ExactPoint point = triangle_point(vertices, double(hit.u), double(hit.v), dvec3(ray.direction));
    SurfacePoint result;
    result.p = vec3(point.p);
    result.p_error = triangle_point_error(vertices, result.p);
    result.n = vec3(mesh.flip ? -point.n : point.n);
    return result;
}

SurfacePoint quadric_surface(const WorldData& world, const Ray& ray, const Hit& hit) {
    const Quadric& quadric = world.quadrics[world.surfaces[surface_number(world, hit)].index];
    const Line line = exact_line(ray);
    SolidSpan span{};
    intersect(world, line, quadric, span);
    const bool leaving = hit.u != 0.0f;
    const double t = leaving ? span.leave : span.enter;
    const int part = leaving ? span.leave_part : span.enter_part;
    const double size = size_of_quadric(quadric.shape);
    if (quadric.affine < 0)
        return rounded(surface(quadric.shape, part, line.origin + line.direction * t), surface_error * size);

    // Solved in local space with the same t; normals go by the inverse transpose.
    const Affine& affine = world.affines[static_cast<std::size_t>(quadric.affine)];
    const Line local = affine.to_local(line);
    const ExactPoint point = surface(quadric.shape, part, local.origin + local.direction * t);
    const dvec3 normal = glm::transpose(affine.inverse) * point.n;
    const double stretch = largest(affine.linear[0]) + largest(affine.linear[1]) + largest(affine.linear[2]);
    return rounded(
        {affine.linear * point.p + affine.translation, normal / std::sqrt(glm::dot(normal, normal))},
        surface_error * (largest(affine.translation) + stretch * size));
}

SurfacePoint plane_surface(const WorldData& world, const Ray& ray, const Hit& hit) {
    const Plane& plane = world.planes[world.surfaces[surface_number(world, hit)].index].plane;
    const Line line = exact_line(ray);
    double t = 0;
    intersect(line, plane, t);
    const dvec3 p = line.origin + line.direction * t;
    return rounded(surface(plane, p), surface_error * (largest(line.origin) + largest(p)));
}

} // namespace

SurfacePoint World::surface(const Ray& ray, const Hit& hit) const {
    switch (hit.kind) {
    case PrimKind::triangle:
        return triangle_surface(*data_, ray, hit);
    case PrimKind::quadric:
        return quadric_surface(*data_, ray, hit);
    case PrimKind::plane:
        return plane_surface(*data_, ray, hit);
    case PrimKind::none:
        break;
    }
    return {};
}

} // namespace glint
