#include "settings_panel.h"

#include "rows.h"
#include "scene_editor.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <imgui.h>

#include <algorithm>
#include <array>

namespace glint::viewer {
namespace {

void quantity(Ui& ui, Integrator integrator, ViewState& state) {
    std::vector<Aov> aovs;
    std::vector<std::string> words;
    for (int i = 0; i < aov_count; ++i) {
        const auto aov = static_cast<Aov>(i);
        if (!has_aov(integrator, aov)) continue;
        aovs.push_back(aov);
        words.emplace_back(aov_name(aov));
    }
    label_row(ui, "show", "the picture, one term of its light, or something else about each pixel (V)");
    const int chosen = choose(ui, "show", aov_name(state.show), words);
    if (chosen >= 0) state.show = aovs[static_cast<std::size_t>(chosen)];
    label_row(ui, "tone", "the sRGB curve, as in files, or plain numbers as the report's pictures");
    const int view = choose(ui, "view", state.view == View::raw ? "raw" : "sRGB", {"sRGB", "raw"});
    if (view >= 0) state.view = view == 1 ? View::raw : View::srgb;
}

void backend(Ui& ui, const std::string& why_cpu, ViewState& state) {
    label_row(ui, "drawn by", "the processor, or the graphics card (G)");
    const int chosen = choose(ui, "backend", state.gpu ? "GPU" : "CPU", {"CPU", "GPU"});
    if (chosen >= 0) state.gpu = chosen == 1;
    if (!state.gpu || why_cpu.empty()) return;
    quiet_text(ui, "The CPU draws: " + first_line(why_cpu));
    tooltip(why_cpu.c_str());
}

/// What changes the time alone.
void kernel(Ui& ui, ViewState& state) {
    label_row(ui, "kernel", "how rays go through meshes; each gives the same picture");
    const int chosen = choose(ui, "kernel", kernel_names[static_cast<std::size_t>(state.kernel)],
                              {kernel_names.begin(), kernel_names.end()});
    if (chosen >= 0) state.kernel = static_cast<Kernel>(chosen);
}

/// Rows of the settings that the window has no other means to change, where there is a choice.
template <class Settings>
void settings_rows(Ui& ui, const char* name, const Settings& settings, std::vector<Edit>& edits) {
    constexpr std::array<std::string_view, 3> without{"size", "seed", "filter"};
    const TableSpec& table = description_table(name);
    const FileKeys file;
    Rows rows(ui, edits, name, table, KeyOwner(settings), share_step, file);
    for (const KeySpec& key : table.keys)
        if (key.choices.size() != 1 && std::find(without.begin(), without.end(), key.key) == without.end())
            rows.row(key);
}

void comparison(Ui& ui, bool kept, ViewState& state, std::vector<Action>& actions) {
    heading(ui, "Compare");
    if (button(ui, "keep", kept ? "Keep again" : "Keep as A",
               "what is shown now becomes A; go on changing B (K)"))
        actions.push_back(keep);
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

void camera_rows(Ui& ui, SceneEditor& editor, ViewState& state, std::vector<Action>& actions) {
    heading(ui, "Camera");
    CameraDescription camera = editor.session().camera().camera();
    const NumberRange& usual = find_key(description_table("camera"), "fov", {})->typical;
    label_row(ui, "field of view", "full angle ([ and ])");
    bool touched = ImGui::SliderScalar("##fov", ImGuiDataType_Double, &camera.fov, &usual.low, &usual.high,
                                       "%.3g\u00b0");
    ui.map.item("camera.fov");
    const float step = static_cast<float>(std::max(editor.extent() / 500, 1e-6));
    // What is shown is also what dragging rounds to.
    const bool far = glm::length(camera.eye) > 64 * editor.extent();
    label_row(ui, "eye");
    touched |= ImGui::DragScalarN("##eye", ImGuiDataType_Double, &camera.eye.x, 3, step, nullptr, nullptr,
                                  far ? "%.10g" : "%.4g");
    ui.map.item("camera.eye");
    camera.fov = std::clamp(camera.fov, usual.low, usual.high);
    if (touched) editor.move([&](CameraControl& c) { c.set_camera(camera, c.target_distance()); });

    if (button(ui, "reset", "Reset", "the camera of the file (Home)")) actions.push_back(reset_camera);
    ImGui::SameLine(0, 4);
    if (button(ui, "copy_camera", "Copy as TOML", "the [camera] table, for a scene file (Ctrl + C)"))
        actions.push_back(copy_camera);
    ImGui::SameLine(0, 4);
    if (button(ui, "turntable", "Turntable", "turn around what is looked at (T)", state.turntable))
        actions.push_back(toggle_turntable);
}

void saving(Ui& ui, bool saved, std::vector<Action>& actions) {
    heading(ui, "Save");
    if (button(ui, "save_picture", "Picture", "finished, as PNG beside the scene (Ctrl + P)"))
        actions.push_back(save_picture);
    ImGui::SameLine(0, 4);
    if (button(ui, "save_scene", saved ? "Scene" : "Scene *",
               "writes what was changed into the file; all else keeps its characters (Ctrl + S)", !saved))
        actions.push_back(save_scene);
    ImGui::SameLine(0, 4);
    if (button(ui, "undo", "Undo", "Ctrl + Z")) actions.push_back(undo);
    ImGui::SameLine(0, 4);
    if (button(ui, "redo", "Redo", "Ctrl + Y")) actions.push_back(redo);
}

} // namespace

void settings_panel(Ui& ui, SceneEditor& editor, const std::string& why_cpu, ViewState& state,
                    std::vector<Edit>& edits, std::vector<Action>& actions) {
    const SceneDescription& scene = *editor.description();
    quantity(ui, scene.render.integrator, state);
    backend(ui, why_cpu, state);
    heading(ui, "Light model");
    if (scene.render.integrator == Integrator::whitted) settings_rows(ui, "whitted", scene.whitted, edits);
    if (traces_paths(scene.render.integrator)) settings_rows(ui, "path", scene.path, edits);
    if (scene.render.integrator == Integrator::ambient_occlusion)
        settings_rows(ui, "ambient_occlusion", scene.ambient_occlusion, edits);
    heading(ui, "Picture");
    settings_rows(ui, "render", scene.render, edits);
    kernel(ui, state);
    comparison(ui, editor.has_kept(), state, actions);
    camera_rows(ui, editor, state, actions);
    saving(ui, !editor.is_changed(), actions);
}

} // namespace glint::viewer
