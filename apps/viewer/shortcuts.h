#pragma once
// The table of keys: for the keyboard, the list that `?` shows, and docs/viewer.md.

#include "window.h"

#include <optional>
#include <span>

namespace glint::viewer {

enum class Action {
    help,
    panel,
    theme,
    reset_camera,
    turn_left,
    turn_right,
    turn_up,
    turn_down,
    move_left,
    move_right,
    move_up,
    move_down,
    nearer,
    farther,
    narrower,
    wider,
    turntable,
    play,
    next_frame,
    previous_frame,
    keep,
    compare,
    next_quantity,
    previous_quantity,
    final_quantity,
    backend,
    undo,
    redo,
    reload,
    save_scene,
    save_picture,
    save_window,
    copy_camera,
    clear_pixel,
    quit ///< last: see action_count
};
inline constexpr int action_count = static_cast<int>(Action::quit) + 1;

struct Shortcut {
    Action action;
    int code;           ///< key of GLFW, or 0
    char32_t character; ///< or a character, on whichever key it is
    bool control;
    bool shift;
    const char* keys; ///< for the list; empty: an alternative to the row before, not listed
    const char* help;
};

/// In the order of the list.
std::span<const Shortcut> shortcuts();

/// What the mouse and held keys do; listed, but handled by Navigation.
struct Gesture {
    const char* keys;
    const char* help;
};
std::span<const Gesture> gestures();

/// None if the key does nothing.
std::optional<Action> action_of(const KeyPress& key);

} // namespace glint::viewer
