#pragma once
// The window's parts, wired together, and its main loop. Each part has a header that says what it does; parts
// know each other by those interfaces only.

#include "actions.h"
#include "activity.h"
#include "arguments.h"
#include "backend_switch.h"
#include "camera_driver.h"
#include "file_saver.h"
#include "frame_pacing.h"
#include "layout.h"
#include "messages.h"
#include "navigation.h"
#include "pixel_inspector.h"
#include "playback.h"
#include "presenter.h"
#include "side_panel.h"
#include "statistics.h"
#include "view_state.h"
#include "widgets.h"
#include "window.h"
#include "workbench.h"

#include <string>

namespace glint::viewer {

class App {
  public:
    /// Opens the window. Throws Error(device) without a display or without OpenGL 3.3.
    explicit App(const Arguments& arguments);

    /// Returns once the window is closed.
    void run();
    /// What --ui-stats prints.
    std::string statistics() const { return statistics_.text(); }

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
    void draw_widgets(const WindowSize& size, double seconds);
    void draw_panels();
    void draw_over_picture(const WindowSize& size);
    void move_camera(double seconds);
    void report_state();
    void report_scene(UiMap& map) const;
    void draw_pictures();

    Arguments arguments_;
    Window window_;
    BackendSwitch backend_;
    Ui ui_;
    ViewState state_;
    Activity activity_;
    Messages messages_;
    Workbench bench_;
    Presenter presenter_;
    PixelInspector inspector_;
    SidePanel panel_;
    Playback playback_;
    CameraDriver camera_;
    Navigation navigation_;
    FileSaver saver_;
    ActionTargets targets_;
    FramePacing pacing_;
    Statistics statistics_;
    Layout layout_; ///< of the current frame
};

} // namespace glint::viewer
