// The texts of the status line and the slider of the timeline.
#include "status_bar.h"

#include "playback.h"
#include "scene_editor.h"

#include "glint/scene_files.h"

#include <fmt/format.h>
#include <imgui.h>

#include <thread>

namespace glint::viewer {
namespace {

/// Padding of both lines, at scale 1.
constexpr float padding_x = 14;

std::string rate_text(double rays_per_second) {
    return rays_per_second >= 1e6 ? fmt::format("{:.1f} Mrays/s", rays_per_second / 1e6)
                                  : fmt::format("{:.0f} krays/s", rays_per_second / 1e3);
}

/// "800 × 600 · 3 of 16 samples · 12.3 Mrays/s".
std::string picture_text(const RenderedFrame& frame, int spp) {
    const Refinement& reached = frame.reached;
    std::string text = fmt::format("{} \u00d7 {}", frame.width, frame.height);
    if (reached.finished)
        text += spp == 1 ? "  \u00b7  finished" : fmt::format("  \u00b7  {} samples, finished", spp);
    else if (reached.samples > 0)
        text += fmt::format("  \u00b7  {} of {} samples", reached.samples, spp);
    else if (reached.step > 1)
        text += fmt::format("  \u00b7  every {}th pixel", reached.step);
    if (frame.rays_per_second > 0) text += "  \u00b7  " + rate_text(frame.rays_per_second);
    if (!frame.why_cpu.empty()) text += "  \u00b7  " + first_line(frame.why_cpu);
    return text;
}

/// "CPU: auto kernel, AVX2, 2 threads", or the graphics card.
std::string device_text(const RenderedFrame* frame, Kernel kernel, int threads) {
    if (frame != nullptr && !frame->device.empty()) return "GPU: " + frame->device;
    const char* target = is_available(SimdTarget::avx512) ? "AVX-512"
                         : is_available(SimdTarget::avx2) ? "AVX2"
                         : is_available(SimdTarget::sse4) ? "SSE4"
                                                          : "plain";
    const unsigned count = threads > 0 ? static_cast<unsigned>(threads) : std::thread::hardware_concurrency();
    return fmt::format("CPU: {} kernel, {}, {} thread{}", kernel_names[static_cast<std::size_t>(kernel)],
                       target, count, count == 1 ? "" : "s");
}

/// Shortens a text to a width, with an ellipsis at its end.
std::string cut_to(std::string text, float width) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
    const auto is_continuation = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; };
    while (!text.empty() && ImGui::CalcTextSize((text + "\u2026").c_str()).x > width) {
        while (text.size() > 1 && is_continuation(text.back())) text.pop_back();
        text.pop_back();
    }
    return text + "\u2026";
}

void begin_line(const Ui& ui, const char* name, const Area& area, float padding_y) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(padding_x * ui.theme.scale, padding_y));
    begin_fixed_window(name, area);
    ImGui::PopStyleVar();
}

/// A progress bar and the text, cut at `right`.
void draw_picture_text(Ui& ui, const RenderedFrame& frame, int spp, float padding, float right) {
    const float height = ImGui::GetFontSize();
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 0.3f * height);
    ImGui::ProgressBar(static_cast<float>(frame.reached.fraction), {6 * height, 0.4f * height}, "");
    ImGui::SameLine();
    ImGui::SetCursorPosY(padding);
    const std::string text = picture_text(frame, spp);
    ImGui::TextUnformatted(cut_to(text, right - ImGui::GetCursorPosX()).c_str());
    ui.map.item("status");
}

} // namespace

bool draw_status(Ui& ui, const Area& area, const SceneEditor& editor, Kernel kernel, int threads) {
    const float padding = 6 * ui.theme.scale;
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
    begin_line(ui, "status", area, padding);
    const auto frame = editor.description() != nullptr ? editor.frame() : nullptr;
    const char* hint = "?  keys";
    const std::string device = device_text(frame.get(), kernel, threads);
    const float gap = 24 * ui.theme.scale;
    const float hint_x = ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(hint).x;
    const float device_x = hint_x - gap - ImGui::CalcTextSize(device.c_str()).x;
    if (frame) {
        const SampleCounts samples = sample_counts(editor.description()->render);
        draw_picture_text(ui, *frame, std::max(samples.all, samples.differing), padding, device_x - gap);
    }
    ImGui::SameLine(device_x);
    ImGui::SetCursorPosY(padding);
    ImGui::TextDisabled("%s", device.c_str());
    ImGui::SameLine(hint_x);
    ImGui::SetCursorPosY(padding);
    ImGui::TextDisabled("%s", hint);
    const bool wants_keys = ImGui::IsItemClicked();
    ui.map.item("button:help");
    ImGui::End();
    ImGui::PopStyleColor();
    return wants_keys;
}

void draw_timeline(Ui& ui, const Area& area, const SceneEditor& editor, Playback& playback) {
    const Animation& animation = *editor.animation();
    begin_line(ui, "timeline", area, 9 * ui.theme.scale);
    const bool playing = playback.is_playing();
    if (button(ui, "play", playing ? "Stop" : "Play", "Space", playing)) playback.toggle();
    ImGui::SameLine();
    const double first = animation.first;
    const double last = animation.last;
    double frame = editor.frame_shown();
    const std::string format =
        fmt::format("frame %.0f of {} to {}, {:g} a second", animation.first, animation.last, animation.fps);
    ImGui::SetNextItemWidth(-1);
    if (ImGui::SliderScalar("##frame", ImGuiDataType_Double, &frame, &first, &last, format.c_str()))
        playback.seek(frame);
    ui.map.item("timeline");
    ImGui::End();
}

} // namespace glint::viewer
