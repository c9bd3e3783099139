// Surface points of hits: computed in double, rounded once.

#include "trace/world/data.h"

namespace glint::trace {

namespace {

vec3 corner(const geometry::TriangleVertices& vertices, std::size_t i) {
    return {vertices[i][0], vertices[i][1], vertices[i][2]};
}

SurfacePoint triangle_point(const WorldData& world, const Ray& ray, const Hit& hit) {
    const double u = hit.u;
    const double v = hit.v;
    const std::uint32_t instance = instance_of(world, hit.object);
    if (instance == invalid_index) {
        const WorldInput::Triangles& mesh = mesh_of(world, hit.object);
        const geometry::TriangleVertices at = vertices_of(mesh, hit.prim);
        return triangle_surface(corner(at, 0), corner(at, 1), corner(at, 2), u, v, dvec3(ray.direction),
                                mesh.flip);
    }
    const InstanceData& data = world.instances[instance];
    const geometry::TriangleVertices at = vertices_of(world, data, hit.prim);
    const Ray local = world.instance_tree.to_local(instance, ray);
    return instance_surface(corner(at, 0), corner(at, 1), corner(at, 2), u, v, dvec3(local.direction),
                            data.linear, world.instance_tree.inverse(instance),
                            world.instance_tree.translation(instance), data.slack, data.turned);
}

SurfacePoint quadric_point(const WorldData& world, const Ray& ray, const Hit& hit) {
    const Quadric& quadric = world.quadrics[world.surfaces[surface_number(world, hit)].index];
    const geometry::Line line = exact_line(ray);
    const bool leaving = hit.u != 0.0f;
    const double size = size_of_quadric(quadric.shape);
    dvec3 p;
    dvec3 n;
    if (quadric.affine < 0) {
        point_on_line(quadric.shape, leaving, line.origin, line.direction, p, n);
        return rounded_point(p, n, surface_error * size);
    }
    const Affine& affine = world.affines[static_cast<std::size_t>(quadric.affine)];
    const geometry::Line local = affine.to_local(line);
    point_on_line(quadric.shape, leaving, local.origin, local.direction, p, n);
    return point_in_world(p, n, affine.linear, affine.inverse, affine.translation, size);
}

SurfacePoint plane_point(const WorldData& world, const Ray& ray, const Hit& hit) {
    const geometry::Plane& plane = world.planes[world.surfaces[surface_number(world, hit)].index].plane;
    const geometry::Line line = exact_line(ray);
    return plane_surface(line.origin, line.direction, plane.normal, plane.offset);
}

} // namespace

SurfacePoint World::surface(const Ray& ray, const Hit& hit) const {
    switch (hit.kind) {
    case PrimKind::triangle:
        return triangle_point(*data_, ray, hit);
    case PrimKind::quadric:
        return quadric_point(*data_, ray, hit);
    case PrimKind::plane:
        return plane_point(*data_, ray, hit);
    case PrimKind::none:
        break;
    }
    return {};
}

} // namespace glint::trace
