#pragma once
// The window's parts, wired together, and its main loop. Each part has a header that says what it does; parts
// know each other by those interfaces only.

#include "actions.h"
#include "arguments.h"
#include "backend_switch.h"
#include "file_saver.h"
#include "frame_pacing.h"
#include "layout.h"
#include "messages.h"
#include "navigation.h"
#include "open_box.h"
#include "pixel_inspector.h"
#include "playback.h"
#include "presenter.h"
#include "scene_editor.h"
#include "session/times.h"
#include "side_panel.h"
#include "view_state.h"
#include "widgets.h"
#include "window.h"

#include <string>

namespace glint::viewer {

class App {
  public:
    /// Opens the window. Throws Error(device) without a display or without OpenGL 3.3.
    explicit App(const Arguments& arguments);

    /// Returns once the window is closed.
    void run();

    // The parts: actions work on them.
    const Arguments arguments;
    Window window;
    BackendSwitch backend;
    Ui ui;
    ViewState state;
    Messages messages;
    OpenBox open_box;
    SceneEditor editor;
    Presenter presenter;
    PixelInspector inspector;
    SidePanel panel;
    Playback playback;
    Navigation navigation;
    FileSaver saver;
    FramePacing pacing;
    Statistics statistics;

  private:
    void open(const std::string& file);
    /// Takes dropped files and keys; true if there were any.
    bool take_input();
    void perform(Action action);
    void apply_view_state();
    bool is_animating() const;

    // A frame, in the order of its calls.
    void draw_frame(double seconds);
    void update_theme(const WindowSize& size);
    void draw_panels();
    void draw_over_picture(const WindowSize& size);
    void move_camera(double seconds);
    void report_state();
    void draw_pictures();

    Layout layout_; ///< of the current frame
};

} // namespace glint::viewer
