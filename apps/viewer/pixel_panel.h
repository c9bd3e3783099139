#pragma once
// The explanation of a pixel: its rays as a tree, and the derivation of the selected ray's light.

#include "ray_lines.h"
#include "widgets.h"

#include "glint/explanation.h"

#include <string>

namespace glint::viewer {

/// What is selected in an explanation.
struct PixelChoice {
    int sample = 0;
    RayId selected;
};

/// What the panel says beside the explanation.
struct PixelRemarks {
    std::string picture;       ///< "A" or "B" in a comparison; else empty
    std::string command;       ///< the command line that prints the explanation
    std::string devices;       ///< which device the numbers are from; may be empty
    bool is_elsewhere = false; ///< camera or size have changed since
    bool is_again = false;     ///< the scene has changed; the new explanation is under way
};

enum class PixelRequest { none, copy_command, explain_here };

/// Draws the panel's content and lets the user select.
PixelRequest pixel_panel(Ui& ui, const Explanation& explanation, PixelChoice& choice,
                         const PixelRemarks& remarks);
/// The panel's first line.
void pixel_heading(const Ui& ui, int x, int y, const std::string& picture);

/// The number of samples, from the first, whose rays were kept.
int explained_sample_count(const Explanation& explanation);

} // namespace glint::viewer
