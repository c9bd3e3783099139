// Drawing with Dear ImGui's background list and small boxes.
#include "overlay.h"

#include "shortcuts.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace glint::viewer {
namespace {

constexpr ImGuiWindowFlags fixed_box = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav;
constexpr ImGuiWindowFlags passive_box = fixed_box | ImGuiWindowFlags_NoInputs |
                                         ImGuiWindowFlags_AlwaysAutoResize |
                                         ImGuiWindowFlags_NoFocusOnAppearing;

ImVec4 opaque_color_of(const Tint& tint) { return {tint.red, tint.green, tint.blue, 1}; }

/// Centres the next box in a space.
void center_next_box(const Area& space) {
    ImGui::SetNextWindowPos({space.x + space.width / 2, space.y + space.height / 2}, ImGuiCond_Always,
                            {0.5f, 0.5f});
}

void add_arrow(ImDrawList& draw, const ImVec2& from, const ImVec2& to, ImU32 color, float size) {
    const float dx = to.x - from.x;
    const float dy = to.y - from.y;
    const float length = std::hypot(dx, dy);
    if (length < 2 * size) return;
    const ImVec2 along(dx / length * size, dy / length * size);
    draw.AddTriangleFilled({to.x + along.x * 0.4f, to.y + along.y * 0.4f},
                           {to.x - along.x - along.y * 0.6f, to.y - along.y + along.x * 0.6f},
                           {to.x - along.x + along.y * 0.6f, to.y - along.y - along.x * 0.6f}, color);
}

/// Open lines are dashed.
void add_segment(ImDrawList& draw, const ImVec2& from, const ImVec2& to, ImU32 color, float thickness,
                 bool open) {
    if (!open) {
        draw.AddLine(from, to, color, thickness);
        return;
    }
    const float length = std::hypot(to.x - from.x, to.y - from.y);
    const int dashes = std::clamp(static_cast<int>(length / 12), 1, 200);
    for (int i = 0; i < dashes; ++i) {
        const auto at = [&](float t) {
            return ImVec2(from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t);
        };
        const float first = static_cast<float>(i) / static_cast<float>(dashes);
        draw.AddLine(at(first), at(first + 0.6f / static_cast<float>(dashes)), color, thickness);
    }
}

bool begin_key_table(const char* name) {
    const float letter = ImGui::GetFontSize();
    if (!ImGui::BeginTable(name, 2, ImGuiTableFlags_SizingFixedFit, {31 * letter, 0})) return false;
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, 11.5f * letter);
    return true;
}

void key_row(const char* keys, const char* help) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(keys);
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", help);
}

/// "scene.toml:3:7  message", the excerpt, and the hint.
void draw_error(Ui& ui, const Diagnostic& error) {
    const Location& location = error.location;
    std::string position = location.file.substr(location.file.find_last_of('/') + 1);
    if (location.line > 0) position += fmt::format(":{}:{}", location.line, location.column);
    ImGui::PushStyleColor(ImGuiCol_Text, opaque_color_of(ui.theme.error));
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted((position.empty() ? error.message : position + "  " + error.message).c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    if (!error.excerpt.empty()) {
        ImGui::PushFont(ui.theme.fixed);
        ImGui::TextUnformatted(("    " + error.excerpt).c_str());
        ImGui::PopFont();
    }
    if (!error.hint.empty()) quiet_text(ui, error.hint);
}

} // namespace

int draw_rays(const Area& picture, const Projection& projection, int width, int height,
              const std::vector<RayLine>& lines, const RayId& selected) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.PushClipRect({picture.x, picture.y}, {picture.x + picture.width, picture.y + picture.height}, true);
    const auto screen = [&](const PixelPoint& p) {
        return ImVec2(picture.x + static_cast<float>(p.x / width) * picture.width,
                      picture.y + static_cast<float>(p.y / height) * picture.height);
    };
    int visible = 0;
    for (const RayLine& line : lines) {
        const auto ends = projection.line(line.from, line.to);
        if (!ends) continue;
        const ImVec2 from = screen(ends->first);
        const ImVec2 to = screen(ends->second);
        // From its own camera the primary ray is a point.
        if (std::hypot(to.x - from.x, to.y - from.y) < 1.5f) continue;
        const float thickness = line.id == selected ? 3.5f : 1.75f;
        // A dark edge keeps lines visible on a bright picture.
        add_segment(draw, from, to, IM_COL32(0, 0, 0, 110), thickness + 2, line.open);
        const ImU32 color = ImGui::GetColorU32(opaque_color_of(line_tint(line.kind)));
        add_segment(draw, from, to, color, thickness, line.open);
        add_arrow(draw, from, to, color, 4 + thickness);
        ++visible;
    }
    draw.PopClipRect();
    return visible;
}

