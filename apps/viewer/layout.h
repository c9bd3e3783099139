#pragma once
// Where the parts of the window are.

#include "ui_map.h"
#include "window.h"

namespace glint::viewer {

/// The parts, none over another.
struct Layout {
    Area space;    ///< for the picture
    Area timeline; ///< below it, empty without animation
    Area panel;    ///< at the right, empty where it is hidden
    Area status;   ///< the line at the bottom
};

Layout lay_out(const WindowSize& window, float scale, bool panel, bool timeline);

/// The largest area of this shape within a space, in its middle, on whole pixels.
Area fit(const Area& space, double width, double height, float pixels_a_unit);

} // namespace glint::viewer
