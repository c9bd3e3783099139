// What keys and buttons do.
#include "app.h"

#include "glint/document.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace glint::viewer {
namespace {

/// How far one press of a key goes.
constexpr double key_turn = 0.06;
constexpr double key_move = 0.05;
constexpr double key_fov = 0.94;

/// "picture.png", or the first of "picture-2.png", "picture-3.png" … that is not there yet.
std::string free_name(const std::string& stem, const std::string& extension) {
    std::string name = stem + extension;
    for (int i = 2; std::filesystem::exists(name); ++i) name = fmt::format("{}-{}{}", stem, i, extension);
    return name;
}

/// The file's name without its extension, in its own folder.
std::string stem_of(const std::string& file) {
    return (std::filesystem::path(file).parent_path() / std::filesystem::path(file).stem()).string();
}

} // namespace

template <typename Work>
void App::guarded(const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        notice(error.diagnostics().front().message);
    }
}

void App::perform(Action action) {
    const bool scene = bench_.description() != nullptr;
    switch (action) {
    case Action::help:
        state_.help = !state_.help;
        break;
    case Action::panel:
        state_.panel = !state_.panel;
        break;
    case Action::theme:
        theme_ = theme_ == ThemeChoice::dark ? ThemeChoice::light : ThemeChoice::dark;
        break;
    case Action::turntable:
        state_.turntable = scene && !state_.turntable;
        break;
    case Action::play:
        state_.playing = bench_.animation() != nullptr && !state_.playing;
        // Where it stops is a frame that `glint` can be asked for.
        if (!state_.playing && bench_.animation() != nullptr) show_at(std::round(bench_.frame_shown()));
        break;
    case Action::next_frame:
    case Action::previous_frame:
        state_.playing = false;
        if (bench_.animation() != nullptr)
            show_at(std::round(bench_.frame_shown()) + (action == Action::next_frame ? 1 : -1));
        break;
    case Action::keep:
        if (scene) bench_.keep();
        if (scene) notice("Kept as A: change a setting, then compare with C");
        break;
    case Action::compare:
        if (!bench_.has_kept()) return notice("Nothing to compare with: keep these settings with K first");
        state_.compare = static_cast<CompareMode>((static_cast<int>(state_.compare) + 1) % 3);
        break;
    case Action::next_quantity:
    case Action::previous_quantity: {
        const int step = action == Action::next_quantity ? 1 : aspect_count - 1;
        state_.show = static_cast<Aspect>((static_cast<int>(state_.show) + step) % aspect_count);
        show(state_.show);
        notice(std::string("Showing: ") + aspect_name(state_.show));
        break;
    }
    case Action::final_quantity:
        state_.show = Aspect::final;
        show(state_.show);
        break;
    case Action::backend:
        set_backend(!state_.gpu);
        notice(state_.gpu ? "Drawn by the GPU" : "Drawn by the CPU");
        break;
    case Action::undo:
        bench_.undo();
        last_change_ = now();
        break;
    case Action::redo:
        bench_.redo();
        last_change_ = now();
        break;
    case Action::reload:
        bench_.session().reload();
        break;
    case Action::save_scene:
        if (scene)
            guarded([&] {
                saved_ = bench_.save();
                last_change_ = now();
                notice("Saved " + saved_);
            });
        break;
    case Action::save_picture:
        save_when_finished_ = scene;
        if (scene && !is_finished()) notice("The picture is saved when it is finished");
        break;
    case Action::save_window:
        screenshot_wanted_ = true;
        break;
    case Action::copy_camera:
        if (!scene) break;
        ImGui::SetClipboardText(camera_text(bench_.session().camera().camera()).c_str());
        notice("The camera is copied");
        break;
    case Action::let_go:
        if (!state_.help) let_go();
        state_.help = false;
        break;
    case Action::quit:
        window_.close();
        break;
    default:
        if (scene) perform_on_camera(action);
    }
}

