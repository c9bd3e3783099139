#pragma once
// Colours, fonts and spacing of the window, scaled for the screen.

#include "arguments.h"

struct ImFont;
struct ImVec4;

namespace glint::viewer {

/// A colour of the screen, 0 … 1.
struct Tint {
    float red = 0;
    float green = 0;
    float blue = 0;
};

ImVec4 color_of(const Tint& tint, float alpha = 1);

struct Theme {
    ThemeChoice choice = ThemeChoice::dark;
    float scale = 1;           ///< of text and spacing
    float pixels_per_unit = 1; ///< of the screen that the fonts were rasterised for
    ImFont* text = nullptr;
    ImFont* bold = nullptr;
    ImFont* fixed = nullptr; ///< monospaced
    Tint surround;           ///< around the picture
    Tint panel;              ///< background of the panel
    Tint accent;
    Tint quiet; ///< of less important text
    Tint warning;
    Tint error;
};

/// Loads the fonts and sets Dear ImGui's style; may be called again between frames. Fonts are the system's
/// DejaVu, Noto or Liberation; without them Dear ImGui's own, which lacks Greek letters. `pixels_per_unit`:
/// see WindowSize.
Theme apply_theme(ThemeChoice choice, float scale, float pixels_per_unit);

} // namespace glint::viewer
