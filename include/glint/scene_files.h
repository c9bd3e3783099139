#pragma once
// Scene files. Readers throw Error(input) with location, cause and cure.

#include "glint/error.h"
#include "glint/scene.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// `path=value` as for -D: "whitted.max_depth=3", "material.glass.index=1.33", "light.0.intensity=500".
using Override = std::string;

struct LoadOptions {
    std::vector<Override> overrides;
    bool allow_outside = false; ///< whether a scene may refer to files outside its folder
    bool load_meshes = true;
    std::optional<Axis> up = {};        ///< up axis of bare meshes; none: guessed and reported in `notes`
    bool floor = true;                  ///< whether bare meshes stand on a floor
    const CancelFlag* cancel = nullptr; ///< once it is set, Error(cancelled) is thrown
    LoadCallback progress = {};         ///< called while meshes are read
};

namespace formats {
class OpenScene;
}

/// The animation of a scene: its [animation] and [[animate]] tables.
struct Animation {
    int first = 0;
    int last = 0; ///< default: the last keyframe
    double fps = 24;
    std::vector<std::string> keys;                   ///< animated key paths, in file order
    std::shared_ptr<const formats::OpenScene> scene; ///< for scene_at(); null if nothing is animated
};

struct LoadedScene {
    SceneDescription description;
    /// about the files; warnings about the scene come from glint::warnings()
    std::vector<Diagnostic> warnings;
    /// files it depends on, each once: the scene file, then meshes. Without stdin
    std::vector<std::string> files;
    Animation animation;
    bool bare_mesh = false;         ///< is it the preview scene of a mesh?
    std::vector<std::string> notes; ///< choices made automatically, one line each ("up axis: y (guessed) …")
};

/// Reads a scene file, or makes a preview scene of a bare mesh; the format is determined by extension, then
/// by content. "-" reads a scene from stdin. All semantic errors are reported together.
LoadedScene load_scene(const std::string& path, const LoadOptions& options = {});

/// Reads a scene from text; `name` is the file name for messages, and its folder resolves relative names.
LoadedScene parse_scene(std::string_view text, const std::string& name, const LoadOptions& options = {});

/// The scene at a frame, which may be fractional. Overrides take precedence over animation. Meshes are shared
/// between frames. Throws Error(input) naming the frame if the scene is invalid there. May be called by any
/// number of threads.
SceneDescription scene_at(const LoadedScene& scene, double frame);

/// The reference of all keys in Markdown, generated from the table that drives the parser.
std::string scene_key_reference();

/// Names of the templates of `glint new`, and the commented text of one.
std::vector<std::string> template_names();
std::string template_text(const std::string& name);

} // namespace glint
