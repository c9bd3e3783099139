#pragma once
// How the scene is looked at: what the Picture panel and the keys set. Nothing of it is part of the scene.

#include "arguments.h"

#include "glint/kernels.h"
#include "glint/picture_files.h"
#include "glint/render.h"

namespace glint::viewer {

enum class CompareMode { off, wipe, side_by_side };

struct ViewState {
    bool gpu = false; ///< render on the graphics card
    Aov show = Aov::final;
    CompareMode compare = CompareMode::off;
    bool turntable = false;
    View view = View::srgb; ///< the sRGB curve, as in files, or linear values unchanged
    Kernel kernel = Kernel::automatic;
    ThemeChoice theme = ThemeChoice::dark;
};

} // namespace glint::viewer
