#include "projection.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace glint::viewer {
namespace {

double measured_side(FovAxis axis, double width, double height) {
    switch (axis) {
    case FovAxis::x:
        return width;
    case FovAxis::smaller:
        return std::min(width, height);
    case FovAxis::larger:
        return std::max(width, height);
    case FovAxis::y:
        break;
    }
    return height;
}

} // namespace

Projection::Projection(const CameraDescription& camera, int width, int height)
    : eye_(camera.eye), forward_(glm::normalize(camera.direction)), width_(width), height_(height) {
    right_ = glm::normalize(glm::cross(forward_, camera.up));
    up_ = glm::cross(right_, forward_);
    pixels_a_tangent_ =
        measured_side(camera.fov_axis, width_, height_) / 2 / std::tan(glm::radians(camera.fov / 2));
}

/// To the right, up, and away.
Vec3 Projection::seen(const Vec3& place) const {
    const Vec3 way = place - eye_;
    return {glm::dot(way, right_), glm::dot(way, up_), glm::dot(way, forward_)};
}

PicturePoint Projection::at(const Vec3& seen) const {
    return {width_ / 2 + seen.x / seen.z * pixels_a_tangent_,
            height_ / 2 - seen.y / seen.z * pixels_a_tangent_};
}

std::optional<PicturePoint> Projection::point(const Vec3& place) const {
    const Vec3 s = seen(place);
    if (!(s.z > 0)) return std::nullopt;
    return at(s);
}

std::optional<std::pair<PicturePoint, PicturePoint>> Projection::line(const Vec3& from,
                                                                      const Vec3& to) const {
    Vec3 a = seen(from);
    Vec3 b = seen(to);
    // A stretch that passes the eye is cut a little before it, where it is still within a few pictures'
    // reach.
    const double nearest = std::max({std::abs(a.z), std::abs(b.z), glm::length(b - a)}) * 1e-3;
    if (!(a.z > nearest) && !(b.z > nearest)) return std::nullopt;
    if (a.z < nearest) a = b + (a - b) * ((b.z - nearest) / (b.z - a.z));
    if (b.z < nearest) b = a + (b - a) * ((a.z - nearest) / (a.z - b.z));
    return std::pair{at(a), at(b)};
}

} // namespace glint::viewer
