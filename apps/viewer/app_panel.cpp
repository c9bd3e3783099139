// The panel at the right and the line at the bottom.
#include "app.h"
#include "overlay.h"
#include "settings_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>
#include <thread>

namespace glint::viewer {
namespace {

constexpr ImGuiWindowFlags fixed_part = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoSavedSettings |
                                        ImGuiWindowFlags_NoBringToFrontOnFocus;

std::string rate(double a_second) {
    return a_second >= 1e6 ? fmt::format("{:.1f} Mrays/s", a_second / 1e6)
                           : fmt::format("{:.0f} krays/s", a_second / 1e3);
}

/// "800 × 600 · 3 of 16 samples · 12.3 Mrays/s".
std::string status_text(const RenderedFrame& frame, int spp) {
    const Refinement& reached = frame.reached;
    std::string text = fmt::format("{} \u00d7 {}", frame.width, frame.height);
    if (reached.finished)
        text += spp == 1 ? "  \u00b7  finished" : fmt::format("  \u00b7  {} samples, finished", spp);
    else if (reached.samples > 0)
        text += fmt::format("  \u00b7  {} of {} samples", reached.samples, spp);
    else if (reached.step > 1)
        text += fmt::format("  \u00b7  every {}th pixel", reached.step);
    if (frame.rays_per_second > 0) text += "  \u00b7  " + rate(frame.rays_per_second);
    if (!frame.why_cpu.empty()) text += "  \u00b7  " + first_line(frame.why_cpu);
    return text;
}

/// What is suspicious about the file, and what was chosen for the user.
void draw_remarks(const Ui& ui, const SessionScene& scene) {
    if (scene.warnings.empty() && scene.notes.empty()) return;
    heading(ui, "Remarks");
    for (const std::string& note : scene.notes) quiet_text(ui, note);
    for (const Diagnostic& warning : scene.warnings)
        quiet_text(ui, warning.location.line > 0
                           ? fmt::format("line {}: {}", warning.location.line, warning.message)
                           : warning.message);
}

/// As much of a text as there is room for.
std::string cut_to(std::string text, float width) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
    const auto is_inside = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; };
    while (!text.empty() && ImGui::CalcTextSize((text + "\u2026").c_str()).x > width) {
        while (text.size() > 1 && is_inside(text.back())) text.pop_back();
        text.pop_back();
    }
    return text + "\u2026";
}

/// "CPU: auto kernel, AVX2, 2 threads", or the graphics card.
std::string machine_text(const RenderedFrame* frame, Kernel kernel, int threads) {
    if (frame != nullptr && !frame->device.empty()) return "GPU: " + frame->device;
    const char* target = is_available(SimdTarget::avx512) ? "AVX-512"
                         : is_available(SimdTarget::avx2) ? "AVX2"
                         : is_available(SimdTarget::sse4) ? "SSE4"
                                                          : "plain";
    const unsigned count = threads > 0 ? static_cast<unsigned>(threads) : std::thread::hardware_concurrency();
    return fmt::format("CPU: {} kernel, {}, {} thread{}", kernel_names[static_cast<std::size_t>(kernel)],
                       target, count, count == 1 ? "" : "s");
}

} // namespace

void App::draw_panel() {
    if (!state_.panel) return;
    ImGui::SetNextWindowPos({layout_.panel.x, layout_.panel.y});
    ImGui::SetNextWindowSize({layout_.panel.width, layout_.panel.height});
    ImGui::Begin("panel", nullptr, fixed_part | ImGuiWindowFlags_NoBackground);
    ui_.animated = bench_.animated();
    std::vector<Edit> edits;
    std::vector<Action> actions;
    if (ImGui::BeginTabBar("tabs", ImGuiTabBarFlags_NoTooltip)) {
        draw_tab(Tab::scene, "Scene", edits, actions);
        draw_tab(Tab::picture, "Picture", edits, actions);
        draw_tab(Tab::pixel, "Pixel", edits, actions);
        ImGui::EndTabBar();
    }
    state_.turn_to_tab = false;
    ImGui::End();
    // What one press of the mouse does is undone as one.
    if (!edits.empty()) {
        bench_.edit(edits, editing_ && ImGui::GetIO().MouseDown[0]);
        editing_ = true;
        last_change_ = now();
    }
    if (!ImGui::GetIO().MouseDown[0]) editing_ = false;
    for (const Action action : actions) perform(action);
}

