// The main loop and the order of a frame.
#include "app.h"

#include "opengl.h"
#include "session/clock.h"
#include "status_bar.h"

#include "glint/gpu.h"

#include <imgui.h>

#include <algorithm>

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

App::App(const Arguments& given)
    : arguments(given), window(given.window_size, title_of(given.file), given.debug),
      backend(window), ui{{}, UiMap(given.map_file), {}}, editor(given, [] { Window::wake(); }),
      presenter(window, editor, state, given.picture_size), inspector(editor, messages, presenter),
      panel(editor, state, inspector), playback(editor, messages),
      saver(window, editor, state, messages, presenter) {
    state.theme = given.theme;
    state.gpu = selects_gpu(given.backend);
    apply_view_state();
    if (!given.file.empty()) editor.open(given.file);
}

void App::run() {
    while (!window.is_closed()) {
        const double start = now();
        const SceneEditor::News news = editor.update();
        if (news != SceneEditor::News::none) pacing.add_news();
        // A new box is laid out in one frame and drawn in the next.
        if (news == SceneEditor::News::file) pacing.add_input();
        if (take_input()) pacing.add_input();
        if (pacing.is_due(start, is_animating(), editor.last_move())) {
            draw_frame(pacing.begin_frame(start));
            pacing.end_frame();
            statistics.frame_drawn(now() - start, editor.last_move());
        }
        if (window.wait(pacing.wait_seconds(is_animating()))) pacing.add_wake();
    }
    // Hidden at once, whatever takes time to end.
    window.hide();
}

/// Does anything change without input?
bool App::is_animating() const {
    if (ui.map.is_enabled() && now() - editor.last_change() < map_seconds) return true;
    return inspector.is_waiting() || state.turntable || playback.is_playing() || editor.status().busy ||
           messages.is_showing() || saver.is_waiting_for_picture() || navigation.is_flying();
}

// ── Input ──────────────────────────────────────────────────────────────────────────────────────────────────

void App::open(const std::string& file) {
    inspector.clear();
    editor.open(file);
    window.set_title(title_of(file));
}

bool App::take_input() {
    const std::vector<std::string> files = window.take_dropped();
    for (const std::string& file : files) open(file);
    const std::vector<KeyPress> keys = window.take_keys();
    for (const KeyPress& key : keys) {
        if (key.control) navigation.ignore(key.code);
        // Letters go to the text that is being typed, if any.
        if (ImGui::GetIO().WantTextInput && !key.control) continue;
        const auto is_pressed = [&](const Shortcut& shortcut) { return shortcut.key == key; };
        const auto found = std::find_if(shortcuts().begin(), shortcuts().end(), is_pressed);
        if (found != shortcuts().end() && (!found->needs_scene || editor.description() != nullptr))
            perform(found->action);
    }
    return !files.empty() || !keys.empty();
}

void App::perform(Action action) {
    action(*this);
    apply_view_state();
}

/// Passes the view state on to the session.
void App::apply_view_state() {
    Session& session = editor.session();
    const bool is_changed = session.show() != state.show || session.kernel() != state.kernel;
    for (const ViewSlot slot : view_slots) session.set_show(state.show, slot);
    session.set_kernel(state.kernel);
    session.set_tone(state.view);
    if (backend.select(state.gpu, session) || is_changed) editor.note_change();
}

// ── A frame ────────────────────────────────────────────────────────────────────────────────────────────────

void App::draw_frame(double seconds) {
    const WindowSize size = window.size();
    if (size.width == 0 || size.height == 0) return;
    update_theme(size);
    window.begin_frame();
    ui.map.begin();
    inspector.update();
    layout_ = lay_out(size, ui.theme.scale, panel.is_open(), editor.animation() != nullptr);
    draw_panels();
    if (const auto frame = editor.frame()) backend.check(*frame, messages);
    playback.advance(seconds);
    draw_over_picture(size);
    move_camera(seconds);
    report_state();
    ImGui::Render();
    draw_pictures();
    window.end_frame();
    presenter.was_drawn();
    saver.finish_frame();
    ui.map.end();
}

void App::update_theme(const WindowSize& size) {
    const float ratio = size.pixels_per_unit();
    const auto scale = static_cast<float>(arguments.scale.value_or(window.content_scale() / ratio));
    const Theme& theme = ui.theme;
    const bool fits = theme.text != nullptr && theme.scale == scale && theme.pixels_per_unit == ratio;
    if (!fits || theme.choice != state.theme) ui.theme = apply_theme(state.theme, scale, ratio);
}

void App::draw_panels() {
    const std::vector<Action> actions = panel.draw(ui, layout_.panel, backend.why_cpu());
    apply_view_state();
    for (const Action action : actions) perform(action);
    if (draw_status(ui, layout_.status, editor, state.kernel, arguments.threads)) messages.toggle_help();
    if (editor.animation() != nullptr) draw_timeline(ui, layout_.timeline, editor, playback);
}

void App::draw_over_picture(const WindowSize& size) {
    if (editor.description() != nullptr) {
        presenter.lay_out(layout_.space, ui.theme.scale);
        ui.map.area("picture", presenter.area(ViewSlot::main));
        presenter.draw_comparison(ui);
        inspector.draw_rays(ui);
    }
    const bool is_empty =
        editor.description() == nullptr && editor.problems().empty() && !editor.status().busy;
    if (const auto file = open_box.draw(ui, layout_.space, is_empty)) open(*file);
    messages.draw(ui, layout_.space, size, editor);
}

void App::move_camera(double seconds) {
    const Movement movement =
        presenter.is_dragging_wipe() ? Movement() : navigation.read(window, presenter.mouse_areas(), seconds);
    const auto click = navigation.take_click();
    if (editor.description() == nullptr) return;
    if (movement != Movement()) viewer::move_camera(editor, movement);
    if (state.turntable) turn_camera(editor, seconds);
    if (!click) return;
    inspector.explain(presenter.pixel_at(*click));
    panel.show(Tab::pixel);
    // Dear ImGui selects the tab in the next frame and draws it in the one after.
    pacing.add_input();
}

void App::draw_pictures() {
    window.clear(ui.theme.surround);
    if (panel.is_open()) window.fill(layout_.panel, ui.theme.panel);
    if (presenter.draw()) statistics.picture_shown(editor.last_move());
}

// ── The map of --ui-map ────────────────────────────────────────────────────────────────────────────────────

void App::report_state() {
    UiMap& map = ui.map;
    if (!map.is_enabled()) return;
    const bool has_scene = editor.description() != nullptr;
    map.state("status", editor.status().busy ? "loading" : has_scene ? "ready" : "empty");
    const std::vector<Diagnostic>& problems = editor.problems();
    map.state("errors", static_cast<double>(problems.size()));
    if (!problems.empty()) map.state("error", to_string(problems.front()));
    map.state("kept", editor.has_kept());
    map.state("changed", editor.is_changed());
    map.state("show", aov_name(state.show));
    map.state("backend", state.gpu ? "gpu" : "cpu");
    map.state("kernel", kernel_names[static_cast<std::size_t>(state.kernel)]);
    panel.report(map);
    playback.report(map);
    inspector.report(map);
    saver.report(map);
    presenter.report(map);
    if (!window.is_debugging_opengl()) return;
    const OpenGlObjects objects = opengl_objects();
    map.state("opengl.textures", static_cast<double>(objects.textures));
    map.state("opengl.buffers", static_cast<double>(objects.buffers));
    map.state("opengl.messages", static_cast<double>(opengl_message_count()));
}

} // namespace glint::viewer
