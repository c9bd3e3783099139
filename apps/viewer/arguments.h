#pragma once
// The command line of glint-view. `glint view` passes its arguments on unchanged.

#include "glint/scene_files.h"

#include <optional>
#include <string>
#include <vector>

namespace glint::viewer {

enum class ThemeChoice { dark, light };
/// What renders; `automatic`: a graphics card if there is one.
enum class BackendChoice { automatic, cpu, gpu };

/// The options of the command line.
struct Arguments {
    std::string file;        ///< scene or mesh; empty: none, until one is dropped on the window
    LoadOptions load;        ///< overrides, up axis, files outside the scene's folder
    int window_width = 1280; ///< of the window's content, in screen units
    int window_height = 800;
    std::optional<int> picture_width; ///< pixels to render; none: as many as the window shows
    std::optional<int> picture_height;
    int threads = 0; ///< 0: one for each core
    BackendChoice backend = BackendChoice::automatic;
    ThemeChoice theme = ThemeChoice::dark;
    std::optional<double> scale; ///< of text and widgets; none: that of the screen
    std::string map_file;        ///< file for UiMap; empty: none
    bool statistics = false;     ///< print frame times at the end
    bool debug = false;          ///< print OpenGL's debug messages
    bool help = false;
    bool version = false;
};

/// Throws Error(usage), with what was expected.
Arguments parse_arguments(const std::vector<std::string>& arguments);

/// The text of --help.
std::string help_text();

} // namespace glint::viewer
