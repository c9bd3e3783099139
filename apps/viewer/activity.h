#pragma once
// When the scene or the camera last changed.

namespace glint::viewer {

/// Seconds of a monotonic clock.
double now();

class Activity {
  public:
    /// Something that the pictures show has changed, or how they are rendered.
    void scene_changed() { last_change_ = now(); }
    void camera_moved() { last_change_ = last_move_ = now(); }

    /// Times of now(); 0: never.
    double last_change() const { return last_change_; }
    double last_move() const { return last_move_; }

    double seconds_since_change() const { return now() - last_change_; }
    double seconds_since_move() const { return now() - last_move_; }

  private:
    double last_change_ = 0;
    double last_move_ = 0;
};

/// Time that a change takes to reach the pictures, at most.
inline constexpr double settle_seconds = 0.25;

} // namespace glint::viewer
