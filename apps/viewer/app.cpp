#include "app.h"

#include "overlay.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>

namespace glint::viewer {
namespace {

/// Most screens show a frame each 1/60 of a second, and swapping waits for them; none of those that do not
/// wait is to be drawn more often than about that, however fast the mouse reports.
constexpr double frame_seconds = 1.0 / 70;
/// While the camera moves, a frame waits so long for the picture that shows it: drawing the one before once
/// more would take time from making it.
constexpr double patience_seconds = 1.0 / 30;
/// Dear ImGui answers input a frame or two later.
constexpr int frames_to_settle = 3;
constexpr double longest_sleep = 0.5;
constexpr double calm_seconds = 0.1;

std::string title_of(const std::string& file) {
    return file.empty() ? "glint" : file.substr(file.find_last_of('/') + 1) + " \u2013 glint";
}

} // namespace

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

App::App(const Arguments& arguments)
    : arguments_(arguments),
      window_(arguments.window_width, arguments.window_height, title_of(arguments.file), arguments.debug),
      ui_{{}, UiMap(arguments.map_file), {}}, bench_(arguments, [] { Window::wake(); }),
      theme_(arguments.theme) {
    const GpuDevice device = gpu_device(GpuCurrentContext{});
    const bool card = device.fault.empty() && !device.software;
    set_backend(arguments.backend == BackendChoice::gpu ||
                (arguments.backend == BackendChoice::automatic && card));
    if (!arguments.file.empty()) bench_.open(arguments.file);
}

void App::run() {
    int to_draw = frames_to_settle;
    bool news = false;
    double last_input = now();
    while (!window_.is_closed()) {
        const double start = now();
        news |= bench_.update();
        if (take_input()) to_draw = frames_to_settle;
        // A picture that only gets better need not be shown at every step: drawing takes time from making it.
        const bool calm =
            start - std::max(last_input, last_move_) > 0.5 && start - last_frame_ < calm_seconds;
        if (is_moving() || (news && !calm)) to_draw = std::max(to_draw, 1);
        const bool awaits_picture = !news && start - last_move_ < calm_seconds;
        const double due = last_frame_ + (awaits_picture ? patience_seconds : frame_seconds);
        if (to_draw > 0 && start >= due) {
            draw_frame();
            frame_times_.add(now() - start);
            if (start - last_move_ < 0.1) moving_times_.add(now() - start);
            --to_draw;
            news = false;
        }
        const bool more = to_draw > 0 || is_moving();
        const double rest = std::max(due, last_frame_ + frame_seconds) - now();
        if (window_.wait(more ? std::max(rest, 0.0) : news ? calm_seconds : longest_sleep)) {
            to_draw = frames_to_settle;
            last_input = now();
        }
    }
    // The window is gone at once, whatever still has to come to its end.
    window_.hide();
}

/// Does something move that no input drives?
bool App::is_moving() const {
    // Scripts wait for a change to have become a picture: is_finished().
    if (ui_.map.is_kept() && now() - last_change_ < 0.4) return true;
    // That something takes long is said a moment after it began.
    if (pixel_ && pixel_->busy_since > 0 && now() - pixel_->busy_since < 2 * silent_seconds) return true;
    return state_.turntable || state_.playing || bench_.status().busy || now() < notice_until_ ||
           save_when_finished_ || navigation_.is_flying();
}

bool App::take_input() {
    bool any = false;
    for (const std::string& file : window_.take_dropped()) {
        let_go();
        bench_.open(file);
        window_.set_title(title_of(file));
        any = true;
    }
    for (const KeyPress& key : window_.take_keys()) {
        any = true;
        if (key.control) navigation_.ignore(key.code);
        const auto action = action_of(key);
        // While a name or a number is typed, letters are its own.
        if (action && (!ImGui::GetIO().WantTextInput || key.control)) perform(*action);
    }
    return any;
}

void App::draw_frame() {
    const double start = now();
    const double seconds = last_frame_ > 0 ? std::min(start - last_frame_, 0.1) : 0;
    last_frame_ = start;
    const WindowSize size = window_.size();
    if (size.width == 0 || size.height == 0) return;
    dress(size);
    window_.begin_frame();
    ui_.map.begin();
    follow_explained();
    layout_ = lay_out(size, ui_.theme.scale, state_.panel, bench_.animation() != nullptr);
    draw_panel();
    draw_status();
    draw_timeline();
    tell_faults();
    play(seconds);
    draw_over_picture();
    move_camera(seconds);
    tell_map();
    ImGui::Render();

    window_.clear(ui_.theme.surround);
    if (state_.panel) window_.fill(layout_.panel, ui_.theme.panel);
    draw_pictures();
    window_.end_frame();
    canvas_.was_drawn();
    if (screenshot_wanted_) save_window();
    if (save_when_finished_ && is_finished()) save_picture();
    ui_.map.end();
}

void App::dress(const WindowSize& size) {
    const float ratio = size.pixels_a_unit();
    const auto scale = static_cast<float>(arguments_.scale.value_or(window_.content_scale() / ratio));
    const Theme& worn = ui_.theme;
    const bool fits = worn.text != nullptr && worn.scale == scale && worn.pixels_a_unit == ratio;
    if (!fits || worn.choice != theme_) ui_.theme = apply_theme(theme_, scale, ratio);
}

/// Only while the camera moves is there a rate of pictures to speak of.
void App::time_picture() {
    const double time = now();
    if (time - last_move_ < 0.1 && time - last_picture_ < 0.5) picture_times_.add(time - last_picture_);
    last_picture_ = time;
}

std::string App::statistics() const {
    std::string text = "window: " + frame_times_.summary() + "\n" + frame_times_.histogram();
    if (moving_times_.count() > 0)
        text +=
            "window while the camera moved: " + moving_times_.summary() + "\n" + moving_times_.histogram();
    if (picture_times_.count() > 0)
        text += "pictures while the camera moved: " + picture_times_.summary() + "\n" +
                picture_times_.histogram();
    return text;
}

bool App::is_finished() const {
    const auto frame = bench_.frame();
    // A change takes a moment to reach the pictures.
    return frame && frame->reached.finished && !bench_.status().busy && now() - last_change_ > 0.25 &&
           frame->width == bench_.session().width() && frame->height == bench_.session().height();
}

void App::draw_pictures() {
    for (const ViewSlot slot : view_slots) {
        const int place = static_cast<int>(slot);
        const auto frame = bench_.frame(slot);
        std::uint64_t& held = canvas_numbers_[slot];
        if (!frame) canvas_.drop(place);
        if (!frame || held == frame->number) continue;
        if (frame->on_device)
            canvas_.show(place, frame->on_device);
        else
            canvas_.upload(place, frame->image.width, frame->image.height, frame->screen);
        held = frame->number;
        if (place == 0) time_picture();
    }
    const WindowSize size = window_.size();
    if (!bench_.frame()) return;
    const bool both = is_comparing() && bench_.frame(ViewSlot::reference);
    if (both && state_.compare == CompareMode::wipe) {
        Area left = picture_;
        left.width *= state_.wipe;
        Area right = picture_;
        right.x += left.width;
        right.width -= left.width;
        canvas_.draw(1, picture_, left, state_.view, size);
        canvas_.draw(0, picture_, right, state_.view, size);
        return;
    }
    canvas_.draw(0, picture_, picture_, state_.view, size);
    if (both && state_.compare == CompareMode::side_by_side)
        canvas_.draw(1, reference_, reference_, state_.view, size);
}

void App::place_pictures() {
    const SceneDescription& scene = *bench_.description();
    const double width = arguments_.picture_width.value_or(scene.render.width);
    const double height = arguments_.picture_height.value_or(scene.render.height);
    const float ratio = window_.size().pixels_a_unit();
    Area space = layout_.space;
    if (state_.compare == CompareMode::side_by_side && is_comparing()) {
        const float gap = 4 * ui_.theme.scale;
        space.width = (space.width - gap) / 2;
        reference_ = fit(space, width, height, ratio);
        space.x += space.width + gap;
    }
    picture_ = fit(space, width, height, ratio);
    Session& session = bench_.session();
    const auto pixels = [ratio](float units) { return static_cast<int>(std::lround(units * ratio)); };
    const int pixel_width = arguments_.picture_width.value_or(pixels(picture_.width));
    const int pixel_height = arguments_.picture_height.value_or(pixels(picture_.height));
    if (pixel_width == session.width() && pixel_height == session.height()) return;
    session.resize(pixel_width, pixel_height);
    last_change_ = now();
}

void App::draw_over_picture() {
    if (bench_.description() != nullptr) {
        place_pictures();
        ui_.map.area("picture", picture_);
        draw_comparison();
        draw_explained();
    } else if (bench_.problems().empty() && !bench_.status().busy) {
        draw_hint(ui_, layout_.space, "Drop a scene (.toml) or a mesh (.ply) here.");
    }
    draw_errors(ui_, layout_.space, bench_.problems(),
                bench_.description() != nullptr ? "The picture shows the scene as it was before." : "");
    draw_progress();
    const double left = notice_until_ - now();
    if (left > 0) draw_notice(ui_, layout_.space, notice_, static_cast<float>(std::min(1.0, left * 2)));
    const WindowSize size = window_.size();
    if (state_.help)
        state_.help = draw_help(ui_, {0, 0, static_cast<float>(size.width), static_cast<float>(size.height)});
}

/// Small files are there before anybody could read what is said of them.
void App::draw_progress() {
    const LoadStatus& status = bench_.status();
    if (!status.busy) busy_since_ = 0;
    if (status.busy && busy_since_ == 0) busy_since_ = now();
    if (!status.busy || now() - busy_since_ < 0.3) return;
    if (draw_loading(ui_, layout_.space, status.progress.activity, status.progress.fraction))
        bench_.session().cancel_loading();
}

bool App::is_comparing() const { return state_.compare != CompareMode::off && bench_.has_kept(); }

void App::draw_comparison() {
    bench_.compare(is_comparing());
    if (!is_comparing()) return;
    if (state_.compare == CompareMode::side_by_side) {
        ui_.map.area("reference", reference_);
        draw_label(ui_, reference_, "A", false);
        draw_label(ui_, picture_, "B", false);
        return;
    }
    draw_label(ui_, picture_, "A", false);
    draw_label(ui_, picture_, "B", true);
    const float x = picture_.x + picture_.width * state_.wipe;
    const float grip = 9 * ui_.theme.scale;
    const float middle = picture_.y + picture_.height / 2;
    ui_.map.area("wipe", {x - grip, middle - grip, 2 * grip, 2 * grip});
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.AddLine({x, picture_.y}, {x, picture_.y + picture_.height}, IM_COL32(0, 0, 0, 120), 3);
    draw.AddLine({x, picture_.y}, {x, picture_.y + picture_.height}, IM_COL32(255, 255, 255, 220), 1);
    draw.AddCircleFilled({x, middle}, grip, IM_COL32(255, 255, 255, 220));
    draw.AddTriangleFilled({x - 0.7f * grip, middle}, {x - 0.2f * grip, middle - 0.4f * grip},
                           {x - 0.2f * grip, middle + 0.4f * grip}, IM_COL32(40, 40, 40, 255));
    draw.AddTriangleFilled({x + 0.7f * grip, middle}, {x + 0.2f * grip, middle + 0.4f * grip},
                           {x + 0.2f * grip, middle - 0.4f * grip}, IM_COL32(40, 40, 40, 255));

    const ImGuiIO& io = ImGui::GetIO();
    const bool near = std::abs(io.MousePos.x - x) < grip && picture_.contains(x - 1, io.MousePos.y);
    if (near && !io.WantCaptureMouse && io.MouseClicked[0]) state_.wiping = true;
    if (!io.MouseDown[0]) state_.wiping = false;
    if (state_.wiping) state_.wipe = std::clamp((io.MousePos.x - picture_.x) / picture_.width, 0.0f, 1.0f);
    if (near || state_.wiping) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
}

void App::move_camera(double seconds) {
    const std::array pictures{picture_, reference_};
    const bool both = is_comparing() && state_.compare == CompareMode::side_by_side;
    const Movement movement =
        state_.wiping ? Movement()
                      : navigation_.read(window_, std::span(pictures.data(), both ? 2 : 1), seconds);
    const auto click = navigation_.take_click();
    if (bench_.description() == nullptr) return;
    if (!movement.is_none()) move(movement);
    if (state_.turntable) {
        bench_.session().pick_orbit_target();
        bench_.session().move([&](CameraControl& c) { c.turn(seconds, state_.turns_a_minute); });
        last_change_ = last_move_ = now();
    }
    if (click) explain_at(*click);
}

/// What is seen follows the hand, so the eye goes the other way.
void App::move(const Movement& m) {
    constexpr double radians = 6.2831853 / turn_in_heights;
    if (m.turn_right != 0 || m.turn_up != 0) bench_.session().pick_orbit_target();
    bench_.session().move([&](CameraControl& c) {
        if (m.turn_right != 0 || m.turn_up != 0) c.orbit(-m.turn_right * radians, -m.turn_up * radians);
        if (m.move_right != 0 || m.move_up != 0) c.pan(-m.move_right, -m.move_up);
        if (m.nearer != 0) c.zoom(m.nearer);
        if (m.fly_right != 0 || m.fly_up != 0 || m.fly_ahead != 0)
            c.fly(m.fly_right * flight_speed, m.fly_up * flight_speed, m.fly_ahead * flight_speed);
    });
    last_change_ = last_move_ = now();
}

void App::notice(const std::string& text) {
    notice_ = text;
    notice_until_ = now() + 3;
}

void App::tell_map() {
    UiMap& map = ui_.map;
    if (!map.is_kept()) return;
    const bool shown = bench_.description() != nullptr;
    map.state("status", bench_.status().busy ? "loading" : shown ? "ready" : "empty");
    const auto& problems = bench_.problems();
    map.state("errors", static_cast<double>(problems.size()));
    if (!problems.empty()) map.state("error", to_string(problems.front()));
    constexpr const char* tabs[] = {"scene", "picture", "pixel"};
    map.state("tab", tabs[static_cast<std::size_t>(state_.tab)]);
    constexpr const char* modes[] = {"off", "wipe", "side by side"};
    map.state("compare", modes[static_cast<std::size_t>(state_.compare)]);
    map.state("wipe", static_cast<double>(state_.wipe));
    map.state("show", aspect_name(state_.show));
    map.state("backend", state_.gpu ? "gpu" : "cpu");
    if (window_.listens_to_opengl()) tell_opengl();
    map.state("kernel", kernel_names[static_cast<std::size_t>(state_.kernel)]);
    map.state("playing", state_.playing);
    if (bench_.animation() != nullptr) map.state("frame", bench_.frame_shown());
    map.state("kept", bench_.has_kept());
    map.state("changed", bench_.is_changed());
    map.state("rays_drawn", static_cast<double>(rays_drawn_));
    if (!saved_.empty()) map.state("saved", saved_);
    tell_pixel();
    if (shown) tell_picture();
}

void App::tell_picture() {
    UiMap& map = ui_.map;
    map.state("finished", is_finished());
    const Vec3 eye = bench_.session().camera().camera().eye;
    map.state("camera.eye", fmt::format("{:.6g} {:.6g} {:.6g}", eye.x, eye.y, eye.z));
    const auto frame = bench_.frame();
    if (!frame) return;
    map.state("samples", static_cast<double>(frame->reached.samples));
    map.state("drawn_by", frame->device.empty() ? "CPU" : frame->device);
    map.state("on_device", frame->on_device != nullptr);
    if (!frame->why_cpu.empty()) map.state("why_cpu", frame->why_cpu);
    // Only what is finished is worth bringing back from a graphics card.
    if (frame->on_device && !frame->reached.finished) return;
    if (hashed_number_ != frame->number) hash_ = picture_hash(image_of(*frame));
    hashed_number_ = frame->number;
    map.state("picture_hash", hash_);
}

void App::tell_opengl() {
    UiMap& map = ui_.map;
    const OpenGlObjects objects = opengl_objects();
    map.state("opengl.textures", static_cast<double>(objects.textures));
    map.state("opengl.buffers", static_cast<double>(objects.buffers));
    map.state("opengl.complaints", static_cast<double>(opengl_complaints()));
}

} // namespace glint::viewer
