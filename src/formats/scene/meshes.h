#pragma once
// The mesh files that a scene names.

#include "formats/scene/read.h"
#include "glint/formats.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace glint {

/// Where a scene's file names lead to.
struct FilePolicy {
    std::string scene_file; ///< names written in it are relative to its folder
    bool allow_outside = false;
    bool load = true;      ///< false: names are checked, files are not read
    LoadOptions watched{}; ///< whose `cancel` and `progress` count
};

/// Meshes that were read, by their files' true names.
using MeshCache = std::map<std::string, std::shared_ptr<const Mesh>>;

/// Where a mesh's file is: names of the command line are relative to the working directory, those of a scene
/// to its folder.
std::string mesh_path(const std::string& scene_file, const std::string& file, const SourcePos& named_at);

/// Fills MeshShape::data of every mesh, each file read once, and adds the names of the files to `files`.
/// Reports names that leave the scene's folder, files that are missing, and what is wrong inside them; reads
/// none while other problems are known. Warnings of the files are added to `warnings`.
void load_meshes(ReadScene& scene, const FilePolicy& policy, Problems& problems, MeshCache& cache,
                 std::vector<Diagnostic>& warnings, std::vector<std::string>& files);

} // namespace glint
