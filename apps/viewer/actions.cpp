// The table of actions: one row each, in the order of the enumeration.
#include "actions.h"

#include "activity.h"
#include "camera_driver.h"
#include "file_saver.h"
#include "messages.h"
#include "pixel_inspector.h"
#include "playback.h"
#include "side_panel.h"
#include "workbench.h"

#include "glint/document.h"

#include <imgui.h>

#include <array>

namespace glint::viewer {
namespace {

using Targets = ActionTargets;

/// Movement for one press of a key.
constexpr double key_turn = 0.06;
constexpr double key_move = 0.05;

struct Command {
    Action action;
    bool needs_scene;
    void (*run)(Targets&);
};

void keep(Targets& t) {
    t.bench.keep();
    t.messages.show("Kept as A: change a setting, then compare with C");
}

void compare(Targets& t) {
    if (!t.bench.has_kept())
        return t.messages.show("Nothing to compare with: keep these settings with K first");
    t.state.compare = static_cast<CompareMode>((static_cast<int>(t.state.compare) + 1) % 3);
}

/// `step` on in the list of quantities, around its end.
void next_quantity(Targets& t, int step) {
    t.state.show = static_cast<Aov>((static_cast<int>(t.state.show) + step + aov_count) % aov_count);
    t.messages.show(std::string("Showing: ") + aov_name(t.state.show));
}

void switch_backend(Targets& t) {
    t.state.gpu = !t.state.gpu;
    t.messages.show(t.state.gpu ? "Drawn by the GPU" : "Drawn by the CPU");
}

void switch_theme(Targets& t) {
    t.state.theme = t.state.theme == ThemeChoice::dark ? ThemeChoice::light : ThemeChoice::dark;
}

void undo(Targets& t) {
    t.bench.undo();
    t.activity.scene_changed();
}

void redo(Targets& t) {
    t.bench.redo();
    t.activity.scene_changed();
}

void copy_camera(Targets& t) {
    ImGui::SetClipboardText(camera_text(t.bench.session().camera().camera()).c_str());
    t.messages.show("The camera is copied");
}

void clear_pixel(Targets& t) {
    if (!t.messages.close_help()) t.inspector.clear();
}

constexpr std::array commands{
    Command{Action::help, false, [](Targets& t) { t.messages.toggle_help(); }},
    Command{Action::panel, false, [](Targets& t) { t.panel.toggle(); }},
    Command{Action::theme, false, switch_theme},
    Command{Action::reset_camera, true, [](Targets& t) { t.camera.reset(); }},
    Command{Action::turn_left, true, [](Targets& t) { t.camera.move({.turn_right = -key_turn}); }},
    Command{Action::turn_right, true, [](Targets& t) { t.camera.move({.turn_right = key_turn}); }},
    Command{Action::turn_up, true, [](Targets& t) { t.camera.move({.turn_up = key_turn}); }},
    Command{Action::turn_down, true, [](Targets& t) { t.camera.move({.turn_up = -key_turn}); }},
    Command{Action::move_left, true, [](Targets& t) { t.camera.move({.move_right = -key_move}); }},
    Command{Action::move_right, true, [](Targets& t) { t.camera.move({.move_right = key_move}); }},
    Command{Action::move_up, true, [](Targets& t) { t.camera.move({.move_up = key_move}); }},
    Command{Action::move_down, true, [](Targets& t) { t.camera.move({.move_up = -key_move}); }},
    Command{Action::nearer, true, [](Targets& t) { t.camera.move({.nearer = 1}); }},
    Command{Action::farther, true, [](Targets& t) { t.camera.move({.nearer = -1}); }},
    Command{Action::narrower, true, [](Targets& t) { t.camera.narrow(); }},
    Command{Action::wider, true, [](Targets& t) { t.camera.widen(); }},
    Command{Action::turntable, true, [](Targets& t) { t.state.turntable = !t.state.turntable; }},
    Command{Action::play, false, [](Targets& t) { t.playback.toggle(); }},
    Command{Action::next_frame, false, [](Targets& t) { t.playback.step(1); }},
    Command{Action::previous_frame, false, [](Targets& t) { t.playback.step(-1); }},
    Command{Action::keep, true, keep},
    Command{Action::compare, false, compare},
    Command{Action::next_quantity, false, [](Targets& t) { next_quantity(t, 1); }},
    Command{Action::previous_quantity, false, [](Targets& t) { next_quantity(t, -1); }},
    Command{Action::final_quantity, false, [](Targets& t) { t.state.show = Aov::final; }},
    Command{Action::backend, false, switch_backend},
    Command{Action::undo, false, undo},
    Command{Action::redo, false, redo},
    Command{Action::reload, false, [](Targets& t) { t.bench.session().reload(); }},
    Command{Action::save_scene, true, [](Targets& t) { t.saver.save_scene(); }},
    Command{Action::save_picture, true, [](Targets& t) { t.saver.save_picture(); }},
    Command{Action::save_window, false, [](Targets& t) { t.saver.save_window(); }},
    Command{Action::copy_camera, true, copy_camera},
    Command{Action::clear_pixel, false, clear_pixel},
    Command{Action::quit, false, [](Targets& t) { t.window.close(); }},
};

constexpr bool is_complete() {
    for (std::size_t i = 0; i < commands.size(); ++i)
        if (commands[i].action != static_cast<Action>(i)) return false;
    return commands.size() == action_count;
}
static_assert(is_complete(), "one row for each action, in their order");

} // namespace

void perform(Action action, ActionTargets& targets) {
    const Command& command = commands[static_cast<std::size_t>(action)];
    if (command.needs_scene && targets.bench.description() == nullptr) return;
    command.run(targets);
}

} // namespace glint::viewer
