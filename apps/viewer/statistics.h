#pragma once
// What --ui-stats prints: how long frames of the window took, and the rate of pictures while the camera
// moved.

#include "session/times.h"

#include <string>

namespace glint::viewer {

class Statistics {
  public:
    /// `last_move`: when the camera last moved.
    void frame_drawn(double seconds, double last_move);
    void picture_shown(double last_move);
    std::string text() const;

  private:
    FrameTimes frames_;
    FrameTimes moving_frames_; ///< while the camera moved
    FrameTimes pictures_;      ///< from picture to picture while the camera moved
    double last_picture_ = 0;
};

} // namespace glint::viewer
