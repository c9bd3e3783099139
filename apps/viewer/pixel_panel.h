#pragma once
// The explanation of a pixel: its rays as a tree, and the working of the ray that is chosen.

#include "ray_lines.h"
#include "widgets.h"

#include "glint/explanation.h"

#include <string>

namespace glint::viewer {

/// What is looked at in an explanation.
struct PixelChoice {
    int sample = 0;
    RayPlace place;
};

/// What is to be said of a pixel beside its explanation.
struct PixelRemarks {
    std::string picture;       ///< "A" or "B" where two are compared
    std::string command;       ///< the command line that prints the same
    std::string devices;       ///< whose numbers these are, where that is to be said
    bool is_elsewhere = false; ///< it is not seen from there, or not as large, any more
    bool is_again = false;     ///< the scene has changed, and what is told is of the one before
};

enum class PixelWish { none, copy_command, explain_here };

/// Draws the panel's content and lets the user choose.
PixelWish pixel_panel(Ui& ui, const Explanation& explanation, PixelChoice& choice,
                      const PixelRemarks& remarks);
/// Its first line.
void pixel_heading(const Ui& ui, int x, int y, const std::string& picture);

/// Of how many samples, the first ones, rays are told.
int explained_sample_count(const Explanation& explanation);

} // namespace glint::viewer
