#include "scene/shapes/shape_baker.h"

namespace glint::scene {

using trace::WorldInput;
namespace {

// The factor by which m stretches all lengths alike, or 0 if it does not.
double similarity_scale(const dmat4& m) {
    const dvec3 x(m[0]), y(m[1]), z(m[2]);
    const double xx = glm::dot(x, x), yy = glm::dot(y, y), zz = glm::dot(z, z);
    const double skew = std::max({std::abs(glm::dot(x, y)), std::abs(glm::dot(y, z)),
                                  std::abs(glm::dot(z, x)), std::abs(xx - yy), std::abs(yy - zz)});
    return skew <= 1e-12 * xx ? std::sqrt(xx) : 0;
}

} // namespace

// p on the plane where n · A⁻¹(p − t) = offset, so the new normal is A⁻ᵀ n and the offset moves by it.
void ShapeBaker::plane(const dvec3& normal, double offset) {
    WorldInput::Plane plane{id_, normal, offset};
    if (object_.transform != dmat4(1.0)) {
        const dmat3 a(object_.transform);
        plane.normal = glm::transpose(glm::inverse(a)) * normal;
        plane.offset = offset + glm::dot(plane.normal, dvec3(object_.transform[3]));
    }
    baked_.input.planes.push_back(plane);
}

void ShapeBaker::quadric(const QuadricShape& shape) {
    WorldInput::Quadric quadric{id_, 0, shape, -1};
    if (object_.transform != dmat4(1.0)) {
        const double scale = similarity_scale(object_.transform);
        if (scale > 0) {
            quadric.shape = geometry::transformed(shape, object_.transform, scale);
        } else {
            quadric.affine = static_cast<std::int32_t>(baked_.input.world_from_local.size());
            baked_.input.world_from_local.push_back(object_.transform);
        }
    }
    baked_.input.quadrics.push_back(quadric);
    const geometry::Interval x = geometry::extent(shape, {1, 0, 0}), y = geometry::extent(shape, {0, 1, 0}),
                             z = geometry::extent(shape, {0, 0, 1});
    baked_.objects[id_].bounds =
        transform_box(object_.transform, {x.low, y.low, z.low}, {x.high, y.high, z.high});
}

void ShapeBaker::triangles(const std::vector<dvec3>& positions, std::vector<uvec3> triangles, bool closed) {
    WorldInput::Triangles mesh;
    for (const dvec3& p : positions) mesh.positions.push_back(vec3(transform_point(object_.transform, p)));
    mesh.triangles = std::move(triangles);
    add_triangles(baked_, std::move(mesh), id_, closed);
}

void ShapeBaker::mesh() { meshes_.bake(object_, object_.transform, id_, MeshBaker::BakedAs::triangles); }

void ShapeBaker::instance(const std::string& name) {
    const Object& mesh = *names_.mesh(name);
    meshes_.bake(mesh, object_.transform * mesh.transform, id_, MeshBaker::BakedAs::instance);
}

} // namespace glint::scene
