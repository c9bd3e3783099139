// The tabs, and the edits made in them.
#include "side_panel.h"

#include "activity.h"
#include "pixel_inspector.h"
#include "settings_panel.h"
#include "workbench.h"

#include <fmt/format.h>
#include <imgui.h>

namespace glint::viewer {
namespace {

constexpr const char* tab_names[] = {"scene", "picture", "pixel"};

const char* tab_name(Tab tab) { return tab_names[static_cast<std::size_t>(tab)]; }

/// Notes and warnings about the file.
void draw_remarks(const Ui& ui, const SessionScene& scene) {
    if (scene.warnings.empty() && scene.notes.empty()) return;
    heading(ui, "Remarks");
    for (const std::string& note : scene.notes) quiet_text(ui, note);
    for (const Diagnostic& warning : scene.warnings)
        quiet_text(ui, warning.location.line > 0
                           ? fmt::format("line {}: {}", warning.location.line, warning.message)
                           : warning.message);
}

} // namespace

void SidePanel::show(Tab tab) {
    open_ = true;
    tab_ = tab;
    select_tab_ = true;
}

SidePanel::Requests SidePanel::draw(Ui& ui, const Area& area, const std::string& why_cpu) {
    Requests requests;
    if (!open_) return requests;
    begin_fixed_window("panel", area, false);
    ui.animated = bench_.animated();
    if (ImGui::BeginTabBar("tabs", ImGuiTabBarFlags_NoTooltip)) {
        draw_tab(ui, Tab::scene, "Scene", why_cpu, requests);
        draw_tab(ui, Tab::picture, "Picture", why_cpu, requests);
        draw_tab(ui, Tab::pixel, "Pixel", why_cpu, requests);
        ImGui::EndTabBar();
    }
    select_tab_ = false;
    ImGui::End();
    apply_edits();
    return requests;
}

void SidePanel::draw_tab(Ui& ui, Tab tab, const char* label, const std::string& why_cpu, Requests& requests) {
    const bool selected = select_tab_ && tab_ == tab;
    const bool open = ImGui::BeginTabItem(label, nullptr, selected ? ImGuiTabItemFlags_SetSelected : 0);
    ui.map.item(std::string("tab:") + tab_name(tab));
    if (!open) return;
    if (!select_tab_) tab_ = tab;
    ImGui::BeginChild("content");
    if (bench_.description() == nullptr)
        quiet_text(ui, "No scene yet.");
    else
        draw_content(ui, tab, why_cpu, requests);
    ImGui::EndChild();
    ImGui::EndTabItem();
}

void SidePanel::draw_content(Ui& ui, Tab tab, const std::string& why_cpu, Requests& requests) {
    const SceneDescription& scene = *bench_.description();
    switch (tab) {
    case Tab::scene:
        scene_panel(ui, scene, bench_.extent(), bench_.keys(), inspector_.picked(), edits_);
        draw_remarks(ui, bench_.shown());
        break;
    case Tab::picture: {
        SettingsWishes wishes{edits_, requests.actions, {}};
        settings_panel(ui, scene, bench_.session().camera().camera(), bench_.has_kept(), !bench_.is_changed(),
                       why_cpu, state_, wishes);
        requests.camera = wishes.camera;
        break;
    }
    case Tab::pixel:
        inspector_.draw_tab(ui);
    }
}

/// Undo takes back all edits between pressing and releasing the mouse at once.
void SidePanel::apply_edits() {
    const bool is_down = ImGui::GetIO().MouseDown[0];
    if (!edits_.empty()) {
        bench_.edit(edits_, editing_ && is_down);
        editing_ = true;
        activity_.scene_changed();
    }
    if (!is_down) editing_ = false;
    edits_.clear();
}

void SidePanel::report(UiMap& map) const { map.state("tab", tab_name(tab_)); }

} // namespace glint::viewer
