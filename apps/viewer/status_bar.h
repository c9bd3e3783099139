#pragma once
// The two lines below the picture: the status, and the timeline of an animation.

#include "session/rendered_frame.h"
#include "ui_map.h"
#include "widgets.h"

#include "glint/kernels.h"

#include <optional>

namespace glint::viewer {

class Playback;

/// What the status line shows.
struct Status {
    const RenderedFrame* frame = nullptr; ///< null: nothing is rendered yet
    int spp = 1;                          ///< samples per pixel of the scene
    Kernel kernel = Kernel::automatic;
    int threads = 0; ///< 0: one for each core
};

/// True if the list of keys was asked for.
bool draw_status(Ui& ui, const Area& area, const Status& status);

/// Lets the user play the animation or seek in it. `frame`: the one shown.
void draw_timeline(Ui& ui, const Area& area, const Animation& animation, double frame, Playback& playback);

} // namespace glint::viewer
