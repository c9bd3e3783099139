// Resolving and loading mesh files.

#include "formats/scene/load_meshes.h"

#include "formats/read_bytes.h"
#include "glint/mesh_files.h"
#include "scene/text.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <set>
#include <system_error>

namespace glint::formats {

using scene::in_quotes;

namespace {

namespace fs = std::filesystem;

// Resolves symbolic links and ".." as far as the path exists; empty if that is impossible, as for names that
// are too long.
fs::path resolve_links(const fs::path& path) {
    std::error_code failed;
    fs::path resolved = fs::absolute(path, failed);
    if (!failed) resolved = fs::weakly_canonical(resolved, failed);
    if (failed == std::errc::not_enough_memory) throw std::bad_alloc();
    return failed ? fs::path() : resolved;
}

// False if either could not be resolved.
bool is_inside(const fs::path& file, const fs::path& folder) {
    if (file.empty() || folder.empty()) return false;
    const auto [left, _] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    // A folder with a trailing slash ends in an empty component.
    return left == folder.end() || left->empty();
}

fs::path folder_of(const std::string& scene_file) {
    const fs::path folder = fs::path(scene_file).parent_path();
    return folder.empty() ? fs::path(".") : folder;
}

class MeshLoader {
  public:
    MeshLoader(const FilePolicy& policy, Problems& problems, MeshCache& loaded,
               std::vector<Diagnostic>& warnings)
        : policy_(policy), problems_(problems), loaded_(loaded), warnings_(warnings),
          folder_(resolve_links(folder_of(policy.scene_file))) {}

    /// Adds the names of all files to `files`, each once, before reading them.
    void run(ReadScene& scene, std::vector<std::string>& files) {
        std::vector<Wanted> wanted;
        std::size_t number = 0;
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            auto* mesh = std::get_if<MeshShape>(&scene.description.objects[i].shape);
            if (!mesh) continue;
            const std::string& name = scene.description.objects[i].name;
            const std::string called = name.empty() ? std::to_string(number) : name;
            ++number;
            if (!mesh->file.empty())
                wanted.push_back({mesh, mesh_path(policy_.scene_file, mesh->file, scene.objects[i].shape),
                                  scene.objects[i].shape, called});
        }
        for (const Wanted& each : wanted) {
            check(each);
            if (named_.insert(each.path.string()).second) files.push_back(each.path.string());
        }
        // Do not read large files for a scene that has errors anyway.
        if (!policy_.load || problems_.any_error()) return;
        for (const Wanted& each : wanted) each.mesh->data = load(each);
    }

  private:
    struct Wanted {
        MeshShape* mesh;
        fs::path path;
        SourcePos where;
        std::string called; ///< key path of the mesh
    };

    void check(const Wanted& wanted) {
        const bool trusted = policy_.allow_outside || wanted.where.origin > 0;
        std::error_code failed;
        const fs::file_status status = fs::status(wanted.path, failed);
        const bool nowhere =
            failed == std::errc::filename_too_long || failed == std::errc::too_many_symbolic_link_levels;
        const fs::path resolved = resolve_links(wanted.path);
        if (!trusted && !nowhere && !is_inside(resolved, folder_)) {
            const bool known = !resolved.empty() && !folder_.empty();
            return problems_.error(
                wanted.where,
                "mesh file " + in_quotes(wanted.path.string()) +
                    (known ? " lies outside the scene's folder"
                           : " cannot be shown to lie in the scene's folder: the path cannot be resolved"),
                "--allow-outside permits it, and so does -D mesh." + wanted.called + ".file=…");
        }
        if (!policy_.load) return;
        if (status.type() == fs::file_type::not_found)
            problems_.error(wanted.where, "mesh file " + in_quotes(wanted.path.string()) + " does not exist",
                            "say where it is with -D mesh." + wanted.called + ".file=…");
        else if (failed)
            problems_.error(wanted.where, "mesh file " + in_quotes(wanted.path.string()) +
                                              " cannot be read: " + failed.message());
        else if (fs::is_directory(status))
            problems_.error(wanted.where, "mesh file " + in_quotes(wanted.path.string()) + " is a folder");
        else if (const char* kind = special_file(status))
            problems_.error(wanted.where, "mesh file " + in_quotes(wanted.path.string()) + " is " + kind,
                            "meshes are read from regular files");
    }

    std::shared_ptr<const Mesh> load(const Wanted& wanted) {
        const fs::path resolved = resolve_links(wanted.path);
        const std::string key = (resolved.empty() ? wanted.path : resolved).string();
        if (const auto known = loaded_.find(key); known != loaded_.end()) return known->second;
        std::shared_ptr<const Mesh> mesh;
        try {
            LoadedMesh file = load_mesh(wanted.path.string(), policy_.watched);
            mesh = std::move(file.mesh);
            warnings_.insert(warnings_.end(), file.warnings.begin(), file.warnings.end());
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::input) throw;
            const Location named = problems_.locate(wanted.where);
            for (Diagnostic diagnostic : error.diagnostics()) {
                diagnostic.hint +=
                    (diagnostic.hint.empty() ? "the mesh is named at " : "; the mesh is named at ") +
                    to_string(named);
                problems_.error_elsewhere(wanted.where, std::move(diagnostic));
            }
        }
        return loaded_[key] = mesh;
    }

    const FilePolicy& policy_;
    Problems& problems_;
    MeshCache& loaded_;
    std::vector<Diagnostic>& warnings_;
    fs::path folder_;
    std::set<std::string> named_;
};

} // namespace

std::string mesh_path(const std::string& scene_file, const std::string& file, const SourcePos& named_at) {
    const bool relative = fs::path(file).is_relative() && named_at.origin == 0;
    return (relative ? folder_of(scene_file) / file : fs::path(file)).lexically_normal().string();
}

void load_meshes(ReadScene& scene, const FilePolicy& policy, Problems& problems, MeshCache& cache,
                 std::vector<Diagnostic>& warnings, std::vector<std::string>& files) {
    MeshLoader(policy, problems, cache, warnings).run(scene, files);
}

} // namespace glint::formats
