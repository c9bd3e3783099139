#pragma once
// Plays the scene's animation.

#include "ui_map.h"

namespace glint::viewer {

class Messages;
class SceneEditor;

class Playback {
  public:
    Playback(SceneEditor& editor, Messages& messages) : editor_(editor), messages_(messages) {}

    bool is_playing() const { return playing_; }
    /// Plays, or stops at a whole frame, which `glint render --frame` can render.
    void toggle();
    /// Stops and goes that many frames on, or back.
    void step(int frames);
    /// Stops and shows the nearest whole frame.
    void seek(double frame);
    /// Plays on in real time, from the last frame to the first.
    void advance(double seconds);
    void report(UiMap& map) const;

  private:
    void show(double frame);

    SceneEditor& editor_;
    Messages& messages_;
    bool playing_ = false;
};

} // namespace glint::viewer
