#include "scene/support.h"

#include "scene/validate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glint {
namespace {

constexpr double nothing = -std::numeric_limits<double>::infinity();

void reach(double& most, const dvec3& d, const dvec3& p) {
    const double along = glm::dot(d, p);
    if (std::isfinite(along)) most = std::max(most, along);
}

double mesh_reach(const Mesh& mesh, const dvec3& d) {
    double most = nothing;
    for (const glm::uvec3& t : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) reach(most, d, dvec3(mesh.positions[t[corner]]));
    }
    if (mesh.triangles.empty()) {
        for (const glm::vec3& p : mesh.positions) reach(most, d, dvec3(p));
    }
    return most;
}

// Each shape is asked in its own space, where the direction d has become `local`.
struct Reach {
    dvec3 local;

    double operator()(const PlaneShape&) const { return nothing; }
    double operator()(const InstanceShape&) const { return nothing; }
    double operator()(const SphereShape& s) const {
        return glm::dot(local, s.center) + s.radius * glm::length(local);
    }
    double operator()(const CylinderShape& c) const {
        const dvec3 axis = glm::normalize(c.axis);
        const dvec3 across = local - glm::dot(local, axis) * axis;
        return glm::dot(local, c.base) + std::max(0.0, c.height * glm::dot(local, axis)) +
               c.radius * glm::length(across);
    }
    double operator()(const TriangleShape& t) const {
        double most = nothing;
        for (const dvec3& p : t.vertices) reach(most, local, p);
        return most;
    }
    double operator()(const PolyhedronShape& p) const {
        switch (p.kind) {
        case PolyhedronKind::box:
            return glm::dot(local, p.center) + glm::dot(glm::abs(local), p.size) / 2;
        case PolyhedronKind::prism:
        case PolyhedronKind::pyramid:
            return (*this)(CylinderShape{p.center, p.axis, p.height, p.radius});
        default:
            return (*this)(SphereShape{p.center, p.radius});
        }
    }
    double operator()(const MeshShape& m) const {
        return m.data ? mesh_reach(*m.data, m.scale * local) : nothing;
    }
};

// d · (M p) = (Mᵀ d) · p + d · translation.
double reach_through(const Mat4& transform, const dvec3& d, const Object& object) {
    const dvec3 local(glm::transpose(dmat3(transform)) * d);
    return std::visit(Reach{local}, object.shape) + glm::dot(d, dvec3(transform[3]));
}

std::optional<double> if_finite(double value) {
    return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

} // namespace

std::optional<double> support(const Mesh& mesh, const dvec3& d) { return if_finite(mesh_reach(mesh, d)); }

std::optional<double> support(const SceneDescription& description, const Object& object, const dvec3& d) {
    const auto* instance = std::get_if<InstanceShape>(&object.shape);
    if (instance == nullptr) return if_finite(reach_through(object.transform, d, object));
    const Object* mesh = find_mesh(description, instance->mesh);
    if (mesh == nullptr) return std::nullopt;
    return if_finite(reach_through(object.transform * mesh->transform, d, *mesh));
}

std::optional<double> support(const SceneDescription& description, const dvec3& d) {
    double most = nothing;
    for (const Object& object : description.objects) {
        if (object.visible) most = std::max(most, support(description, object, d).value_or(nothing));
    }
    return if_finite(most);
}

} // namespace glint
