#pragma once
// Scene files. Readers throw Error(input) with place, cause and cure.

#include "glint/error.h"
#include "glint/scene.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// `path=value`, as given by -D: "whitted.max_depth=3", "material.glass.index=1.33", "light.0.intensity=500".
using Override = std::string;

struct LoadOptions {
    std::vector<Override> overrides;
    bool allow_outside = false; ///< may a scene name files outside its own folder?
    bool load_meshes = true;
    std::optional<Axis> up;             ///< for bare meshes; none: guessed, and said in `notes`
    const CancelFlag* cancel = nullptr; ///< once it is set, Error(cancelled) is thrown
    LoadCallback progress;              ///< told of meshes as they are read
};

class OpenScene;

/// How a scene moves: what its [animation] and [[animate]] tables say.
struct Animation {
    int first = 0;
    int last = 0; ///< the last keyframe where the file names none
    double fps = 24;
    std::vector<std::string> keys;          ///< the key paths that move, in the order of the file
    std::shared_ptr<const OpenScene> scene; ///< for scene_at(); null where nothing moves
};

struct LoadedScene {
    SceneDescription description;
    std::vector<Diagnostic> warnings; ///< of the files; those of meaning come from glint::warnings()
    std::vector<std::string> files; ///< that decide it, each once: the scene file, then its meshes. Not stdin
    Animation animation;
    std::vector<std::string> notes; ///< choices made for the user, one line each ("up axis: y (guessed) …")
};

/// Reads a scene file, or stages a bare mesh, judged by the extension and then by the content. "-" reads a
/// scene from stdin. All errors of meaning are reported together.
LoadedScene load_scene(const std::string& path, const LoadOptions& options = {});

/// The same from text; `name` stands for the file in messages and its folder for relative names.
LoadedScene parse_scene(std::string_view text, const std::string& name, const LoadOptions& options = {});

/// The scene at a frame, which may lie between whole ones. Overrides have the last word over what moves.
/// Meshes are the same objects at every frame, so that what does not move can be told. Throws Error(input),
/// naming the frame, where the scene is wrong there. May be called from any number of threads.
SceneDescription scene_at(const LoadedScene& scene, double frame);

/// The reference page of all keys, Markdown, generated from the table that drives the parser.
std::string scene_key_reference();

/// Names of the starter scenes of `glint new`, and the commented text of one.
std::vector<std::string> template_names();
std::string template_text(const std::string& name);

} // namespace glint
