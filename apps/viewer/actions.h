#pragma once
// The table of keys: what each does, for the keyboard, the list that `?` shows, and docs/viewer.md.

#include "window.h"

#include <span>

namespace glint::viewer {

class App;

using Action = void (*)(App&);

struct Shortcut {
    KeyPress key;
    const char* keys; ///< for the list; empty: an alternative to the row before, not listed
    const char* help;
    bool needs_scene;
    Action action;
};

/// In the order of the list.
std::span<const Shortcut> shortcuts();

/// What the mouse and held keys do; listed, but handled by Navigation.
struct Gesture {
    const char* keys;
    const char* help;
};
std::span<const Gesture> gestures();

// Actions that have buttons too; all but the first only where there is a scene.
void toggle_help(App& app);
void keep(App& app);
void reset_camera(App& app);
void copy_camera(App& app);
void toggle_turntable(App& app);
void save_picture(App& app);
void save_scene(App& app);
void undo(App& app);
void redo(App& app);

} // namespace glint::viewer
