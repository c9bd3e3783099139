// load_scene() and parse_scene(): from text or mesh to description.

#include "formats/read_bytes.h"
#include "formats/read_text.h"
#include "formats/scene/key_path.h"
#include "formats/scene/open_scene.h"
#include "glint/mesh_files.h"
#include "scene/text.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

namespace glint {
namespace {

// The tables of a preview scene, by which overrides reach its materials, objects and lights.
formats::TreeValue preview_tables(const SceneDescription& preview) {
    using formats::TreeEntry;
    using formats::TreeValue;
    TreeValue root;
    const auto table = [&](std::string_view name, TreeValue::Kind kind) -> TreeValue& {
        if (TreeEntry* entry = root.find(name)) return entry->value;
        root.entries.push_back({std::string(name), {}, {}});
        root.entries.back().value.kind = kind;
        return root.entries.back().value;
    };
    const auto add_to_list = [&](std::string_view name, const char* key, std::string_view value) {
        TreeValue text;
        text.kind = TreeValue::Kind::text;
        text.text = value;
        table(name, TreeValue::Kind::list).items.emplace_back().entries.push_back({key, {}, text});
    };
    for (const Material& material : preview.materials)
        table("material", TreeValue::Kind::table).entries.push_back({material.name, {}, {}});
    for (const Object& object : preview.objects) add_to_list(name_of(object.shape), "name", object.name);
    for (const Light& light : preview.lights) add_to_list("light", "type", name_of(light));
    return root;
}

void refuse_missing_lists(const formats::SceneSource& source, const formats::TreeValue& root,
                          formats::Problems& problems) {
    int origin = 0;
    for (const std::string& text : source.overrides()) {
        const TableSpec* spec = formats::find_table(text.substr(0, text.find('.')));
        ++origin;
        if (!spec || root.find(spec->name)) continue;
        if (spec->form == TableForm::list || spec->name == "animation")
            problems.error({origin, 0, 0}, "a bare mesh has no " + spec->header() + " to change",
                           "write a scene around it: glint new --from MESH");
    }
    problems.throw_if_any();
}

// Overrides of a bare mesh reach what its preview scene has, and how it is framed.
void override_preview(SceneDescription& preview, const std::string& name, const LoadOptions& options) {
    const formats::SceneSource source({}, name, options.overrides);
    formats::Problems problems(source);
    formats::TreeValue root = preview_tables(preview);
    refuse_missing_lists(source, root, problems);
    formats::apply_overrides(root, source, problems);
    const std::optional<formats::TreeValue> camera = formats::taken_camera(root);
    formats::patch_scene(root, preview, problems);
    if (camera) formats::patch_framing(*camera, preview, problems);
    problems.throw_if_any();
    if (std::get<MeshShape>(preview.objects.front().shape).file != name)
        throw Error(ErrorKind::usage, "the file of a bare mesh cannot be overridden", "name the other file");
}

// The stage is set around the mesh as overrides leave it.
SceneDescription stage(const std::shared_ptr<const Mesh>& mesh, const std::string& path, Axis up,
                       const LoadOptions& options) {
    SceneDescription scene = preview_scene(mesh, path, up, options.floor);
    const Object plain = scene.objects.front();
    override_preview(scene, path, options);
    Object changed = scene.objects.front();
    if (changed.shape == plain.shape && changed.transform == plain.transform) return scene;
    scene = preview_scene(std::move(changed), options.floor);
    override_preview(scene, path, options);
    return scene;
}

LoadedScene load_preview(LoadedMesh mesh, const std::string& path, const LoadOptions& options) {
    LoadedScene scene;
    scene.bare_mesh = true;
    if (path != formats::stdin_name) scene.files.push_back(path);
    scene.warnings = std::move(mesh.warnings);
    const Axis up = options.up ? *options.up : guess_up_axis(*mesh.mesh);
    if (!options.up) {
        const std::string other = up == Axis::z ? "y" : "z";
        scene.notes.push_back("up axis: " + std::string(name_of(up)) +
                              " (guessed from the shape); change it with --up " + other);
    }
    scene.description = stage(mesh.mesh, path, up, options);
    return scene;
}

/// Throws Error(input) for a name that tells of a format that glint does not read.
void refuse_other_formats(const std::string& path) {
    struct Formats {
        const char* kind;
        const char* cure;
        std::vector<std::string_view> extensions;
    };
    static const Formats known[] = {
        {"meshes", "convert it to PLY", {".obj", ".stl", ".gltf", ".glb", ".off", ".fbx",  ".3ds",  ".3mf",
                                         ".amf", ".dae", ".x3d",  ".wrl", ".usd", ".usda", ".usdc", ".usdz",
                                         ".abc", ".lwo", ".vtk",  ".vtp", ".msh", ".ase"}},
        {"point clouds", "convert it to PLY", {".pcd", ".xyz", ".pts", ".las", ".laz", ".e57"}},
        {"solid models",
         "export it as PLY",
         {".step", ".stp", ".iges", ".igs", ".ifc", ".dxf", ".dwg", ".brep", ".sat"}},
        {"scenes",
         "glint new shows how scenes are written in TOML",
         {".pov", ".pbrt", ".blend", ".max", ".ma"}},
        {"compressed files",
         "decompress it first",
         {".gz", ".xz", ".zst", ".bz2", ".zip", ".7z", ".lz4", ".rar"}}};
    const std::string extension = formats::lower_extension(path);
    for (const Formats& each : known)
        if (std::find(each.extensions.begin(), each.extensions.end(), extension) != each.extensions.end())
            throw Error(ErrorKind::input, each.kind + (" of type " + extension) + " cannot be read",
                        each.cure, {path, 0, 0, {}});
}

} // namespace

LoadedScene parse_scene(std::string_view text, const std::string& name, const LoadOptions& options) {
    formats::require_scene_size(text, name);
    const auto scene = std::make_shared<formats::OpenScene>(std::string(text), name, options);
    LoadedScene loaded = scene->load();
    if (!loaded.animation.keys.empty()) loaded.animation.scene = scene;
    return loaded;
}

SceneDescription scene_at(const LoadedScene& scene, double frame) {
    if (!std::isfinite(frame)) throw Error(ErrorKind::usage, "there is no frame " + scene::show(frame));
    return scene.animation.scene ? scene.animation.scene->at(frame) : scene.description;
}

LoadedScene load_scene(const std::string& path, const LoadOptions& options) {
    if (path != "-" && formats::lower_extension(path) == ".ply") {
        std::error_code failed;
        if (const char* kind = formats::special_file(std::filesystem::status(path, failed)))
            throw Error(ErrorKind::input, std::string("the mesh is ") + kind + ", not a file",
                        "give the mesh on stdin: glint - < MESH", {.file = path});
        return load_preview(load_mesh(path, options), path, options);
    }
    const std::string text = formats::read_text(path);
    const std::string name = path == "-" ? formats::stdin_name : path;
    if (formats::looks_like_ply(text))
        return load_preview(parse_ply(std::as_bytes(std::span(text)), name, options), name, options);
    refuse_other_formats(path);
    return parse_scene(text, name, options);
}

} // namespace glint
