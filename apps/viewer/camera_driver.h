#pragma once
// Moves the session's camera as mouse, keys and turntable ask.

#include "navigation.h"

#include "glint/scene.h"

namespace glint::viewer {

class Activity;
class Session;

class CameraDriver {
  public:
    CameraDriver(Session& session, Activity& activity) : session_(session), activity_(activity) {}

    void move(const Movement& movement);
    /// The turntable, for that time.
    void turn(double seconds);
    /// Field of view, a little smaller or larger.
    void narrow();
    void widen();
    /// To the camera of the file.
    void reset();
    /// To a camera typed in; the distance of the orbit's target stays.
    void set(const CameraDescription& camera);

  private:
    Session& session_;
    Activity& activity_;
};

} // namespace glint::viewer
