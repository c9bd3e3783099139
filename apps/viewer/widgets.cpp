// Widgets of Dear ImGui, named in the map.
#include "widgets.h"

#include "glint/document.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace glint::viewer {
namespace {

/// Of a row's width.
constexpr float label_width = 0.36f;

ImVec4 color_of(const Tint& tint) { return {tint.red, tint.green, tint.blue, tint.alpha}; }

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
    if (lit) {
        const Tint& accent = ui.theme.accent;
        ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(accent.red, accent.green, accent.blue, 0.45f));
    }
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
        ImGui::GetWindowDrawList()->AddRectFilled(
            {right - 1.6f * height, top}, {right, top + height},
            ImGui::GetColorU32(ImVec4(to_screen(swatch->x), to_screen(swatch->y), to_screen(swatch->z), 1)),
            3 * ui.theme.scale);
    }
    return open;
}

void Rows::begin(const std::string& key, const char* label, const char* help) {
    ImGui::PushID((table_ + "." + key).c_str());
    label_row(ui_, label, help);
    ImGui::BeginDisabled(is_animated(key));
}

void Rows::finish(const std::string& key) {
    ImGui::EndDisabled();
    if (is_animated(key)) tooltip("animated: its value is that of the frame");
    ui_.map.item(table_ + "." + key);
    ImGui::PopID();
}

/// Is the key, a part of it, or a table that contains it animated?
bool Rows::is_animated(const std::string& key) const {
    const std::string path = table_ + "." + key;
    const auto is_part = [](const std::string& part, const std::string& whole) {
        return part.starts_with(whole) && (part.size() == whole.size() || part[whole.size()] == '.');
    };
    return std::any_of(ui_.animated.begin(), ui_.animated.end(), [&](const std::string& animated) {
        return is_part(animated, path) || is_part(path, animated);
    });
}

void Rows::number(const char* key, const char* label, double value, const Range& range, const char* help) {
    begin(key, label, help);
    const ImGuiSliderFlags flags = range.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
    if (ImGui::SliderScalar("##", ImGuiDataType_Double, &value, &range.min, &range.max, range.format, flags))
        set(key, scene_value(std::max(value, range.min)));
    finish(key);
}

void Rows::whole(const char* key, const char* label, int value, int min, int max, const char* help) {
    begin(key, label, help);
    if (ImGui::SliderInt("##", &value, min, max)) set(key, std::to_string(std::max(value, min)));
    finish(key);
}

void Rows::color(const char* key, const char* label, const Vec3& value, const char* help) {
    begin(key, label, help);
    std::array<float, 3> shown{to_screen(value.x), to_screen(value.y), to_screen(value.z)};
    if (ImGui::ColorEdit3("##", shown.data(),
                          ImGuiColorEditFlags_PickerHueWheel | ImGuiColorEditFlags_Uint8)) {
        // The picker has 8 bits per channel: four decimals are enough.
        const auto rounded = [](double x) { return std::round(x * 10000) / 10000; };
        set(key, scene_value(Vec3(rounded(to_linear(shown[0])), rounded(to_linear(shown[1])),
                                  rounded(to_linear(shown[2])))));
    }
    finish(key);
}

void Rows::place(const std::string& key, const char* label, const Vec3& value, double step,
                 const char* help) {
    Vec3 shown = value;
    if (drag(key, label, shown, step, help)) set(key, scene_value(shown));
}

bool Rows::drag(const std::string& key, const char* label, Vec3& value, double step, const char* help) {
    begin(key, label, help);
    const bool changed = ImGui::DragScalarN("##", ImGuiDataType_Double, &value.x, 3, static_cast<float>(step),
                                            nullptr, nullptr, "%.4g");
    finish(key);
    return changed;
}

void Rows::length(const std::string& key, const char* label, double value, double step, const char* help) {
    begin(key, label, help);
    if (ImGui::DragScalar("##", ImGuiDataType_Double, &value, static_cast<float>(step), nullptr, nullptr,
                          "%.4g"))
        set(key, scene_value(value));
    finish(key);
}

void Rows::check(const char* key, const char* label, bool value, const char* help) {
    begin(key, label, help);
    if (ImGui::Checkbox("##", &value)) set(key, value ? "true" : "false");
    finish(key);
}

void Rows::choice(const char* key, const char* label, const std::string& value,
                  const std::vector<std::string>& choices, const char* help) {
    begin(key, label, help);
    if (!ImGui::BeginCombo("##", value.c_str())) return finish(key);
    const std::string path = table_ + "." + key;
    ui_.map.item(path);
    for (const std::string& choice : choices) {
        if (ImGui::Selectable(choice.c_str(), choice == value)) set(key, scene_value(choice));
        ui_.map.item(path + ":" + choice);
    }
    ImGui::EndCombo();
    ImGui::EndDisabled();
    ImGui::PopID();
}

} // namespace glint::viewer
