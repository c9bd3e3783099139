#pragma once
// A camera moved by hand: it looks at a target that it orbits, and its up vector stays.

#include "glint/scene.h"

namespace glint::viewer {

class CameraControl {
  public:
    CameraControl() = default;
    /// `target_distance`: from the eye to the orbit's target, along the camera's direction. reset() returns
    /// to both.
    CameraControl(const CameraDescription& home, double target_distance);

    const CameraDescription& camera() const { return camera_; }
    Vec3 target() const;
    double target_distance() const { return distance_; }

    /// Moves the eye around the target, to the right and up, in radians; up to just before the poles. The
    /// distance stays.
    void orbit(double right, double up);
    /// Moves eye and target in the picture's plane; 1 is the picture's height at the target.
    void pan(double right, double up);
    /// Moves the eye towards the target by notches of a wheel, each a tenth of the remaining distance.
    void zoom(double notches);
    /// Moves eye and target, in target distances: right, up in the picture, ahead.
    void fly(double right, double up, double ahead);
    /// The field of view in degrees, clamped to 1 … 170.
    void set_fov(double degrees);
    /// Back to the home camera, exactly.
    void reset();
    bool is_home() const;
    /// Was the target set by set_target() or reset(), with only orbiting and zooming since? Panning, flying
    /// and another camera lose it.
    bool has_picked_target() const { return has_picked_target_; }
    /// The orbit's target, at this distance ahead of the eye.
    void set_target(double target_distance);
    /// Moves the eye; the target stays.
    void look_from(const Vec3& eye);
    /// Another camera; home stays.
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
    bool has_picked_target_ = true;
};

/// Do both cameras see the same?
bool same_view(const CameraDescription& a, const CameraDescription& b);

/// A distance for the orbit's target of a scene's camera: the first hit in the picture's middle, else the
/// depth of the bounding box's centre if that lies ahead, else 1.
double target_distance(const Scene& scene);

} // namespace glint::viewer
