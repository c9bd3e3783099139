// The main loop and the order of a frame.
#include "app.h"

#include "opengl.h"
#include "overlay.h"
#include "status_bar.h"

#include "glint/gpu.h"

#include <imgui.h>

#include <utility>

namespace glint::viewer {
namespace {

/// Frames are drawn for this long after a change, so that the map shows a change that has become a picture.
constexpr double map_seconds = 0.4;

std::string title_of(const std::string& file) {
    return file.empty() ? "glint" : file.substr(file.find_last_of('/') + 1) + " \u2013 glint";
}

bool selects_gpu(BackendChoice choice) {
    const GpuDevice device = gpu_device(GpuCurrentContext{});
    const bool has_card = device.fault.empty() && !device.software;
    return choice == BackendChoice::gpu || (choice == BackendChoice::automatic && has_card);
}

} // namespace

App::App(const Arguments& arguments)
    : arguments_(arguments),
      window_(arguments.window_width, arguments.window_height, title_of(arguments.file), arguments.debug),
      backend_(window_), ui_{{}, UiMap(arguments.map_file), {}}, bench_(arguments, [] { Window::wake(); }),
      presenter_(window_, bench_, state_, activity_, arguments.picture_width, arguments.picture_height),
      inspector_(bench_, activity_, messages_, presenter_), panel_(bench_, state_, activity_, inspector_),
      playback_(bench_, activity_, messages_), camera_(bench_.session(), activity_),
      saver_(window_, bench_, state_, activity_, messages_, presenter_), targets_{window_,    bench_,
                                                                                  state_,     activity_,
                                                                                  messages_,  panel_,
                                                                                  playback_,  camera_,
                                                                                  inspector_, saver_} {
    state_.theme = arguments.theme;
    state_.gpu = selects_gpu(arguments.backend);
    apply_view_state();
    if (!arguments.file.empty()) bench_.open(arguments.file);
}

void App::run() {
    while (!window_.is_closed()) {
        const double start = now();
        if (bench_.update()) pacing_.add_news();
        if (take_input()) pacing_.add_input();
        if (pacing_.is_due(start, is_animating(), activity_.last_move())) {
            draw_frame(pacing_.begin_frame(start));
            pacing_.end_frame();
            statistics_.frame_drawn(now() - start, activity_.last_move());
        }
        if (window_.wait(pacing_.wait_seconds(is_animating()))) pacing_.add_wake();
    }
    // Hidden at once, whatever takes time to end.
    window_.hide();
}

/// Does anything change without input?
bool App::is_animating() const {
    if (ui_.map.is_enabled() && activity_.seconds_since_change() < map_seconds) return true;
    return inspector_.is_waiting() || state_.turntable || playback_.is_playing() || bench_.status().busy ||
           messages_.is_showing() || saver_.is_waiting_for_picture() || navigation_.is_flying();
}

// ── Input ──────────────────────────────────────────────────────────────────────────────────────────────────

void App::open(const std::string& file) {
    inspector_.clear();
    bench_.open(file);
    window_.set_title(title_of(file));
}

bool App::take_input() {
    bool any = false;
    for (const std::string& file : window_.take_dropped()) {
        open(file);
        any = true;
    }
    for (const KeyPress& key : window_.take_keys()) {
        any = true;
        if (key.control) navigation_.ignore(key.code);
        const auto action = action_of(key);
        // Letters go to the text that is being typed, if any.
        if (action && (!ImGui::GetIO().WantTextInput || key.control)) perform(*action);
    }
    return any;
}

void App::perform(Action action) {
    viewer::perform(action, targets_);
    apply_view_state();
}

void App::apply_view_state() {
    const bool is_changed = apply(state_, bench_.session());
    if (backend_.select(state_.gpu, bench_.session()) || is_changed) activity_.scene_changed();
}

// ── A frame ────────────────────────────────────────────────────────────────────────────────────────────────

void App::draw_frame(double seconds) {
    const WindowSize size = window_.size();
    if (size.width == 0 || size.height == 0) return;
    update_theme(size);
    window_.begin_frame();
    ui_.map.begin();
    draw_widgets(size, seconds);
    report_state();
    ImGui::Render();
    draw_pictures();
    window_.end_frame();
    presenter_.was_drawn();
    saver_.finish_frame();
    ui_.map.end();
}

void App::update_theme(const WindowSize& size) {
    const float ratio = size.pixels_per_unit();
    const auto scale = static_cast<float>(arguments_.scale.value_or(window_.content_scale() / ratio));
    const Theme& theme = ui_.theme;
    const bool fits = theme.text != nullptr && theme.scale == scale && theme.pixels_per_unit == ratio;
    if (!fits || theme.choice != state_.theme) ui_.theme = apply_theme(state_.theme, scale, ratio);
}

void App::draw_widgets(const WindowSize& size, double seconds) {
    inspector_.update();
    layout_ = lay_out(size, ui_.theme.scale, panel_.is_open(), bench_.animation() != nullptr);
    draw_panels();
    if (const auto frame = bench_.frame()) backend_.check(*frame, messages_);
    playback_.advance(seconds);
    draw_over_picture(size);
    move_camera(seconds);
}

void App::draw_panels() {
    const SidePanel::Requests requests = panel_.draw(ui_, layout_.panel, backend_.why_cpu());
    if (requests.camera) camera_.set(*requests.camera);
    apply_view_state();
    for (const Action action : requests.actions) perform(action);

    Status status{nullptr, 1, state_.kernel, arguments_.threads};
    const auto frame = bench_.frame();
    if (bench_.description() != nullptr) {
        status.frame = frame.get();
        status.spp = bench_.description()->render.spp;
    }
    if (draw_status(ui_, layout_.status, status)) perform(Action::help);
    if (const Animation* animation = bench_.animation())
        draw_timeline(ui_, layout_.timeline, *animation, bench_.frame_shown(), playback_);
}

void App::draw_over_picture(const WindowSize& size) {
    if (bench_.description() != nullptr) {
        presenter_.lay_out(layout_.space, ui_.theme.scale);
        ui_.map.area("picture", presenter_.area(ViewSlot::main));
        presenter_.draw_comparison(ui_);
        inspector_.draw_rays(ui_);
    }
    messages_.draw(ui_, layout_.space, size, bench_);
}

void App::move_camera(double seconds) {
    const Movement movement = presenter_.is_dragging_wipe()
                                  ? Movement()
                                  : navigation_.read(window_, presenter_.mouse_areas(), seconds);
    const auto click = navigation_.take_click();
    if (bench_.description() == nullptr) return;
    if (!movement.is_none()) camera_.move(movement);
    if (state_.turntable) camera_.turn(seconds);
    if (!click) return;
    inspector_.explain(presenter_.pixel_at(*click));
    panel_.show(Tab::pixel);
    // Dear ImGui selects the tab in the next frame and draws it in the one after.
    pacing_.add_input();
}

void App::draw_pictures() {
    window_.clear(ui_.theme.surround);
    if (panel_.is_open()) window_.fill(layout_.panel, ui_.theme.panel);
    if (presenter_.draw()) statistics_.picture_shown(activity_.last_move());
}

// ── The map of --ui-map ────────────────────────────────────────────────────────────────────────────────────

void App::report_state() {
    UiMap& map = ui_.map;
    if (!map.is_enabled()) return;
    report_scene(map);
    panel_.report(map);
    playback_.report(map);
    inspector_.report(map);
    saver_.report(map);
    presenter_.report(map);
    map.state("show", aov_name(state_.show));
    map.state("backend", state_.gpu ? "gpu" : "cpu");
    map.state("kernel", kernel_names[static_cast<std::size_t>(state_.kernel)]);
    if (!window_.is_debugging_opengl()) return;
    const OpenGlObjects objects = opengl_objects();
    map.state("opengl.textures", static_cast<double>(objects.textures));
    map.state("opengl.buffers", static_cast<double>(objects.buffers));
    map.state("opengl.complaints", static_cast<double>(opengl_message_count()));
}

void App::report_scene(UiMap& map) const {
    const bool has_scene = bench_.description() != nullptr;
    map.state("status", bench_.status().busy ? "loading" : has_scene ? "ready" : "empty");
    const auto& problems = bench_.problems();
    map.state("errors", static_cast<double>(problems.size()));
    if (!problems.empty()) map.state("error", to_string(problems.front()));
    map.state("kept", bench_.has_kept());
    map.state("changed", bench_.is_changed());
}

} // namespace glint::viewer
