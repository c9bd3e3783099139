#pragma once
// Materials as shading sees them.

#include "glint/scene.h"
#include "shading/records.shared.h"

namespace glint::scene {

/// In single precision, with what Whitted's model reads in it. (docs/light-model.md.)
MaterialRecord material_record(const Material& material);

} // namespace glint::scene
