#pragma once
// Where places of the scene stand in the picture: what draws rays over it.

#include "glint/scene.h"

#include <optional>
#include <utility>

namespace glint::viewer {

/// A place in the picture, in pixels from its top left; (0.5, 0.5) is the centre of pixel (0, 0).
struct PicturePoint {
    double x = 0;
    double y = 0;
};

class Projection {
  public:
    Projection(const CameraDescription& camera, int width, int height);

    /// None for what lies behind the eye, or in its plane.
    std::optional<PicturePoint> point(const Vec3& place) const;
    /// Both ends of what is before the eye of a stretch; none where nothing is.
    std::optional<std::pair<PicturePoint, PicturePoint>> line(const Vec3& from, const Vec3& to) const;

  private:
    Vec3 seen(const Vec3& place) const;
    PicturePoint at(const Vec3& seen) const;

    Vec3 eye_;
    Vec3 right_;
    Vec3 up_;
    Vec3 forward_;
    double pixels_a_tangent_ = 1;
    double width_ = 1;
    double height_ = 1;
};

} // namespace glint::viewer
