#pragma once
// The two lines below the picture: the status, and the timeline of an animation.

#include "widgets.h"

#include "glint/kernels.h"

namespace glint::viewer {

class Playback;
class SceneEditor;

/// True if the list of keys was asked for. `threads` = 0: one for each processor.
bool draw_status(Ui& ui, const Area& area, const SceneEditor& editor, Kernel kernel, int threads);

/// Lets the user play the animation or seek in it. Requires an animation.
void draw_timeline(Ui& ui, const Area& area, const SceneEditor& editor, Playback& playback);

} // namespace glint::viewer
