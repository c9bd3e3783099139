#pragma once
// Semantic validation of scene descriptions.

#include "glint/limits.h"
#include "glint/scene.h"

#include <string>
#include <vector>

namespace glint::scene {

/// Whether to check shapes and transforms, or assume that they have been checked.
enum class Shapes { unchecked, checked };

/// All errors that prevent building a scene, with their locations; empty if valid.
std::vector<Diagnostic> find_errors(const SceneDescription& description, Shapes shapes = Shapes::unchecked);

/// Throws Error(input) with them, if any.
void require_valid(const SceneDescription& description, Shapes shapes = Shapes::unchecked);

/// The mesh object that an instance refers to, or nullptr.
const Object* find_mesh(const SceneDescription& description, const std::string& name);

/// The material of an object: its own, or its mesh's for an instance without one; nullptr if unknown.
const Material* material_of(const SceneDescription& description, const Object& object);

} // namespace glint::scene
