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

/// Writes a file under a temporary name in the same folder, fsyncs, renames: whole or not at all.
void write_file(const std::string& path, std::span<const std::byte> bytes);

} // namespace glint
