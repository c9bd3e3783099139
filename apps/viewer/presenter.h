#pragma once
// Shows the rendered pictures: where they are in the window, the comparison of two, and which pixel is where.

#include "canvas.h"
#include "navigation.h"
#include "view_state.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace glint::viewer {

struct Ui;
class SceneEditor;

/// A pixel of one of the two pictures.
struct ViewPixel {
    ViewSlot slot = ViewSlot::main;
    int x = 0;
    int y = 0;
};

class Presenter {
  public:
    /// `size`: width and height in pixels to render; none: as many as the window shows. Needs the window's
    /// context.
    Presenter(const Window& window, SceneEditor& editor, const ViewState& state,
              std::optional<std::pair<int, int>> size)
        : window_(window), editor_(editor), state_(state), size_(size) {}

    /// Fits the pictures into `space` and sets the number of pixels to render. Requires a scene.
    void lay_out(const Area& space, float scale);
    /// Draws labels and the wipe line over the pictures; the mouse drags the line.
    void draw_comparison(Ui& ui);
    /// Draws the pictures. True if that of the main view is a new one.
    bool draw();
    /// Call after the frame's commands have been submitted.
    void was_drawn() const { canvas_.was_drawn(); }

    /// Are two pictures compared?
    bool is_comparing() const;
    bool is_dragging_wipe() const { return dragging_wipe_; }
    /// Is the main view's picture finished, and of the scene as it is now?
    bool is_finished() const;

    /// Where the whole picture of a view is, and the part that the other one does not hide.
    const Area& area(ViewSlot slot) const;
    Area visible_part(ViewSlot slot) const;
    /// The areas in which the mouse moves the camera.
    std::span<const Area> mouse_areas() const;
    /// The pixel at a position in one of mouse_areas().
    ViewPixel pixel_at(const PicturePosition& position) const;

    void report(UiMap& map);

  private:
    bool is_side_by_side() const { return state_.compare == CompareMode::side_by_side && is_comparing(); }
    float wipe_x() const;
    bool update_textures();
    void draw_wipe_line(Ui& ui);
    void drag_wipe_line(float grip);
    void report_picture(UiMap& map);

    const Window& window_;
    SceneEditor& editor_;
    const ViewState& state_;
    std::optional<std::pair<int, int>> size_;
    Canvas canvas_;
    PerView<Area> areas_;                  ///< that of the reference: if side by side
    PerView<std::uint64_t> shown_numbers_; ///< RenderedFrame::number of the textures
    float wipe_ = 0.5f;                    ///< where the line is: 0 left, 1 right
    bool dragging_wipe_ = false;
    std::string hash_; ///< of frame `hashed_number_`, for the map
    std::uint64_t hashed_number_ = 0;
};

} // namespace glint::viewer
