// Widgets of Dear ImGui, named in the map.
#include "widgets.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace glint::viewer {
namespace {

/// Of a row's width.
constexpr float label_width = 0.36f;

} // namespace

void begin_fixed_window(const char* name, const Area& area, bool background) {
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus |
                     (background ? 0 : ImGuiWindowFlags_NoBackground));
}

float to_screen(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    return static_cast<float>(x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}

ImVec4 screen_color(const Vec3& light) {
    return {to_screen(light.x), to_screen(light.y), to_screen(light.z), 1};
}

double to_linear(float screen) {
    const double x = screen;
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

void tooltip(const char* help) {
    if (!*help || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 22);
    ImGui::TextUnformatted(help);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

void label_row(Ui& ui, const char* label, const char* help) {
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, color_of(ui.theme.quiet));
    ImGui::TextUnformatted(label);
    ImGui::PopStyleColor();
    tooltip(help);
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x * label_width);
    ImGui::SetNextItemWidth(-1);
}

void heading(const Ui& ui, const char* text) {
    ImGui::Dummy({0, 2 * ui.theme.scale});
    ImGui::PushFont(ui.theme.bold);
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
}

void quiet_text(const Ui& ui, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, color_of(ui.theme.quiet));
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

bool button(Ui& ui, const char* name, const char* label, const char* help, bool lit) {
    if (lit) ImGui::PushStyleColor(ImGuiCol_Button, color_of(ui.theme.accent, 0.45f));
    ImGui::PushID(name);
    const bool pressed = ImGui::Button(label);
    ImGui::PopID();
    if (lit) ImGui::PopStyleColor();
    tooltip(help);
    ui.map.item(std::string("button:") + name);
    return pressed;
}

bool section(Ui& ui, const std::string& name, const std::string& label, bool open_at_first,
             const Vec3* swatch) {
    const std::string title = label + "###" + name;
    ImGui::SetNextItemOpen(open_at_first, ImGuiCond_FirstUseEver);
    const bool open = ImGui::CollapsingHeader(title.c_str(), ImGuiTreeNodeFlags_AllowItemOverlap);
    ui.map.item("section:" + name);
    if (swatch != nullptr) {
        const ImVec2 end = ImGui::GetItemRectMax();
        const float height = ImGui::GetFontSize();
        const float top = (ImGui::GetItemRectMin().y + end.y - height) / 2;
        const float right = end.x - 8 * ui.theme.scale;
        ImGui::GetWindowDrawList()->AddRectFilled({right - 1.6f * height, top}, {right, top + height},
                                                  ImGui::GetColorU32(screen_color(*swatch)),
                                                  3 * ui.theme.scale);
    }
    return open;
}

int choose(Ui& ui, const std::string& name, const std::string& current,
           const std::vector<std::string>& choices) {
    int chosen = -1;
    ImGui::PushID(name.c_str());
    const bool open = ImGui::BeginCombo("##", current.c_str(), ImGuiComboFlags_HeightLarge);
    ui.map.item(name);
    for (std::size_t i = 0; open && i < choices.size(); ++i) {
        if (ImGui::Selectable(choices[i].c_str(), choices[i] == current)) chosen = static_cast<int>(i);
        ui.map.item(name + ":" + choices[i]);
    }
    if (open) ImGui::EndCombo();
    ImGui::PopID();
    return chosen;
}

} // namespace glint::viewer
