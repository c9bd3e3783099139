#pragma once
// What keys do, in one table: it drives the keyboard, the list that `?` shows, and docs/viewer.md.

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
    let_go,
    quit
};

struct Shortcut {
    Action action;
    int code;           ///< GLFW's key, or 0
    char32_t character; ///< or a character, wherever the keyboard has it
    bool control;
    bool shift;
    const char* keys; ///< as people read it; empty: another spelling of the line before
    const char* what;
};

/// The table, in the order in which it is shown; an empty `keys` is not shown.
std::span<const Shortcut> shortcuts();

/// What is done with the mouse, and keys that are held: not in the table since they take time.
struct Gesture {
    const char* keys;
    const char* what;
};
std::span<const Gesture> gestures();

/// What the key asks for, if anything.
std::optional<Action> action_of(const KeyPress& key);

} // namespace glint::viewer
