#pragma once
// What the window itself remembers: nothing of the scene, only how it is looked at.

#include "glint/formats.h"
#include "glint/kernels.h"
#include "glint/render.h"

namespace glint::viewer {

enum class CompareMode { off, wipe, side_by_side };
enum class Tab { scene, picture, pixel };

struct ViewState {
    bool gpu = false; ///< a graphics card is to make the pictures
    bool panel = true;
    bool help = false;
    Tab tab = Tab::scene;
    bool turn_to_tab = false; ///< the tab was chosen by something else than a click on it
    Aspect show = Aspect::final;
    CompareMode compare = CompareMode::off;
    float wipe = 0.5f;   ///< where the picture is parted, 0 … 1
    bool wiping = false; ///< the mouse holds the line between the two
    bool turntable = false;
    double turns_a_minute = 4;
    bool playing = false;   ///< the animation
    View view = View::srgb; ///< with the sRGB curve, as files have it, or plain numbers
    Kernel kernel = Kernel::automatic;
};

} // namespace glint::viewer
