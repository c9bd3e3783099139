#pragma once
// The mesh files of a scene.

#include "formats/scene/read.h"
#include "glint/scene_files.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace glint::formats {

/// How file names in a scene are resolved.
struct FilePolicy {
    std::string scene_file; ///< base of relative names
    bool allow_outside = false;
    bool load = true;      ///< false: check names without reading files
    LoadOptions watched{}; ///< only `cancel` and `progress` are used
};

/// Loaded meshes by canonical path.
using MeshCache = std::map<std::string, std::shared_ptr<const Mesh>>;

/// Path of a mesh file: names on the command line are relative to the working directory, those in a scene to
/// its folder.
std::string mesh_path(const std::string& scene_file, const std::string& file, const SourcePos& named_at);

/// Sets MeshShape::data of all meshes, reading each file once, and adds the file names to `files`. Reports
/// names outside the folder of the scene, missing files and errors in them; reads no file if other errors are
/// known. Appends warnings of files to `warnings`.
void load_meshes(ReadScene& scene, const FilePolicy& policy, Problems& problems, MeshCache& cache,
                 std::vector<Diagnostic>& warnings, std::vector<std::string>& files);

} // namespace glint::formats
