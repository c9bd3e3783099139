#pragma once
// The explained pixel: asks the session, draws the Pixel panel and the rays over the picture.

#include "pixel_panel.h"
#include "presenter.h"
#include "scene_panel.h"
#include "session/explainer.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glint::viewer {

class Messages;

class PixelInspector {
  public:
    PixelInspector(SceneEditor& editor, Messages& messages, const Presenter& presenter)
        : editor_(editor), messages_(messages), presenter_(presenter) {}

    /// Explains a pixel as it is seen now, instead of the one before.
    void explain(const ViewPixel& pixel);
    void clear();
    /// Takes over what the session has explained since the last frame.
    void update();
    /// Is a message about a slow explanation about to appear?
    bool is_waiting() const;

    /// Draws the content of the Pixel panel.
    void draw_tab(Ui& ui);
    /// Draws the rays over the picture.
    void draw_rays(Ui& ui);
    /// What the selected ray hits, for the Scene panel to mark.
    Picked& picked() { return picked_; }

    void report(UiMap& map) const;

  private:
    /// The pixel, seen from where the camera was when it was clicked.
    struct Inspected {
        ViewPixel pixel;
        std::shared_ptr<const PixelAnswer> answer; ///< null: not explained yet
        double answer_time = 0;                    ///< of the last answer that replaced another
        double busy_since = 0;                     ///< 0: nothing is being explained
        PixelChoice choice;
        std::vector<RayLine> lines;
        int lines_sample = -1; ///< the sample that `lines` show
        std::string command;   ///< the command line for `answer`, as of `command_time`
        double command_time = -1;
        std::optional<OtherPixel> gpu; ///< the same pixel in the GPU's frame `gpu_frame`
        std::uint64_t gpu_frame = 0;
    };

    void take(std::shared_ptr<const PixelAnswer> answer);
    bool is_slow() const;
    bool is_seen_from_here() const;
    void update_picked();
    void update_lines();
    std::string device_remark();
    const std::string& command_line();
    void copy_command();

    SceneEditor& editor_;
    Messages& messages_;
    const Presenter& presenter_;
    std::optional<Inspected> inspected_;
    Picked picked_;
    int visible_lines_ = 0; ///< lines drawn in the last frame
};

} // namespace glint::viewer
