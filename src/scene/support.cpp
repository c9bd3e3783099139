// Support functions by shape.

#include "scene/support.h"

#include "scene/names.h"
#include "scene/shapes/shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace glint::scene {
namespace {

// d · (M p) = (Mᵀ d) · p + d · translation.
double reach_through(const Mat4& transform, const dvec3& d, const Object& object) {
    const dvec3 local(glm::transpose(dmat3(transform)) * d);
    const double most = std::visit([&](const auto& shape) { return support(shape, local); }, object.shape);
    return most + glm::dot(d, dvec3(transform[3]));
}

std::optional<double> if_finite(double value) {
    return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

std::optional<double> support_of(const NameIndex& names, const Object& object, const dvec3& d) {
    const auto* instance = std::get_if<InstanceShape>(&object.shape);
    if (instance == nullptr) return if_finite(reach_through(object.transform, d, object));
    const Object* mesh = names.mesh(instance->mesh);
    if (mesh == nullptr) return std::nullopt;
    return if_finite(reach_through(object.transform * mesh->transform, d, *mesh));
}

/// Around what support() sees of a mesh or its points, before the mesh's own scale.
ShapeBox box_with_points(const MeshShape& s) {
    ShapeBox around = box(s);
    if (!around.empty() && s.data->triangles.empty()) {
        around.lo -= point_radius(s);
        around.hi += point_radius(s);
    }
    return around;
}

/// At least the support of an instance, given a box around its mesh. Has a margin for rounding.
double support_bound(const Object& instance, const Object& mesh, const ShapeBox& box, const dvec3& d) {
    const Mat4 transform = instance.transform * mesh.transform;
    const dvec3 local = std::get<MeshShape>(mesh.shape).scale * (glm::transpose(dmat3(transform)) * d);
    const double along = glm::dot(d, dvec3(transform[3]));
    const double middle = glm::dot(local, (box.lo + box.hi) / 2.0);
    const double extent = glm::dot(glm::abs(local), (box.hi - box.lo) / 2.0);
    return along + middle + extent + 1e-12 * (std::abs(along) + std::abs(middle) + extent);
}

} // namespace

std::optional<double> support(const Mesh& mesh, const dvec3& d) { return if_finite(farthest(mesh, d)); }

std::optional<double> support(const SceneDescription& description, const Object& object, const dvec3& d) {
    return support_of(NameIndex(description), object, d);
}

std::optional<double> support(const SceneDescription& description, const dvec3& d) {
    const NameIndex names(description);
    double most = no_support;
    std::map<const Object*, ShapeBox> boxes;
    std::vector<std::pair<double, const Object*>> instances; // by a bound of their support
    for (const Object& object : description.objects) {
        if (!object.visible) continue;
        const auto* instance = std::get_if<InstanceShape>(&object.shape);
        if (instance == nullptr) {
            most = std::max(most, support_of(names, object, d).value_or(no_support));
        } else if (const Object* mesh = names.mesh(instance->mesh)) {
            const auto [known, is_new] = boxes.try_emplace(mesh);
            if (is_new) known->second = box_with_points(std::get<MeshShape>(mesh->shape));
            if (!known->second.empty())
                instances.emplace_back(support_bound(object, *mesh, known->second, d), &object);
        }
    }
    // The vertices of few among many instances need to be looked at.
    std::sort(instances.rbegin(), instances.rend());
    for (const auto& [bound, object] : instances) {
        if (bound <= most) break;
        most = std::max(most, support_of(names, *object, d).value_or(no_support));
    }
    return if_finite(most);
}

} // namespace glint::scene
