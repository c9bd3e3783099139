#pragma once
// The `glint explain` command line for a pixel that the window explains.

#include "explainer.h"

#include "glint/document.h"
#include "glint/scene_files.h"

#include <optional>
#include <string>

namespace glint::viewer {

/// What the window shows: a file, how it was read, changes since, and the frame of its animation.
struct ShownFile {
    std::string file;                      ///< scene or bare mesh
    LoadOptions load;                      ///< from the window's command line
    std::optional<SceneDocument> document; ///< with unsaved changes
    std::vector<std::string> animated;     ///< key paths that the animation sets
    std::optional<double> frame;           ///< of the animation; none: the scene without animation
    SceneDescription description;          ///< the resulting scene
};

struct ExplainCommand {
    std::string line;       ///< for a POSIX shell, in any folder
    std::string limitation; ///< why the command explains something else than the window; usually empty

    // The same as values, for check().
    std::string file;
    LoadOptions load; ///< with all values of -D
    std::optional<int> frame;
};

/// Reads no file: check() does.
ExplainCommand explain_command(const ShownFile& shown, const PixelQuestion& question);

/// Reads the file as the command will, without meshes, and sets `limitation` if that gives another scene.
void check(ExplainCommand& command, const ShownFile& shown);

/// By its name: a scene, not a bare mesh.
bool is_scene_file(const std::string& file);

/// Quotes an argument for a POSIX shell if it needs quotes.
std::string quoted(const std::string& argument);

} // namespace glint::viewer
