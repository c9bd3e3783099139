#pragma once
// How far the finite objects of a scene reach: what framing and floors are measured with.

#include "glint/scene.h"
#include "math/vec.h"

#include <optional>

namespace glint {

/// The largest d · p over all points p of the visible, finite objects; d need not be of unit length. Nothing
/// where there is no such object. Points that are not finite, and vertices that no face uses, do not count.
/// Exact but for polyhedra other than boxes, which count as the sphere or cylinder about them.
std::optional<double> support(const SceneDescription& description, const dvec3& d);

/// The same for one object; instances find their mesh in `description`.
std::optional<double> support(const SceneDescription& description, const Object& object, const dvec3& d);

/// The same for the mesh as stored.
std::optional<double> support(const Mesh& mesh, const dvec3& d);

} // namespace glint
