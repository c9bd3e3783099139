#pragma once
// What the window says over the picture: notices, errors of the file, the progress of loading, the list of
// keys.

#include "ui_map.h"
#include "window.h"

#include "glint/error.h"

#include <string>

namespace glint::viewer {

struct Ui;
class SceneEditor;

class Messages {
  public:
    /// Shows a notice for a few seconds.
    void show(std::string text);
    /// Is a notice shown now?
    bool is_showing() const;
    /// Runs work and shows the first message of an Error that it throws.
    template <class Work>
    void guarded(const Work& work) {
        try {
            work();
        } catch (const Error& error) {
            show(error.diagnostics().front().message);
        }
    }

    void toggle_help() { help_ = !help_; }
    /// False if the list of keys was not open.
    bool close_help();

    /// Draws over the picture's space. The file's errors and progress come from the scene editor, on which
    /// Cancel acts.
    void draw(Ui& ui, const Area& space, const WindowSize& window, SceneEditor& editor);

  private:
    void draw_progress(Ui& ui, const Area& space, SceneEditor& editor);

    std::string notice_;
    double notice_until_ = 0;
    double loading_since_ = 0; ///< 0: nothing is loaded
    bool help_ = false;
};

} // namespace glint::viewer
