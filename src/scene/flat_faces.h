#pragma once
// Flat faces of different objects in one place.

#include "glint/scene.h"

namespace glint::scene {

/// Do flat faces of the objects lie in one plane, within the rounding of single precision, and cover a common
/// area? Meshes have none here.
bool have_coincident_faces(const Object& a, const Object& b);

} // namespace glint::scene
