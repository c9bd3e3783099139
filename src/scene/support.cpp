// Support functions by shape.

#include "scene/support.h"

#include "scene/names.h"
#include "scene/shapes/shapes.h"

#include <algorithm>
#include <cmath>

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

} // namespace

std::optional<double> support(const Mesh& mesh, const dvec3& d) { return if_finite(farthest(mesh, d)); }

std::optional<double> support(const SceneDescription& description, const Object& object, const dvec3& d) {
    return support_of(NameIndex(description), object, d);
}

std::optional<double> support(const SceneDescription& description, const dvec3& d) {
    const NameIndex names(description);
    double most = no_support;
    for (const Object& object : description.objects) {
        if (object.visible) most = std::max(most, support_of(names, object, d).value_or(no_support));
    }
    return if_finite(most);
}

} // namespace glint::scene
