#pragma once
// Support functions of finite objects, for framing and floors.

#include "glint/scene.h"
#include "math/vec.h"

#include <optional>

namespace glint::scene {

/// The maximum of d · p over the visible, finite objects; d may have any length. None if there is no such
/// object. Ignores points that are not finite, outliers of point clouds and vertices without faces. Exact
/// except for polyhedra other than boxes, for which the circumscribed sphere or cylinder is used.
std::optional<double> support(const SceneDescription& description, const dvec3& d);

/// Support function of one object; instances look up their mesh in `description`.
std::optional<double> support(const SceneDescription& description, const Object& object, const dvec3& d);

/// Support function of a mesh as stored.
std::optional<double> support(const Mesh& mesh, const dvec3& d);

} // namespace glint::scene
