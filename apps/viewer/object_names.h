#pragma once
// How key paths name objects.

#include "glint/scene.h"

#include <cstddef>
#include <string>

namespace glint::viewer {

/// "sphere.ball": by its name, else by its number among its kind.
std::string table_of(const Object& object, std::size_t number_in_kind);

/// The same key path, with the object's name where it has one and the path has its number.
std::string named_key(const SceneDescription& scene, const std::string& key);

} // namespace glint::viewer
