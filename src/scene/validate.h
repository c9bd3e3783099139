#pragma once
// Semantic validation of scene descriptions.

#include "glint/limits.h"
#include "glint/scene.h"

#include <vector>

namespace glint::scene {

/// Whether to check shapes and transforms, or assume that they have been checked.
enum class Shapes { unchecked, checked };

/// All errors that prevent building a scene, with their locations; empty if valid.
std::vector<Diagnostic> find_errors(const SceneDescription& description, Shapes shapes = Shapes::unchecked);

/// Throws Error(input) with them, if any.
void require_valid(const SceneDescription& description, Shapes shapes = Shapes::unchecked);

} // namespace glint::scene
