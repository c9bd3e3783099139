// The rows of the table of keys.
#include "shortcuts.h"

#include <GLFW/glfw3.h>

#include <array>

namespace glint::viewer {
namespace {

constexpr std::array table{
    Shortcut{Action::help, 0, U'?', false, false, "?", "this list"},
    Shortcut{Action::help, GLFW_KEY_F1, 0, false, false, "", ""},
    Shortcut{Action::panel, GLFW_KEY_TAB, 0, false, false, "Tab", "hide or show the panel"},
    Shortcut{Action::theme, 0, U'l', false, false, "L", "dark or light"},
    Shortcut{Action::reset_camera, GLFW_KEY_HOME, 0, false, false, "Home, R", "the camera of the file"},
    Shortcut{Action::reset_camera, 0, U'r', false, false, "", ""},
    Shortcut{Action::turn_left, GLFW_KEY_LEFT, 0, false, false, "Arrows", "orbit"},
    Shortcut{Action::turn_right, GLFW_KEY_RIGHT, 0, false, false, "", ""},
    Shortcut{Action::turn_up, GLFW_KEY_UP, 0, false, false, "", ""},
    Shortcut{Action::turn_down, GLFW_KEY_DOWN, 0, false, false, "", ""},
    Shortcut{Action::move_left, GLFW_KEY_LEFT, 0, false, true, "Shift + arrows", "pan"},
    Shortcut{Action::move_right, GLFW_KEY_RIGHT, 0, false, true, "", ""},
    Shortcut{Action::move_up, GLFW_KEY_UP, 0, false, true, "", ""},
    Shortcut{Action::move_down, GLFW_KEY_DOWN, 0, false, true, "", ""},
    Shortcut{Action::nearer, 0, U'+', false, false, "+  \u2212", "zoom"},
    Shortcut{Action::nearer, 0, U'=', false, false, "", ""},
    Shortcut{Action::farther, 0, U'-', false, false, "", ""},
    Shortcut{Action::narrower, 0, U'[', false, false, "[  ]", "field of view"},
    Shortcut{Action::wider, 0, U']', false, false, "", ""},
    Shortcut{Action::turntable, 0, U't', false, false, "T", "turntable"},
    Shortcut{Action::play, GLFW_KEY_SPACE, 0, false, false, "Space", "play or stop the animation"},
    Shortcut{Action::previous_frame, 0, U',', false, false, ",  .", "one frame back or on"},
    Shortcut{Action::next_frame, 0, U'.', false, false, "", ""},
    Shortcut{Action::keep, 0, U'k', false, false, "K", "keep these settings as A, to compare with"},
    Shortcut{Action::compare, 0, U'c', false, false, "C", "compare: wipe, side by side, off"},
    Shortcut{Action::next_quantity, 0, U'v', false, false, "V  Shift + V",
             "show the next or previous quantity"},
    Shortcut{Action::previous_quantity, 0, U'V', false, false, "", ""},
    Shortcut{Action::final_quantity, 0, U'f', false, false, "F", "show the final picture"},
    Shortcut{Action::backend, 0, U'g', false, false, "G", "draw on the graphics card or on the CPU"},
    Shortcut{Action::undo, GLFW_KEY_Z, 0, true, false, "Ctrl + Z, Y", "undo, redo"},
    Shortcut{Action::redo, GLFW_KEY_Y, 0, true, false, "", ""},
    Shortcut{Action::redo, GLFW_KEY_Z, 0, true, true, "", ""},
    Shortcut{Action::reload, GLFW_KEY_F5, 0, false, false, "F5", "read the file again"},
    Shortcut{Action::save_scene, GLFW_KEY_S, 0, true, false, "Ctrl + S", "save the scene"},
    Shortcut{Action::save_picture, GLFW_KEY_P, 0, true, false, "Ctrl + P", "save the picture"},
    Shortcut{Action::copy_camera, GLFW_KEY_C, 0, true, false, "Ctrl + C", "copy the camera as TOML"},
    Shortcut{Action::save_window, GLFW_KEY_F12, 0, false, false, "F12", "save what the window shows"},
    Shortcut{Action::clear_pixel, GLFW_KEY_ESCAPE, 0, false, false, "Esc",
             "let go of the pixel; close this list"},
    Shortcut{Action::quit, GLFW_KEY_Q, 0, true, false, "Ctrl + Q", "close the window"},
};

constexpr std::array gesture_table{
    Gesture{"Click", "explain the pixel"},
    Gesture{"Drag", "orbit"},
    Gesture{"Shift + drag, right drag", "pan"},
    Gesture{"Ctrl + drag, wheel", "zoom"},
    Gesture{"Hold W A S D, Q E", "fly: ahead, left, back, right, down, up"},
    Gesture{"Ctrl + click on a slider", "type the number"},
    Gesture{"Drop a file", "open it"},
};

} // namespace

std::span<const Shortcut> shortcuts() { return table; }

std::span<const Gesture> gestures() { return gesture_table; }

std::optional<Action> action_of(const KeyPress& key) {
    for (const Shortcut& shortcut : table) {
        if (shortcut.character != 0 ? shortcut.character == key.character
                                    : key.character == 0 && shortcut.code == key.code &&
                                          shortcut.control == key.control && shortcut.shift == key.shift)
            return shortcut.action;
    }
    return std::nullopt;
}

} // namespace glint::viewer
