#pragma once
// Checks of meaning that every description must pass, however it was made.

#include "glint/limits.h"
#include "glint/scene.h"

#include <string>
#include <vector>

namespace glint {

/// Whether shapes and transforms are checked as well, or have been before.
enum class Shapes { unchecked, checked };

/// Everything that makes a description impossible to freeze, each with its place; empty if it is sound.
std::vector<Diagnostic> find_errors(const SceneDescription& description, Shapes shapes = Shapes::unchecked);

/// The mesh object that an instance names, or nullptr.
const Object* find_mesh(const SceneDescription& description, const std::string& name);

/// The material that an object shows: its own, or its mesh's for an instance without one; nullptr if unknown.
const Material* material_of(const SceneDescription& description, const Object& object);

} // namespace glint
