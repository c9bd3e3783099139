#pragma once
// The working of one ray, or of one light at a hit: formulas, numbers, results.

#include "widgets.h"

#include "glint/explanation.h"

struct ImVec2;

namespace glint::viewer {

void working_of_ray(Ui& ui, const ExplainedRay& ray);
/// Of a light at the ray's hit.
void working_of_light(Ui& ui, const ExplainedRay& ray, const ExplainedLight& light);

/// "(0.1, 0.2, 0.3)".
std::string number_text(const glm::vec3& three);
/// A patch of linear light as the screen shows it.
void draw_swatch(const ImVec2& corner, const ImVec2& size, const glm::vec3& light);

} // namespace glint::viewer