void App::draw_tab(Tab tab, const char* label, std::vector<Edit>& edits, std::vector<Action>& actions) {
    const bool wanted = state_.turn_to_tab && state_.tab == tab;
    const bool open = ImGui::BeginTabItem(label, nullptr, wanted ? ImGuiTabItemFlags_SetSelected : 0);
    constexpr const char* names[] = {"tab:scene", "tab:picture", "tab:pixel"};
    ui_.map.item(names[static_cast<std::size_t>(tab)]);
    if (!open) return;
    if (!state_.turn_to_tab) state_.tab = tab;
    ImGui::BeginChild("content");
    const SceneDescription* scene = bench_.description();
    if (scene == nullptr) {
        quiet_text(ui_, "No scene yet.");
    } else if (tab == Tab::scene) {
        scene_panel(ui_, *scene, bench_.extent(), bench_.keys(), picked_, edits);
        draw_remarks(ui_, bench_.shown());
    } else if (tab == Tab::picture) {
        SettingsWishes wishes{edits, actions, {}};
        settings_panel(ui_, *scene, bench_.session().camera().camera(), bench_.has_kept(),
                       !bench_.is_changed(), why_cpu_, state_, wishes);
        if (wishes.camera) set_camera(*wishes.camera);
        show(state_.show);
        set_backend(state_.gpu);
        bench_.session().set_tone(state_.view);
        use(state_.kernel);
    } else {
        draw_pixel_tab();
    }
    ImGui::EndChild();
    ImGui::EndTabItem();
}

void App::set_camera(const CameraDescription& camera) {
    bench_.session().move([&](CameraControl& c) { c.set_camera(camera, c.target_distance()); });
    last_change_ = last_move_ = now();
}

void App::draw_timeline() {
    const Animation* animation = bench_.animation();
    if (animation == nullptr) return;
    ImGui::SetNextWindowPos({layout_.timeline.x, layout_.timeline.y});
    ImGui::SetNextWindowSize({layout_.timeline.width, layout_.timeline.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(14 * ui_.theme.scale, 9 * ui_.theme.scale));
    ImGui::Begin("timeline", nullptr, fixed_part);
    if (button(ui_, "play", state_.playing ? "Stop" : "Play", "Space", state_.playing)) perform(Action::play);
    ImGui::SameLine();
    double frame = bench_.frame_shown();
    const double first = animation->first;
    const double last = animation->last;
    const std::string form = fmt::format("frame %.0f of {} to {}, {:g} a second", animation->first,
                                         animation->last, animation->fps);
    ImGui::SetNextItemWidth(-1);
    if (ImGui::SliderScalar("##frame", ImGuiDataType_Double, &frame, &first, &last, form.c_str())) {
        state_.playing = false;
        show_at(std::round(frame));
    }
    ui_.map.item("timeline");
    ImGui::End();
    ImGui::PopStyleVar();
}

void App::draw_status() {
    const float padding = 6 * ui_.theme.scale;
    ImGui::SetNextWindowPos({layout_.status.x, layout_.status.y});
    ImGui::SetNextWindowSize({layout_.status.width, layout_.status.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(14 * ui_.theme.scale, padding));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
    ImGui::Begin("status", nullptr, fixed_part);
    const auto frame = bench_.frame();
    const char* hint = "?  keys";
    const std::string machine = machine_text(frame.get(), state_.kernel, arguments_.threads);
    const float gap = 24 * ui_.theme.scale;
    const float hint_at = ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(hint).x;
    const float machine_at = hint_at - gap - ImGui::CalcTextSize(machine.c_str()).x;
    if (frame && bench_.description() != nullptr) {
        const float height = ImGui::GetFontSize();
        ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 0.3f * height);
        ImGui::ProgressBar(static_cast<float>(frame->reached.fraction), {6 * height, 0.4f * height}, "");
        ImGui::SameLine();
        ImGui::SetCursorPosY(padding);
        const std::string text = status_text(*frame, bench_.description()->render.spp);
        ImGui::TextUnformatted(cut_to(text, machine_at - gap - ImGui::GetCursorPosX()).c_str());
        ui_.map.item("status");
    }
    ImGui::SameLine(machine_at);
    ImGui::SetCursorPosY(padding);
    ImGui::TextDisabled("%s", machine.c_str());
    ImGui::SameLine(hint_at);
    ImGui::SetCursorPosY(padding);
    ImGui::TextDisabled("%s", hint);
    if (ImGui::IsItemClicked()) state_.help = !state_.help;
    ui_.map.item("button:help");
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
}

} // namespace glint::viewer
