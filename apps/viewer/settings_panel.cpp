#include "settings_panel.h"

#include "key_rows.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <imgui.h>

#include <algorithm>
#include <array>

namespace glint::viewer {
namespace {

/// A combo of the window's own, beside those of Rows that edit the scene. Returns the word chosen now, or −1.
int choose(Ui& ui, const char* name, int current, const std::vector<std::string>& words) {
    int chosen = -1;
    ImGui::PushID(name);
    const bool open = ImGui::BeginCombo("##", words[static_cast<std::size_t>(current)].c_str(),
                                        ImGuiComboFlags_HeightLarge);
    ui.map.item(name);
    if (open) {
        for (std::size_t i = 0; i < words.size(); ++i) {
            if (ImGui::Selectable(words[i].c_str(), static_cast<int>(i) == current))
                chosen = static_cast<int>(i);
            ui.map.item(std::string(name) + ":" + words[i]);
        }
        ImGui::EndCombo();
    }
    ImGui::PopID();
    return chosen;
}

void quantity(Ui& ui, ViewState& state) {
    std::vector<std::string> words;
    for (int i = 0; i < aov_count; ++i) words.emplace_back(aov_name(static_cast<Aov>(i)));
    label_row(ui, "show", "the picture, one term of its light, or something else about each pixel (V)");
    const int chosen = choose(ui, "show", static_cast<int>(state.show), words);
    if (chosen >= 0) state.show = static_cast<Aov>(chosen);
    label_row(ui, "tone", "the sRGB curve, as in files, or plain numbers as the report's pictures");
    const int view = choose(ui, "view", state.view == View::raw ? 1 : 0, {"sRGB", "raw"});
    if (view >= 0) state.view = view == 1 ? View::raw : View::srgb;
}

void backend(Ui& ui, const std::string& why_cpu, ViewState& state) {
    label_row(ui, "drawn by", "the processor, or the graphics card (G)");
    const int chosen = choose(ui, "backend", state.gpu ? 1 : 0, {"CPU", "GPU"});
    if (chosen >= 0) state.gpu = chosen == 1;
    if (!state.gpu || why_cpu.empty()) return;
    quiet_text(ui, "The CPU draws: " + first_line(why_cpu));
    tooltip(why_cpu.c_str());
}

/// What shows in the time alone.
void work(Ui& ui, ViewState& state) {
    label_row(ui, "kernel", "how rays go through meshes; each gives the same picture");
    const int chosen =
        choose(ui, "kernel", static_cast<int>(state.kernel), {kernel_names.begin(), kernel_names.end()});
    if (chosen >= 0) state.kernel = static_cast<Kernel>(chosen);
}

/// Rows of the settings that the window has no other means to change.
template <class Settings>
void settings_rows(Ui& ui, const char* name, const Settings& settings, std::vector<Edit>& edits) {
    constexpr std::array<std::string_view, 4> without{"size", "seed", "integrator", "filter"};
    const TableSpec& table = description_table(name);
    const FileKeys file;
    KeyRows rows(ui, edits, name, table, KeyOwner(settings), share_step, file);
    for (const KeySpec& key : table.keys)
        if (std::find(without.begin(), without.end(), key.key) == without.end()) rows.row(key);
}

void comparison(Ui& ui, bool kept, ViewState& state, std::vector<Action>& actions) {
    heading(ui, "Compare");
    if (button(ui, "keep", kept ? "Keep again" : "Keep as A",
               "what is shown now becomes A; go on changing B (K)"))
        actions.push_back(Action::keep);
    if (!kept) {
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("then change a setting");
        return;
    }
    ImGui::SameLine();
    const auto mode = [&](const char* name, const char* label, CompareMode which) {
        if (button(ui, name, label, "", state.compare == which)) state.compare = which;
    };
    mode("compare_off", "Off", CompareMode::off);
    ImGui::SameLine(0, 2);
    mode("compare_wipe", "Wipe", CompareMode::wipe);
    ImGui::SameLine(0, 2);
    mode("compare_sides", "Side by side", CompareMode::side_by_side);
}

void camera_rows(Ui& ui, const CameraDescription& camera, ViewState& state, SettingsWishes& wishes) {
    heading(ui, "Camera");
    std::vector<Edit> unused;
    CameraDescription changed = camera;
    bool touched = false;
    const NumberRange& usual = find_key(description_table("camera"), "fov", {})->typical;
    const double least = usual.low;
    const double most = usual.high;
    label_row(ui, "field of view", "full angle ([ and ])");
    touched |= ImGui::SliderScalar("##fov", ImGuiDataType_Double, &changed.fov, &least, &most, "%.3g\u00b0");
    ui.map.item("camera.fov");
    const float step = static_cast<float>(std::max(glm::length(camera.eye) / 500, 1e-6));
    label_row(ui, "eye");
    touched |=
        ImGui::DragScalarN("##eye", ImGuiDataType_Double, &changed.eye.x, 3, step, nullptr, nullptr, "%.4g");
    ui.map.item("camera.eye");
    changed.fov = std::clamp(changed.fov, least, most);
    if (touched) wishes.camera = changed;

    if (button(ui, "reset", "Reset", "the camera of the file (Home)"))
        wishes.actions.push_back(Action::reset_camera);
    ImGui::SameLine(0, 4);
    if (button(ui, "copy_camera", "Copy as TOML", "the [camera] table, for a scene file (Ctrl + C)"))
        wishes.actions.push_back(Action::copy_camera);
    ImGui::SameLine(0, 4);
    if (button(ui, "turntable", "Turntable", "turn around what is looked at (T)", state.turntable))
        wishes.actions.push_back(Action::turntable);
}

void saving(Ui& ui, bool saved, std::vector<Action>& actions) {
    heading(ui, "Save");
    if (button(ui, "save_picture", "Picture", "finished, as PNG beside the scene (Ctrl + P)"))
        actions.push_back(Action::save_picture);
    ImGui::SameLine(0, 4);
    if (button(ui, "save_scene", saved ? "Scene" : "Scene *",
               "writes what was changed into the file; all else keeps its characters (Ctrl + S)", !saved))
        actions.push_back(Action::save_scene);
    ImGui::SameLine(0, 4);
    if (button(ui, "undo", "Undo", "Ctrl + Z")) actions.push_back(Action::undo);
    ImGui::SameLine(0, 4);
    if (button(ui, "redo", "Redo", "Ctrl + Y")) actions.push_back(Action::redo);
}

} // namespace

void settings_panel(Ui& ui, const SceneDescription& scene, const CameraDescription& camera, bool kept,
                    bool saved, const std::string& why_cpu, ViewState& state, SettingsWishes& wishes) {
    quantity(ui, state);
    backend(ui, why_cpu, state);
    heading(ui, "Light model");
    settings_rows(ui, "whitted", scene.whitted, wishes.edits);
    heading(ui, "Picture");
    settings_rows(ui, "render", scene.render, wishes.edits);
    work(ui, state);
    comparison(ui, kept, state, wishes.actions);
    camera_rows(ui, camera, state, wishes);
    saving(ui, saved, wishes.actions);
}

} // namespace glint::viewer
