#pragma once
// From the mouse and held keys to movements of the camera.

#include "ui_map.h"
#include "window.h"

#include <cstddef>
#include <optional>
#include <set>
#include <span>

namespace glint::viewer {

/// What the user did with the picture since the last frame. Distances are in shares of the picture's height.
struct Movement {
    double turn_right = 0; ///< orbit
    double turn_up = 0;
    double move_right = 0; ///< pan: what is seen moves along
    double move_up = 0;
    double nearer = 0;    ///< zoom: 1 is one notch of a wheel
    double fly_ahead = 0; ///< seconds of flight
    double fly_right = 0;
    double fly_up = 0;

    bool is_none() const {
        return turn_right == 0 && turn_up == 0 && move_right == 0 && move_up == 0 && nearer == 0 &&
               fly_ahead == 0 && fly_right == 0 && fly_up == 0;
    }
};

/// A place in a picture, 0 … 1 from its left and top.
struct PicturePlace {
    std::size_t picture = 0; ///< which of several
    double across = 0;
    double down = 0;
};

class Navigation {
  public:
    /// Reads Dear ImGui's mouse over the pictures, between begin_frame() and the end of the frame, unless a
    /// widget has it; and the held keys, unless text is being typed.
    Movement read(const Window& window, std::span<const Area> pictures, double seconds);

    /// That key was pressed for something else, with Ctrl: until it is let go it does not fly, whichever of
    /// the two is let go first.
    void ignore(int code) { ignored_.insert(code); }

    /// Where the mouse was pressed and let go without moving, once.
    std::optional<PicturePlace> take_click();
    /// Does the mouse move the camera now?
    bool is_dragging() const { return dragging_; }
    /// Is a key held that flies?
    bool is_flying() const { return flying_; }

  private:
    double held(const Window& window, int plus, int minus) const;
    void read_drag(std::span<const Area> pictures, Movement& movement);

    std::optional<std::size_t> pressed_; ///< a button went down over that picture
    bool dragging_ = false;              ///< and the mouse has moved since
    bool flying_ = false;
    std::optional<PicturePlace> click_;
    std::set<int> ignored_; ///< keys
};

} // namespace glint::viewer
