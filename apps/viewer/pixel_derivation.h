#pragma once
// The derivation of a ray's light, or of one light at its hit: formulas, numbers, results.

#include "widgets.h"

#include "glint/explanation.h"

struct ImVec2;

namespace glint::viewer {

/// Positions of the ray are relative to `origin`.
void draw_ray(Ui& ui, const ExplainedRay& ray, const glm::dvec3& origin);
/// Of one light at the ray's hit.
void draw_light(Ui& ui, const ExplainedRay& ray, const ExplainedLight& light, const glm::dvec3& origin);

/// "(0.1, 0.2, 0.3)".
std::string number_text(const glm::vec3& values);
/// A patch of linear light in colours of the screen.
void draw_swatch(const ImVec2& corner, const ImVec2& size, const glm::vec3& light);

} // namespace glint::viewer
