#pragma once
// Saves the scene, its finished picture, and the window's content.

#include "ui_map.h"
#include "view_state.h"

#include <string>

namespace glint::viewer {

class Messages;
class Presenter;
class Window;
class SceneEditor;

class FileSaver {
  public:
    FileSaver(const Window& window, SceneEditor& editor, const ViewState& state, Messages& messages,
              const Presenter& presenter)
        : window_(window), editor_(editor), state_(state), messages_(messages), presenter_(presenter) {}

    void save_scene();
    /// Saves the picture as PNG beside the scene as soon as it is finished.
    void save_picture();
    /// Saves the window's content as PNG after the next frame.
    void save_window() { window_wanted_ = true; }
    /// Saves what is due. Call at the end of each frame.
    void finish_frame();
    bool is_waiting_for_picture() const { return picture_wanted_; }

    void report(UiMap& map) const;

  private:
    void write_finished_picture();
    void write_screenshot();

    const Window& window_;
    SceneEditor& editor_;
    const ViewState& state_;
    Messages& messages_;
    const Presenter& presenter_;
    bool picture_wanted_ = false;
    bool window_wanted_ = false;
    std::string last_file_; ///< written last
};

} // namespace glint::viewer
