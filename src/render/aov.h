#pragma once
// Kinds of AOVs: the light, one of its terms, or numbers of first hits.

#include "glint/render.h"

#include <optional>

namespace glint::rendering {

/// True for the light and its terms, which have as many samples as the scene says; others have one ray a
/// pixel.
bool is_light(Aov aov);
/// The number of the integrator's term that an AOV shows; none if it shows no term of its.
std::optional<int> term_of(Aov aov, Integrator integrator);

} // namespace glint::rendering
