#pragma once
// The explanation of a pixel: its rays as a tree, and the working of the ray that is chosen.

#include "ray_lines.h"
#include "widgets.h"

#include "glint/explanation.h"

namespace glint::viewer {

/// What is looked at in an explanation.
struct PixelChoice {
    int sample = 0;
    RayPlace place;
};

/// Draws the panel's content and lets the user choose. `command` is the command line that prints the same.
void pixel_panel(Ui& ui, const Explanation& explanation, PixelChoice& choice, const std::string& command);

} // namespace glint::viewer
