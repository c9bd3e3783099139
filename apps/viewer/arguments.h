#pragma once
// The command line of glint-view. `glint view` passes its words on to it unchanged.

#include "glint/formats.h"

#include <optional>
#include <string>
#include <vector>

namespace glint::viewer {

enum class ThemeChoice { dark, light };
/// Who makes the pictures; `automatic`: a graphics card where there is one.
enum class BackendChoice { automatic, cpu, gpu };

/// What the window is asked to do at its start.
struct Arguments {
    std::string file;        ///< scene or mesh; empty: the window waits for a file to be dropped
    LoadOptions load;        ///< overrides, up axis, files outside the scene's folder
    int window_width = 1280; ///< of the whole window, in the units of the screen
    int window_height = 800;
    std::optional<int> picture_width; ///< pixels to render; none: as large as the window shows
    std::optional<int> picture_height;
    int threads = 0; ///< 0: one for each core
    BackendChoice backend = BackendChoice::automatic;
    ThemeChoice theme = ThemeChoice::dark;
    std::optional<double> scale; ///< of texts and widgets; none: what the screen asks for
    std::string map_file;        ///< where widgets and state are written; empty: nowhere
    bool statistics = false;     ///< print how long frames took
    bool debug = false;          ///< print what OpenGL complains of
    bool help = false;
    bool version = false;
};

/// Takes the words apart. Every fault is an Error(usage) that says what was expected.
Arguments parse_arguments(const std::vector<std::string>& words);

/// What --help prints.
std::string help_text();

} // namespace glint::viewer
