#pragma once
// All kinds of files: scenes, meshes, pictures, explanations.

#include "glint/explanation_files.h"
#include "glint/mesh_files.h"
#include "glint/picture_files.h"
#include "glint/scene_files.h"

#include <cstddef>
#include <span>
#include <string>

namespace glint {

/// Writes a file atomically: under a temporary name in the same folder, then fsync and rename.
void write_file(const std::string& path, std::span<const std::byte> bytes);

} // namespace glint
