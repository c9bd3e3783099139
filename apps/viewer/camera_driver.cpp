// Movements as calls of CameraControl.
#include "camera_driver.h"

#include "activity.h"
#include "session/session.h"

namespace glint::viewer {
namespace {

constexpr double two_pi = 6.2831853;
/// Dragging over this many heights of the picture makes a full turn.
constexpr double heights_per_turn = 2.5;
/// In target distances per second.
constexpr double flight_speed = 0.6;
constexpr double turns_per_minute = 4;
constexpr double fov_factor = 0.94;

} // namespace

/// The scene follows the hand, so the eye moves the other way.
void CameraDriver::move(const Movement& m) {
    constexpr double radians = two_pi / heights_per_turn;
    const bool orbits = m.turn_right != 0 || m.turn_up != 0;
    if (orbits) session_.pick_orbit_target();
    session_.move([&](CameraControl& c) {
        if (orbits) c.orbit(-m.turn_right * radians, -m.turn_up * radians);
        if (m.move_right != 0 || m.move_up != 0) c.pan(-m.move_right, -m.move_up);
        if (m.nearer != 0) c.zoom(m.nearer);
        if (m.fly_right != 0 || m.fly_up != 0 || m.fly_ahead != 0)
            c.fly(m.fly_right * flight_speed, m.fly_up * flight_speed, m.fly_ahead * flight_speed);
    });
    activity_.camera_moved();
}

void CameraDriver::turn(double seconds) {
    session_.pick_orbit_target();
    session_.move([&](CameraControl& c) { c.turn(seconds, turns_per_minute); });
    activity_.camera_moved();
}

void CameraDriver::narrow() {
    session_.move([](CameraControl& c) { c.set_fov(c.camera().fov * fov_factor); });
    activity_.camera_moved();
}

void CameraDriver::widen() {
    session_.move([](CameraControl& c) { c.set_fov(c.camera().fov / fov_factor); });
    activity_.camera_moved();
}

void CameraDriver::reset() {
    session_.move([](CameraControl& c) { c.reset(); });
    activity_.camera_moved();
}

void CameraDriver::set(const CameraDescription& camera) {
    session_.move([&](CameraControl& c) { c.set_camera(camera, c.target_distance()); });
    activity_.camera_moved();
}

} // namespace glint::viewer
