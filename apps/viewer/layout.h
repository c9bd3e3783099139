#pragma once
// The areas of the window's parts.

#include "ui_map.h"
#include "window.h"

namespace glint::viewer {

/// They do not overlap.
struct Layout {
    Area space;    ///< for the picture
    Area timeline; ///< below the picture; empty without animation
    Area panel;    ///< at the right; empty if hidden
    Area status;   ///< the line at the bottom
};

/// `panel`, `timeline`: whether they are shown.
Layout lay_out(const WindowSize& window, float scale, bool panel, bool timeline);

/// The largest area with this aov ratio in the middle of a space, aligned to pixels.
Area fit(const Area& space, double width, double height, float pixels_per_unit);

} // namespace glint::viewer
