// The rows of the table of keys, and what the actions do.
#include "actions.h"

#include "app.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <array>

namespace glint::viewer {
namespace {

/// Movement for one press of a key.
constexpr double key_turn = 0.06;
constexpr double key_move = 0.05;
/// Of the field of view.
constexpr double fov_factor = 0.94;

void switch_theme(App& app) {
    app.state.theme = app.state.theme == ThemeChoice::dark ? ThemeChoice::light : ThemeChoice::dark;
}

void narrow_fov(App& app) {
    app.editor.move([](CameraControl& c) { c.set_fov(c.camera().fov * fov_factor); });
}

void widen_fov(App& app) {
    app.editor.move([](CameraControl& c) { c.set_fov(c.camera().fov / fov_factor); });
}

void compare(App& app) {
    if (!app.editor.has_kept())
        return app.messages.show("Nothing to compare with: keep these settings with K first");
    app.state.compare = static_cast<CompareMode>((static_cast<int>(app.state.compare) + 1) % 3);
}

/// `step` on in the list of AOVs, around its end.
void show_next(App& app, int step) {
    const Integrator integrator = app.editor.description()->render.integrator;
    do app.state.show = static_cast<Aov>((static_cast<int>(app.state.show) + step + aov_count) % aov_count);
    while (!has_aov(integrator, app.state.show));
    app.messages.show(std::string("Showing: ") + aov_name(app.state.show));
}

void switch_backend(App& app) {
    app.state.gpu = !app.state.gpu;
    app.messages.show(app.state.gpu ? "Drawn by the GPU" : "Drawn by the CPU");
}

void clear_pixel(App& app) {
    if (!app.messages.close_help() && !app.open_box.close()) app.inspector.clear();
}

constexpr KeyPress key(int code) { return {code, 0, false, false}; }
constexpr KeyPress shift(int code) { return {code, 0, false, true}; }
constexpr KeyPress ctrl(int code) { return {code, 0, true, false}; }
/// A character, on whichever key it is.
constexpr KeyPress character(char32_t c) { return {0, c, false, false}; }

constexpr std::array table{
    Shortcut{character(U'?'), "?", "this list", false, toggle_help},
    Shortcut{key(GLFW_KEY_F1), "", "", false, toggle_help},
    Shortcut{key(GLFW_KEY_TAB), "Tab", "hide or show the panel", false, [](App& a) { a.panel.toggle(); }},
    Shortcut{character(U'l'), "L", "dark or light", false, switch_theme},
    Shortcut{key(GLFW_KEY_HOME), "Home, R", "the camera of the file", true, reset_camera},
    Shortcut{character(U'r'), "", "", true, reset_camera},
    Shortcut{key(GLFW_KEY_LEFT), "Arrows", "orbit", true,
             [](App& a) { move_camera(a.editor, {.turn_right = -key_turn}); }},
    Shortcut{key(GLFW_KEY_RIGHT), "", "", true,
             [](App& a) { move_camera(a.editor, {.turn_right = key_turn}); }},
    Shortcut{key(GLFW_KEY_UP), "", "", true, [](App& a) { move_camera(a.editor, {.turn_up = key_turn}); }},
    Shortcut{key(GLFW_KEY_DOWN), "", "", true, [](App& a) { move_camera(a.editor, {.turn_up = -key_turn}); }},
    Shortcut{shift(GLFW_KEY_LEFT), "Shift + arrows", "pan", true,
             [](App& a) { move_camera(a.editor, {.move_right = -key_move}); }},
    Shortcut{shift(GLFW_KEY_RIGHT), "", "", true,
             [](App& a) { move_camera(a.editor, {.move_right = key_move}); }},
    Shortcut{shift(GLFW_KEY_UP), "", "", true, [](App& a) { move_camera(a.editor, {.move_up = key_move}); }},
    Shortcut{shift(GLFW_KEY_DOWN), "", "", true,
             [](App& a) { move_camera(a.editor, {.move_up = -key_move}); }},
    Shortcut{character(U'+'), "+  \u2212", "zoom", true,
             [](App& a) { move_camera(a.editor, {.nearer = 1}); }},
    Shortcut{character(U'='), "", "", true, [](App& a) { move_camera(a.editor, {.nearer = 1}); }},
    Shortcut{character(U'-'), "", "", true, [](App& a) { move_camera(a.editor, {.nearer = -1}); }},
    Shortcut{character(U'['), "[  ]", "field of view", true, narrow_fov},
    Shortcut{character(U']'), "", "", true, widen_fov},
    Shortcut{character(U't'), "T", "turntable", true, toggle_turntable},
    Shortcut{key(GLFW_KEY_SPACE), "Space", "play or stop the animation", false,
             [](App& a) { a.playback.toggle(); }},
    Shortcut{character(U','), ",  .", "one frame back or on", false, [](App& a) { a.playback.step(-1); }},
    Shortcut{character(U'.'), "", "", false, [](App& a) { a.playback.step(1); }},
    Shortcut{character(U'k'), "K", "keep these settings as A, to compare with", true, keep},
    Shortcut{character(U'c'), "C", "compare: wipe, side by side, off", false, compare},
    Shortcut{character(U'v'), "V  Shift + V", "show the next or previous quantity", false,
             [](App& a) { show_next(a, 1); }},
    Shortcut{character(U'V'), "", "", false, [](App& a) { show_next(a, -1); }},
    Shortcut{character(U'f'), "F", "show the final picture", false,
             [](App& a) { a.state.show = Aov::final; }},
    Shortcut{character(U'g'), "G", "draw on the graphics card or on the CPU", false, switch_backend},
    Shortcut{ctrl(GLFW_KEY_Z), "Ctrl + Z, Y", "undo, redo", false, undo},
    Shortcut{ctrl(GLFW_KEY_Y), "", "", false, redo},
    Shortcut{{GLFW_KEY_Z, 0, true, true}, "", "", false, redo},
    Shortcut{key(GLFW_KEY_F5), "F5", "read the file again", false,
             [](App& a) { a.editor.session().reload(); }},
    Shortcut{ctrl(GLFW_KEY_O), "Ctrl + O", "open another file, or an example", false,
             [](App& a) { a.open_box.toggle(); }},
    Shortcut{ctrl(GLFW_KEY_S), "Ctrl + S", "save the scene", true, save_scene},
    Shortcut{ctrl(GLFW_KEY_P), "Ctrl + P", "save the picture", true, save_picture},
    Shortcut{ctrl(GLFW_KEY_C), "Ctrl + C", "copy the camera as TOML", true, copy_camera},
    Shortcut{key(GLFW_KEY_F12), "F12", "save what the window shows", false,
             [](App& a) { a.saver.save_window(); }},
    Shortcut{key(GLFW_KEY_ESCAPE), "Esc", "let go of the pixel; close this list or the list of files", false,
             clear_pixel},
    Shortcut{ctrl(GLFW_KEY_Q), "Ctrl + Q", "close the window", false, [](App& a) { a.window.close(); }},
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

void toggle_help(App& app) { app.messages.toggle_help(); }

void keep(App& app) {
    app.editor.keep();
    app.messages.show("Kept as A: change a setting, then compare with C");
}

void reset_camera(App& app) {
    app.editor.move([](CameraControl& c) { c.reset(); });
}

void copy_camera(App& app) {
    ImGui::SetClipboardText(camera_text(app.editor.session().camera().camera()).c_str());
    app.messages.show("The camera is copied");
}

void toggle_turntable(App& app) { app.state.turntable = !app.state.turntable; }
void save_picture(App& app) { app.saver.save_picture(); }
void save_scene(App& app) { app.saver.save_scene(); }
void undo(App& app) { app.editor.undo(); }
void redo(App& app) { app.editor.redo(); }

} // namespace glint::viewer
