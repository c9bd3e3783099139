#pragma once
// How the window looks: two sets of colours, three faces of type, and spaces that grow with the screen's
// scale.

#include "arguments.h"

struct ImFont;

namespace glint::viewer {

/// A colour, 0 … 1.
struct Tint {
    float red = 0;
    float green = 0;
    float blue = 0;
    float alpha = 1;
};

struct Theme {
    ThemeChoice choice = ThemeChoice::dark;
    float scale = 1;         ///< of texts and spaces
    float pixels_a_unit = 1; ///< of the screen that the type was made for
    ImFont* text = nullptr;
    ImFont* bold = nullptr;
    ImFont* fixed = nullptr; ///< every letter as wide as every other
    Tint surround;           ///< around the picture
    Tint panel;              ///< below what stands beside it
    Tint accent;
    Tint quiet; ///< of texts that matter less
    Tint warning;
    Tint error;
};

/// Loads the type and sets Dear ImGui's style. `pixels_a_unit` is WindowSize's. May be called again between
/// frames. Type comes from the machine's DejaVu, Noto or Liberation fonts; without these from Dear ImGui's
/// own, which lacks Greek letters.
Theme apply_theme(ThemeChoice choice, float scale, float pixels_a_unit);

} // namespace glint::viewer
