#pragma once
// Projects points and segments of the scene into the picture, to draw rays over it.

#include "glint/scene.h"

#include <optional>
#include <utility>

namespace glint::viewer {

/// In pixels from the picture's top left; (0.5, 0.5) is the centre of pixel (0, 0).
struct PixelPoint {
    double x = 0;
    double y = 0;
};

class Projection {
  public:
    Projection(const CameraDescription& camera, int width, int height);

    /// None for points behind the eye, or in its plane.
    std::optional<PixelPoint> point(const Vec3& position) const;
    /// The ends of the part of a segment that lies before the eye; none if no part does.
    std::optional<std::pair<PixelPoint, PixelPoint>> line(const Vec3& from, const Vec3& to) const;

  private:
    Vec3 to_camera(const Vec3& position) const;
    PixelPoint project(const Vec3& in_camera) const;

    Vec3 eye_;
    Vec3 right_;
    Vec3 up_;
    Vec3 forward_;
    double pixels_per_tangent_ = 1;
    double width_ = 1;
    double height_ = 1;
};

} // namespace glint::viewer
