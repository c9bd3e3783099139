#pragma once
// The command line of glint-view. `glint view` checks its arguments and passes them on.

#include "glint/scene_files.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace glint::viewer {

enum class ThemeChoice { dark, light };
/// What renders; `automatic`: a graphics card if there is one.
enum class BackendChoice { automatic, cpu, gpu };

/// The options of the command line.
struct Arguments {
    std::string file; ///< scene or mesh; empty: none, until one is dropped on the window
    LoadOptions load; ///< overrides, up axis, files outside the scene's folder
    std::pair<int, int> window_size{1280, 800};      ///< of the window's content, in screen units
    std::optional<std::pair<int, int>> picture_size; ///< pixels to render; none: as many as the window shows
    int threads = 0;                                 ///< 0: one for each processor
    BackendChoice backend = BackendChoice::automatic;
    ThemeChoice theme = ThemeChoice::dark;
    std::optional<double> scale; ///< of text and widgets; none: that of the screen
    std::string map_file;        ///< file for UiMap; empty: none
    bool statistics = false;     ///< print frame times at the end
    bool debug = false;          ///< print OpenGL's debug messages
};

/// None if --help or --version was asked for: `text` is to be printed then. Throws Error(usage).
std::optional<Arguments> parse_arguments(const std::vector<std::string>& words, std::string& text);

} // namespace glint::viewer
