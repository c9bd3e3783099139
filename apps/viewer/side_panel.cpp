// The tabs, and the edits made in them.
#include "side_panel.h"

#include "pixel_inspector.h"
#include "scene_editor.h"
#include "settings_panel.h"

#include <imgui.h>

namespace glint::viewer {
namespace {

/// By Tab: the names in the map, and the labels.
constexpr const char* tab_names[] = {"scene", "picture", "pixel"};
constexpr const char* tab_labels[] = {"Scene", "Picture", "Pixel"};

} // namespace

void SidePanel::show(Tab tab) {
    open_ = true;
    tab_ = tab;
    select_tab_ = true;
}

std::vector<Action> SidePanel::draw(Ui& ui, const Area& area, const std::string& why_cpu) {
    std::vector<Action> actions;
    if (!open_) return actions;
    begin_fixed_window("panel", area, false);
    ui.animated = editor_.animated();
    if (ImGui::BeginTabBar("tabs", ImGuiTabBarFlags_NoTooltip)) {
        for (const Tab tab : {Tab::scene, Tab::picture, Tab::pixel}) {
            if (!begin_tab(ui, tab)) continue;
            ImGui::BeginChild("content");
            if (editor_.description() == nullptr)
                quiet_text(ui, "No scene yet.");
            else
                draw_content(ui, tab, why_cpu, actions);
            ImGui::EndChild();
            ImGui::EndTabItem();
        }
        ImGui::EndTabBar();
    }
    select_tab_ = false;
    ImGui::End();
    apply_edits();
    return actions;
}

bool SidePanel::begin_tab(Ui& ui, Tab tab) {
    const auto index = static_cast<std::size_t>(tab);
    const bool selected = select_tab_ && tab_ == tab;
    const bool open =
        ImGui::BeginTabItem(tab_labels[index], nullptr, selected ? ImGuiTabItemFlags_SetSelected : 0);
    ui.map.item(std::string("tab:") + tab_names[index]);
    if (open && !select_tab_) tab_ = tab;
    return open;
}

void SidePanel::draw_content(Ui& ui, Tab tab, const std::string& why_cpu, std::vector<Action>& actions) {
    if (tab == Tab::scene) scene_panel(ui, editor_, inspector_.picked(), edits_);
    if (tab == Tab::picture) settings_panel(ui, editor_, why_cpu, state_, edits_, actions);
    if (tab == Tab::pixel) inspector_.draw_tab(ui);
}

/// Undo takes back all edits between pressing and releasing the mouse at once.
void SidePanel::apply_edits() {
    const bool is_down = ImGui::GetIO().MouseDown[0];
    if (!edits_.empty()) {
        editor_.edit(edits_, editing_ && is_down);
        editing_ = true;
    }
    if (!is_down) editing_ = false;
    edits_.clear();
}

void SidePanel::report(UiMap& map) const { map.state("tab", tab_names[static_cast<std::size_t>(tab_)]); }

} // namespace glint::viewer
