// Reads the mouse from Dear ImGui and held keys from the window.
#include "navigation.h"

#include "scene_editor.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <utility>

namespace glint::viewer {
namespace {

constexpr double two_pi = 6.2831853;
/// Dragging over this many heights of the picture makes a full turn.
constexpr double heights_per_turn = 2.5;
/// In target distances per second.
constexpr double flight_speed = 0.6;
constexpr double turns_per_minute = 4;

} // namespace

/// The scene follows the hand, so the eye moves the other way.
void move_camera(SceneEditor& editor, const Movement& m) {
    constexpr double radians = two_pi / heights_per_turn;
    const bool orbits = m.turn_right != 0 || m.turn_up != 0;
    if (orbits) editor.orbit(-m.turn_right * radians, -m.turn_up * radians);
    editor.move([&](CameraControl& c) {
        if (m.move_right != 0 || m.move_up != 0) c.pan(-m.move_right, -m.move_up);
        if (m.nearer != 0) c.zoom(m.nearer);
        if (m.fly_right != 0 || m.fly_up != 0 || m.fly_ahead != 0)
            c.fly(m.fly_right * flight_speed, m.fly_up * flight_speed, m.fly_ahead * flight_speed);
    });
}

void turn_camera(SceneEditor& editor, double seconds) {
    editor.orbit(seconds * turns_per_minute * two_pi / 60, 0);
}

/// 1, 0 or −1 from two opposite keys.
double Navigation::axis(const Window& window, int plus, int minus) const {
    const auto held = [&](int code) { return window.is_held(code) && !ignored_.contains(code) ? 1.0 : 0.0; };
    return held(plus) - held(minus);
}

void Navigation::read_drag(std::span<const Area> pictures, Movement& movement) {
    // The pressed picture may have disappeared.
    if (pressed_ && *pressed_ >= pictures.size()) pressed_.reset();
    const ImGuiIO& io = ImGui::GetIO();
    const bool left = io.MouseDown[0];
    const bool other = io.MouseDown[1] || io.MouseDown[2];
    if (!left && !other) {
        if (pressed_ && !dragging_ && io.MouseReleased[0]) {
            const Area& picture = pictures[*pressed_];
            click_ = PicturePosition{*pressed_, (io.MousePos.x - picture.x) / picture.width,
                                     (io.MousePos.y - picture.y) / picture.height};
        }
        pressed_.reset();
        dragging_ = false;
        return;
    }
    if (!pressed_) return;
    const Area& picture = pictures[*pressed_];
    // A click may move the mouse by a few pixels.
    if (ImGui::IsMouseDragging(0, 4) || ImGui::IsMouseDragging(1, 2) || ImGui::IsMouseDragging(2, 2))
        dragging_ = true;
    if (!dragging_) return;
    const double right = io.MouseDelta.x / picture.height;
    const double up = -io.MouseDelta.y / picture.height;
    if (left && io.KeyCtrl) {
        movement.nearer += up * 12;
    } else if (other || io.KeyShift) {
        movement.move_right += right;
        movement.move_up += up;
    } else {
        movement.turn_right += right;
        movement.turn_up += up;
    }
}

Movement Navigation::read(const Window& window, std::span<const Area> pictures, double seconds) {
    const ImGuiIO& io = ImGui::GetIO();
    Movement movement;
    std::optional<std::size_t> over;
    for (std::size_t i = 0; i < pictures.size() && !io.WantCaptureMouse; ++i)
        if (pictures[i].contains(io.MousePos.x, io.MousePos.y)) over = i;
    if (over && (io.MouseClicked[0] || io.MouseClicked[1] || io.MouseClicked[2])) pressed_ = over;
    read_drag(pictures, movement);
    if (over) movement.nearer += io.MouseWheel;
    std::erase_if(ignored_, [&](int code) { return !window.is_held(code); });
    if (!io.WantTextInput && !io.KeyCtrl) {
        movement.fly_ahead = axis(window, GLFW_KEY_W, GLFW_KEY_S) * seconds;
        movement.fly_right = axis(window, GLFW_KEY_D, GLFW_KEY_A) * seconds;
        movement.fly_up = axis(window, GLFW_KEY_E, GLFW_KEY_Q) * seconds;
    }
    flying_ = movement.fly_ahead != 0 || movement.fly_right != 0 || movement.fly_up != 0;
    return movement;
}

std::optional<PicturePosition> Navigation::take_click() { return std::exchange(click_, std::nullopt); }

} // namespace glint::viewer