void App::perform_on_camera(Action action) {
    Movement move;
    const double fov = bench_.session().camera().camera().fov;
    const auto change = [&](const std::function<void(CameraControl&)>& how) {
        bench_.session().move(how);
        last_change_ = last_move_ = now();
    };
    switch (action) {
    case Action::reset_camera:
        return change([](CameraControl& c) { c.reset(); });
    case Action::turn_left:
        move.turn_right = -key_turn;
        break;
    case Action::turn_right:
        move.turn_right = key_turn;
        break;
    case Action::turn_up:
        move.turn_up = key_turn;
        break;
    case Action::turn_down:
        move.turn_up = -key_turn;
        break;
    case Action::move_left:
        move.move_right = -key_move;
        break;
    case Action::move_right:
        move.move_right = key_move;
        break;
    case Action::move_up:
        move.move_up = key_move;
        break;
    case Action::move_down:
        move.move_up = -key_move;
        break;
    case Action::nearer:
        move.nearer = 1;
        break;
    case Action::farther:
        move.nearer = -1;
        break;
    case Action::narrower:
        return change([&](CameraControl& c) { c.set_fov(fov * key_fov); });
    case Action::wider:
        return change([&](CameraControl& c) { c.set_fov(fov / key_fov); });
    default:
        return;
    }
    App::move(move);
}

void App::play(double seconds) {
    const Animation* animation = bench_.animation();
    if (animation == nullptr) state_.playing = false;
    if (!state_.playing || seconds <= 0) return;
    const double length = std::max(1, animation->last - animation->first + 1);
    const double on = bench_.frame_shown() - animation->first + seconds * animation->fps;
    show_at(animation->first + std::fmod(on, length));
}

void App::show_at(double frame) {
    const Animation& animation = *bench_.animation();
    guarded([&] { bench_.show_at(std::clamp<double>(frame, animation.first, animation.last)); });
    last_change_ = now();
}

void App::show(Aspect aspect) {
    state_.show = aspect;
    if (bench_.session().show() == aspect) return;
    for (const ViewSlot slot : view_slots) bench_.session().set_show(aspect, slot);
    last_change_ = now();
}

void App::set_backend(bool gpu) {
    state_.gpu = gpu;
    if (on_gpu_ == gpu) return;
    on_gpu_ = gpu;
    bench_.session().set_backend(gpu ? gpu_maker() : BackendFactory());
    last_change_ = now();
}

/// What cannot be had is told where other faults of the graphics card are: by the renderer.
BackendFactory App::gpu_maker() {
    try {
        if (!side_) side_.emplace(window_);
    } catch (const Error& error) {
        return [error]() -> std::unique_ptr<Backend> { throw error; };
    }
    return [side = &*side_] { return gpu_backend(side->enter()); };
}

/// Says once why the CPU draws though the graphics card was asked to.
void App::tell_faults() {
    const auto frame = bench_.frame();
    if (!frame || frame->why_cpu == why_cpu_) return;
    why_cpu_ = frame->why_cpu;
    if (why_cpu_.empty()) return;
    notice("The CPU draws: " + first_line(why_cpu_));
    // A driver's log is longer than the window has room for.
    if (first_line(why_cpu_) != why_cpu_) std::cerr << "The CPU draws: " << why_cpu_ << "\n";
}

void App::use(Kernel kernel) {
    if (bench_.session().kernel() == kernel) return;
    bench_.session().set_kernel(kernel);
    last_change_ = now();
}

void App::save_picture() {
    save_when_finished_ = false;
    guarded([&] {
        const std::string file = free_name(stem_of(bench_.file()), ".png");
        write_picture(file, image_of(*bench_.frame()),
                      {.view = state_.view, .alpha = {}, .layers = {}, .metadata = {}});
        saved_ = file;
        notice("Saved " + file);
    });
}

void App::save_window() {
    screenshot_wanted_ = false;
    guarded([&] {
        const std::string stem = bench_.file().empty() ? "glint" : stem_of(bench_.file());
        const std::string file = free_name(stem + "-window", ".png");
        write_picture(file, window_.screenshot(),
                      {.view = View::raw, .alpha = {}, .layers = {}, .metadata = {}});
        saved_ = file;
    });
}

} // namespace glint::viewer
