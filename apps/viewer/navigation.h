#pragma once
// Moves the camera as mouse, held keys and turntable ask.

#include "ui_map.h"
#include "window.h"

#include <cstddef>
#include <optional>
#include <set>
#include <span>

namespace glint::viewer {

class SceneEditor;

/// Movements asked for since the last frame. Distances are fractions of the picture's height.
struct Movement {
    double turn_right = 0; ///< orbit
    double turn_up = 0;
    double move_right = 0; ///< pan: the scene follows
    double move_up = 0;
    double nearer = 0;    ///< zoom, in notches of a wheel
    double fly_ahead = 0; ///< seconds of flight
    double fly_right = 0;
    double fly_up = 0;

    friend bool operator==(const Movement&, const Movement&) = default;
};

/// A position in one of several pictures.
struct PicturePosition {
    std::size_t picture = 0; ///< index of its area
    double u = 0;            ///< 0 left, 1 right
    double v = 0;            ///< 0 top, 1 bottom
};

void move_camera(SceneEditor& editor, const Movement& movement);
/// Turns it as on a turntable for that time.
void turn_camera(SceneEditor& editor, double seconds);

class Navigation {
  public:
    /// Reads the mouse over the pictures, unless a widget uses it, and the held keys, unless text is typed.
    /// Call within a frame of Dear ImGui. `seconds`: since the last call.
    Movement read(const Window& window, std::span<const Area> pictures, double seconds);

    /// Ignores a key until it is released: it was pressed with Ctrl, and Ctrl may be released first.
    void ignore(int code) { ignored_.insert(code); }

    /// Where the mouse was clicked without moving; returned once.
    std::optional<PicturePosition> take_click();
    /// Is a key held that moves the camera?
    bool is_flying() const { return flying_; }

  private:
    double axis(const Window& window, int plus, int minus) const;
    void read_drag(std::span<const Area> pictures, Movement& movement);

    std::optional<std::size_t> pressed_; ///< picture over which a button was pressed
    bool dragging_ = false;              ///< the mouse has moved since
    bool flying_ = false;
    std::optional<PicturePosition> click_;
    std::set<int> ignored_; ///< key codes
};

} // namespace glint::viewer
