// The boxes of messages, in the order in which they cover each other.
#include "messages.h"

#include "actions.h"
#include "scene_editor.h"
#include "session/clock.h"
#include "widgets.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace glint::viewer {
namespace {

constexpr double notice_seconds = 3;
/// Files that load faster need no progress: nobody could read it.
constexpr double silent_loading_seconds = 0.3;

constexpr ImGuiWindowFlags fixed_box = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav;
constexpr ImGuiWindowFlags passive_box = fixed_box | ImGuiWindowFlags_NoInputs |
                                         ImGuiWindowFlags_AlwaysAutoResize |
                                         ImGuiWindowFlags_NoFocusOnAppearing;

/// Centres the next box in a space.
void center_next_box(const Area& space) {
    ImGui::SetNextWindowPos({space.x + space.width / 2, space.y + space.height / 2}, ImGuiCond_Always,
                            {0.5f, 0.5f});
}

void report_box(Ui& ui, const char* name) {
    const ImVec2 corner = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    ui.map.area(name, {corner.x, corner.y, size.x, size.y});
}

/// "scene.toml:3:7  message", the excerpt, and the hint.
void draw_error(Ui& ui, const Diagnostic& error) {
    const Location& location = error.location;
    std::string position = location.file.substr(location.file.find_last_of('/') + 1);
    if (location.line > 0) position += fmt::format(":{}:{}", location.line, location.column);
    ImGui::PushStyleColor(ImGuiCol_Text, color_of(ui.theme.error));
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

/// Errors of the file along the top of `space`, with the lines they are in. `footer`: what the picture shows
/// meanwhile.
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
    ImGui::GetWindowDrawList()->AddRectFilled(
        corner, {corner.x + 4 * ui.theme.scale, corner.y + ImGui::GetWindowHeight()},
        ImGui::GetColorU32(color_of(ui.theme.error)));
    report_box(ui, "errors");
    ImGui::End();
}

/// The progress of loading. A negative fraction is unknown. True if Cancel was pressed.
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

/// A line at the bottom of the picture.
void draw_notice(Ui& ui, const Area& space, const std::string& text, float opacity) {
    ImGui::SetNextWindowPos({space.x + space.width / 2, space.y + space.height - 18 * ui.theme.scale},
                            ImGuiCond_Always, {0.5f, 1});
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, opacity);
    ImGui::Begin("notice", nullptr, passive_box);
    ImGui::TextUnformatted(text.c_str());
    ImGui::End();
    ImGui::PopStyleVar();
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

/// All keys and gestures, scrolling if the window is too small. False once it is closed.
bool draw_help(Ui& ui, const WindowSize& window) {
    const ImVec2 size(static_cast<float>(window.width), static_cast<float>(window.height));
    center_next_box({0, 0, size.x, size.y});
    bool open = true;
    ImGui::SetNextWindowSizeConstraints({0, 0}, size);
    ImGui::SetNextWindowBgAlpha(0.97f);
    ImGui::Begin("Keys and gestures", &open,
                 ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_HorizontalScrollbar);
    report_box(ui, "help");
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

} // namespace

void Messages::show(std::string text) {
    notice_ = std::move(text);
    notice_until_ = now() + notice_seconds;
}

bool Messages::is_showing() const { return now() < notice_until_; }

bool Messages::close_help() { return std::exchange(help_, false); }

void Messages::draw(Ui& ui, const Area& space, const WindowSize& window, SceneEditor& editor) {
    const bool has_scene = editor.description() != nullptr;
    draw_errors(ui, space, editor.problems(),
                has_scene ? "The picture shows the scene as it was before." : "");
    draw_progress(ui, space, editor);
    const double left = notice_until_ - now();
    if (left > 0) draw_notice(ui, space, notice_, static_cast<float>(std::min(1.0, left * 2)));
    if (help_) help_ = draw_help(ui, window);
}

void Messages::draw_progress(Ui& ui, const Area& space, SceneEditor& editor) {
    const LoadStatus& status = editor.status();
    if (!status.busy) loading_since_ = 0;
    if (status.busy && loading_since_ == 0) loading_since_ = now();
    if (!status.busy || now() - loading_since_ < silent_loading_seconds) return;
    if (draw_loading(ui, space, status.progress.activity, status.progress.fraction))
        editor.session().cancel_loading();
}

} // namespace glint::viewer
