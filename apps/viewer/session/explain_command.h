#pragma once
// The command line that explains a pixel as the window does.

#include "explainer.h"

#include "glint/document.h"
#include "glint/formats.h"

#include <optional>
#include <string>

namespace glint::viewer {

/// What the window shows of a file: how it was read, what was changed since, and when in its animation.
struct ShownFile {
    std::string file;                      ///< scene or bare mesh
    LoadOptions load;                      ///< as the window was told
    std::optional<SceneDocument> document; ///< with the changes made to it
    std::vector<std::string> moving;       ///< the key paths that an animation moves
    std::optional<double> frame;           ///< of the animation; none: the scene as its tables say
    SceneDescription description;          ///< what all that comes to
};

struct ExplainCommand {
    std::string line;  ///< for a POSIX shell, in any folder
    std::string lacks; ///< why it explains something else than the window, in a sentence; else empty

    std::string file; ///< as the window has it
    LoadOptions load; ///< with all that -D says
    std::optional<int> frame;
};

/// Reads no file: see check().
ExplainCommand explain_command(const ShownFile& shown, const PixelQuestion& question);

/// Reads the file as the command will, meshes aside, and fills in `lacks` where another scene comes out.
void check(ExplainCommand& command, const ShownFile& shown);

/// A word that a POSIX shell takes as it is, in quotes where that is needed.
std::string quoted(const std::string& word);

} // namespace glint::viewer
