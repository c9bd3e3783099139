#pragma once
// What pictures show: light, one of its terms, or numbers of first hits (AOVs).

#include "glint/render.h"

#include <optional>

namespace glint {

/// Is it light or a part of it, with as many samples as the scene asks for? AOVs have one ray a pixel.
bool is_light(Aov aov);
/// The term that an aov shows; none for all light and for AOVs.
std::optional<Term> term_of(Aov aov);

} // namespace glint