void draw_mark(const Ui& ui, const Area& picture, double u, double v) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const ImVec2 at(picture.x + static_cast<float>(u) * picture.width,
                    picture.y + static_cast<float>(v) * picture.height);
    draw.PushClipRect({picture.x, picture.y}, {picture.x + picture.width, picture.y + picture.height}, true);
    const float radius = 7 * ui.theme.scale;
    draw.AddCircle(at, radius + 1, IM_COL32(0, 0, 0, 160), 24, 4);
    draw.AddCircle(at, radius + 1, ImGui::GetColorU32(opaque_color_of(ui.theme.accent)), 24, 2);
    draw.PopClipRect();
}

void draw_errors(Ui& ui, const Area& space, const std::vector<Diagnostic>& errors,
                 const std::string& footer) {
    if (errors.empty()) return;
    ImGui::SetNextWindowPos({space.x, space.y});
    ImGui::SetNextWindowSize({space.width, 0});
    ImGui::SetNextWindowBgAlpha(0.97f);
    ImGui::Begin("errors", nullptr,
                 (fixed_box & ~ImGuiWindowFlags_NoScrollbar) | ImGuiWindowFlags_NoFocusOnAppearing);
    constexpr std::size_t max_errors = 4;
    for (std::size_t i = 0; i < std::min(errors.size(), max_errors); ++i) draw_error(ui, errors[i]);
    if (errors.size() > max_errors) quiet_text(ui, fmt::format("and {} more", errors.size() - max_errors));
    if (!footer.empty()) quiet_text(ui, footer);
    const ImVec2 corner = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    ImGui::GetWindowDrawList()->AddRectFilled(corner, {corner.x + 4 * ui.theme.scale, corner.y + size.y},
                                              ImGui::GetColorU32(opaque_color_of(ui.theme.error)));
    ui.map.area("errors", {corner.x, corner.y, size.x, size.y});
    ImGui::End();
}

bool draw_loading(Ui& ui, const Area& space, const std::string& activity, double fraction) {
    center_next_box(space);
    ImGui::SetNextWindowBgAlpha(0.94f);
    ImGui::Begin("loading", nullptr,
                 fixed_box | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::TextUnformatted(activity.c_str());
    const float width = 18 * ImGui::GetFontSize();
    // Without a known fraction the bar swings.
    const float shown = fraction >= 0 ? static_cast<float>(fraction)
                                      : 0.5f + 0.5f * static_cast<float>(std::sin(ImGui::GetTime() * 3));
    ImGui::ProgressBar(shown, {width, 0.4f * ImGui::GetFontSize()}, "");
    const bool cancelled = button(ui, "cancel", "Cancel");
    ImGui::End();
    return cancelled;
}

void draw_hint(Ui& ui, const Area& space, const std::string& text) {
    center_next_box(space);
    ImGui::Begin("hint", nullptr, passive_box | ImGuiWindowFlags_NoBackground);
    quiet_text(ui, text);
    ImGui::End();
}

void draw_label(Ui& ui, const Area& area, const std::string& text, bool at_right) {
    const float gap = 10 * ui.theme.scale;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float x = at_right ? area.x + area.width - gap - size.x - gap : area.x + gap;
    const float y = area.y + gap;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.AddRectFilled({x, y}, {x + size.x + gap, y + size.y + gap / 2}, IM_COL32(0, 0, 0, 150),
                       4 * ui.theme.scale);
    draw.AddText({x + gap / 2, y + gap / 4}, IM_COL32(255, 255, 255, 235), text.c_str());
}

void draw_notice(Ui& ui, const Area& space, const std::string& text, float opacity) {
    ImGui::SetNextWindowPos({space.x + space.width / 2, space.y + space.height - 18 * ui.theme.scale},
                            ImGuiCond_Always, {0.5f, 1});
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, opacity);
    ImGui::Begin("notice", nullptr, passive_box);
    ImGui::TextUnformatted(text.c_str());
    ImGui::End();
    ImGui::PopStyleVar();
}

bool draw_help(Ui& ui, const Area& window) {
    center_next_box(window);
    bool open = true;
    ImGui::SetNextWindowSizeConstraints({0, 0}, {window.width, window.height});
    ImGui::SetNextWindowBgAlpha(0.97f);
    ImGui::Begin("Keys and gestures", &open,
                 ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_HorizontalScrollbar);
    const ImVec2 corner = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    ui.map.area("help", {corner.x, corner.y, size.x, size.y});
    if (begin_key_table("gestures")) {
        for (const Gesture& gesture : gestures()) key_row(gesture.keys, gesture.help);
        ImGui::EndTable();
    }
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
    if (begin_key_table("keys")) {
        for (const Shortcut& shortcut : shortcuts())
            if (*shortcut.keys) key_row(shortcut.keys, shortcut.help);
        ImGui::EndTable();
    }
    ImGui::End();
    return open;
}

} // namespace glint::viewer
