#pragma once
// The window with everything in it.

#include "arguments.h"
#include "canvas.h"
#include "layout.h"
#include "navigation.h"
#include "opengl.h"
#include "pixel_panel.h"
#include "scene_panel.h"
#include "session/times.h"
#include "shortcuts.h"
#include "view_state.h"
#include "widgets.h"
#include "window.h"
#include "workbench.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glint::viewer {

/// Seconds of a clock that only goes forward.
double now();

/// The pixel that is explained, seen from where the camera was when it was clicked.
struct ExplainedPixel {
    ViewSlot slot = ViewSlot::main;
    int x = 0;
    int y = 0;
    std::shared_ptr<const PixelAnswer> answer; ///< none: it is still to come
    PixelChoice choice;
    std::vector<RayLine> lines;
    int lines_of_sample = -1;      ///< which sample `lines` show
    double since = 0;              ///< when the scene changed that is explained
    double busy_since = 0;         ///< 0: nothing is being explained
    std::optional<OtherPixel> gpu; ///< the pixel of frame `gpu_frame`
    std::uint64_t gpu_frame = 0;
    std::string command;      ///< the command line for `command_of`, as the scene was at that time
    double command_time = -1; ///< of the last change then
    std::shared_ptr<const PixelAnswer> command_of;
};

/// What takes no longer needs no word about it.
inline constexpr double silent_seconds = 0.2;
/// How far a drag has to go for a whole turn, in heights of the picture.
inline constexpr double turn_in_heights = 2.5;
/// Of flying, in distances to what is looked at a second.
inline constexpr double flight_speed = 0.6;

class App {
  public:
    /// Opens the window. Throws Error(device) where it cannot.
    explicit App(const Arguments& arguments);

    /// Until the window is closed.
    void run();
    /// How long frames of the window took, and how pictures followed each other while the camera moved.
    std::string statistics() const;

  private:
    bool take_input();
    void draw_frame();
    /// Puts on the theme that is wanted, at the scale of the screen that the window is on.
    void dress(const WindowSize& size);
    void place_pictures();
    void draw_pictures();
    void draw_over_picture();
    void draw_comparison();
    void draw_explained();
    void draw_panel();
    void draw_tab(Tab tab, const char* label, std::vector<Edit>& edits, std::vector<Action>& actions);
    void draw_status();
    void draw_timeline();
    void draw_progress();
    void tell_map();
    void tell_picture();
    void tell_opengl();
    void tell_faults();
    void time_picture();

    void move_camera(double seconds);
    void move(const Movement& movement);
    /// Goes on in the animation, in time.
    void play(double seconds);
    void show_at(double frame);
    void set_camera(const CameraDescription& camera);
    void perform(Action action);
    void perform_on_camera(Action action);
    void show(Aspect aspect);
    void set_backend(bool gpu);
    BackendFactory gpu_maker();
    void use(Kernel kernel);
    // The pixel that is explained (app_pixel.cpp).
    void explain_at(const PicturePlace& where);
    void explain(ViewSlot slot, int x, int y);
    void let_go();
    void follow_explained();
    void draw_pixel_tab();
    void tell_pixel();
    void mark_picked();
    ViewSlot slot_at(const PicturePlace& where) const;
    Area seen_part(ViewSlot slot) const;
    bool is_where_it_was() const;
    std::string compare_with_gpu();
    const std::string& command_line();
    void copy_command();

    void save_picture();
    void save_window();
    /// Says something for a few seconds.
    void notice(const std::string& text);
    /// Does it, and tells what was wrong instead of ending the program.
    template <typename Work>
    void guarded(const Work& work);

    bool is_moving() const;
    bool is_finished() const;
    bool is_comparing() const;

    Arguments arguments_;
    Window window_;
    std::optional<SideContext> side_; ///< where the graphics card makes pictures; before those who use it
    Canvas canvas_;
    Ui ui_;
    Workbench bench_;
    Navigation navigation_;
    ViewState state_;
    Layout layout_;
    Area picture_;   ///< where the picture is shown; B where two stand side by side
    Area reference_; ///< where A is shown
    std::optional<ExplainedPixel> pixel_;
    Picked picked_; ///< what the chosen ray of that pixel meets
    std::string notice_;
    double notice_until_ = 0;
    bool on_gpu_ = false; ///< what the session was told
    std::string why_cpu_; ///< what was said last about why the CPU draws
    std::string saved_;   ///< the file written last
    int rays_drawn_ = 0;
    double last_frame_ = 0;
    double last_change_ = 0; ///< of anything that the pictures show
    double last_move_ = 0;
    double last_picture_ = 0;
    double busy_since_ = 0;
    FrameTimes frame_times_;
    FrameTimes moving_times_; ///< of frames while the camera moved
    FrameTimes picture_times_;
    PerView<std::uint64_t> canvas_numbers_;
    std::string hash_; ///< of the picture, for the map
    std::uint64_t hashed_number_ = 0;
    ThemeChoice theme_; ///< to be put on between frames
    bool save_when_finished_ = false;
    bool screenshot_wanted_ = false;
    bool editing_ = false; ///< the mouse that is down has changed a value
};

} // namespace glint::viewer
