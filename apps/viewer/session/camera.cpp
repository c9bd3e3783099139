// Orbit, pan, zoom and flight of a camera.
#include "camera.h"

#include "glint/pick.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace glint::viewer {
namespace {

constexpr double pi = 3.14159265358979323846;
/// Angle that an orbit keeps from the poles, in radians.
constexpr double pole_margin = 0.01;
/// Factor of the target distance for each notch of the wheel.
constexpr double notch = 0.9;

/// Rotates v about a unit axis (Rodrigues' formula).
Vec3 rotated(const Vec3& v, const Vec3& axis, double angle) {
    const double c = std::cos(angle);
    return v * c + glm::cross(axis, v) * std::sin(angle) + axis * (glm::dot(axis, v) * (1 - c));
}

} // namespace

CameraControl::CameraControl(const CameraDescription& home, double target_distance)
    : home_(home), camera_(home), home_distance_(target_distance), distance_(target_distance) {}

Vec3 CameraControl::target() const { return camera_.eye + axes().ahead * distance_; }

CameraControl::Axes CameraControl::axes() const {
    Axes a;
    a.ahead = glm::normalize(camera_.direction);
    a.right = glm::normalize(glm::cross(a.ahead, camera_.up));
    a.up = glm::cross(a.right, a.ahead);
    return a;
}

void CameraControl::orbit(double right, double up) {
    const Vec3 pivot = target();
    const Vec3 pole = glm::normalize(camera_.up);
    const Axes a = axes();
    // The eye's latitude must stay between the poles.
    const double latitude = std::asin(std::clamp(-glm::dot(a.ahead, pole), -1.0, 1.0));
    const double max_latitude = std::max(pi / 2 - pole_margin, std::abs(latitude));
    const double climb = std::clamp(latitude + up, -max_latitude, max_latitude) - latitude;
    const Vec3 raised = rotated(a.ahead, a.right, -climb);
    camera_.direction = glm::normalize(rotated(raised, pole, right));
    camera_.eye = pivot - camera_.direction * distance_;
}

void CameraControl::pan(double right, double up) {
    const Axes a = axes();
    const double height = 2 * distance_ * std::tan(camera_.fov / 2 * pi / 180);
    camera_.eye += (a.right * right + a.up * up) * height;
    has_picked_target_ = false;
}

void CameraControl::zoom(double notches) {
    const Vec3 pivot = target();
    distance_ *= std::pow(notch, notches);
    camera_.eye = pivot - axes().ahead * distance_;
}

void CameraControl::fly(double right, double up, double ahead) {
    const Axes a = axes();
    camera_.eye += (a.right * right + a.up * up + a.ahead * ahead) * distance_;
    has_picked_target_ = false;
}

void CameraControl::set_fov(double degrees) { camera_.fov = std::clamp(degrees, 1.0, 170.0); }

bool CameraControl::is_home() const { return same_view(camera_, home_); }

void CameraControl::reset() {
    camera_ = home_;
    distance_ = home_distance_;
    has_picked_target_ = true;
}

void CameraControl::set_target(double target_distance) {
    distance_ = target_distance;
    has_picked_target_ = true;
}

void CameraControl::look_from(const Vec3& eye) {
    const Vec3 to_target = target() - eye;
    camera_.eye = eye;
    distance_ = glm::length(to_target);
    camera_.direction = to_target / distance_;
}

void CameraControl::set_camera(const CameraDescription& camera, double target_distance) {
    camera_ = camera;
    distance_ = target_distance;
    has_picked_target_ = false;
}

bool same_view(const CameraDescription& a, const CameraDescription& b) {
    return a.eye == b.eye && a.direction == b.direction && a.up == b.up && a.fov == b.fov &&
           a.fov_axis == b.fov_axis;
}

double target_distance(const Scene& scene) {
    const RenderSettings& r = scene.render_settings();
    if (const auto hit = pick(scene, r.width / 2.0, r.height / 2.0)) return hit->distance;
    const SceneStats stats = scene.stats();
    const Vec3 direction = glm::normalize(scene.camera().direction);
    const double ahead =
        glm::dot((stats.bounds_min + stats.bounds_max) * 0.5 - scene.camera().eye, direction);
    const bool has_bounds = stats.bounds_min.x <= stats.bounds_max.x;
    return has_bounds && ahead > 0 ? ahead : 1;
}

} // namespace glint::viewer
