#pragma once
// Moving a camera by hand. The eye looks at a target; up stays up.

#include "glint/scene.h"

namespace glint::viewer {

class CameraControl {
  public:
    CameraControl() = default;
    /// A camera, and how far ahead of its eye the target is. reset() comes back to it.
    CameraControl(const CameraDescription& home, double target_distance);

    const CameraDescription& camera() const { return camera_; }
    Vec3 target() const;
    double target_distance() const { return distance_; }

    /// Around the target, in radians: the eye goes to the right, and up as far as just before the pole. The
    /// distance stays.
    void orbit(double right, double up);
    /// Along the picture; 1 is the picture's height at the target.
    void pan(double right, double up);
    /// So many notches of a wheel nearer to the target: a tenth of the way each, and never there.
    void zoom(double notches);
    /// Eye and target together, in target distances: to the right, up in the picture, ahead.
    void fly(double right, double up, double ahead);
    /// The field of view in degrees, kept within 1 and 170.
    void set_fov(double degrees);
    /// A turntable, for so many seconds.
    void turn(double seconds, double turns_a_minute);
    /// To the home camera, exactly.
    void reset();
    /// Is the target what stood in the picture's middle when it was chosen, or what was turned around since?
    /// Panning, flying and another camera leave it behind.
    bool is_aimed() const { return aimed_; }
    /// Something so far ahead becomes the target.
    void aim(double target_distance);
    /// To another camera, which stays away from home.
    void set_camera(const CameraDescription& camera, double target_distance);

  private:
    struct Axes {
        Vec3 right, up, ahead;
    };
    Axes axes() const;

    CameraDescription home_;
    CameraDescription camera_;
    double home_distance_ = 1;
    double distance_ = 1;
    bool aimed_ = true;
};

/// Do both see the same?
bool same_view(const CameraDescription& a, const CameraDescription& b);

/// How far ahead a camera of the scene finds what it looks at: the first hit in the picture's middle, else
/// the middle of everything finite, else 1.
double target_distance(const Scene& scene);

} // namespace glint::viewer
