// Pinhole projection and clipping at the eye.
#include "projection.h"

#include "glint/fov_axis.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace glint::viewer {

Projection::Projection(const CameraDescription& camera, int width, int height)
    : eye_(camera.eye), forward_(glm::normalize(camera.direction)), width_(width), height_(height) {
    right_ = glm::normalize(glm::cross(forward_, camera.up));
    up_ = glm::cross(right_, forward_);
    pixels_per_tangent_ =
        fov_side(camera.fov_axis, width_, height_) / 2 / std::tan(glm::radians(camera.fov / 2));
}

/// Camera space: right, up, forward.
Vec3 Projection::to_camera(const Vec3& position) const {
    const Vec3 offset = position - eye_;
    return {glm::dot(offset, right_), glm::dot(offset, up_), glm::dot(offset, forward_)};
}

PixelPoint Projection::project(const Vec3& in_camera) const {
    return {width_ / 2 + in_camera.x / in_camera.z * pixels_per_tangent_,
            height_ / 2 - in_camera.y / in_camera.z * pixels_per_tangent_};
}

std::optional<PixelPoint> Projection::point(const Vec3& position) const {
    const Vec3 in_camera = to_camera(position);
    if (!(in_camera.z > 0)) return std::nullopt;
    return project(in_camera);
}

std::optional<std::pair<PixelPoint, PixelPoint>> Projection::line(const Vec3& from, const Vec3& to) const {
    Vec3 a = to_camera(from);
    Vec3 b = to_camera(to);
    // A segment that passes the eye is clipped a little before it, so that its end is at most some pictures
    // away.
    const double nearest = std::max({std::abs(a.z), std::abs(b.z), glm::length(b - a)}) * 1e-3;
    if (!(a.z > nearest) && !(b.z > nearest)) return std::nullopt;
    if (a.z < nearest) a = b + (a - b) * ((b.z - nearest) / (b.z - a.z));
    if (b.z < nearest) b = a + (b - a) * ((a.z - nearest) / (a.z - b.z));
    return std::pair{project(a), project(b)};
}

} // namespace glint::viewer
