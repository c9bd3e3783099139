// Follows the explanation of a pixel and draws it.
#include "pixel_inspector.h"

#include "messages.h"
#include "scene_editor.h"
#include "session/clock.h"

#include "glint/explain.h"
#include "glint/explanation_files.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

namespace glint::viewer {
namespace {

/// Explanations that take less need no message.
constexpr double silent_seconds = 0.2;

const ExplainedSample& selected_sample(const Explanation& explanation, const PixelChoice& choice) {
    return explanation.samples[static_cast<std::size_t>(choice.sample)];
}

/// A circle around the explained pixel.
void draw_mark(const Ui& ui, const ImVec2& at) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const float radius = 7 * ui.theme.scale;
    draw.AddCircle(at, radius + 1, IM_COL32(0, 0, 0, 160), 24, 4);
    draw.AddCircle(at, radius + 1, ImGui::GetColorU32(color_of(ui.theme.accent)), 24, 2);
}

} // namespace

void PixelInspector::explain(const ViewPixel& pixel) {
    editor_.session().explain(pixel.slot, pixel.x, pixel.y);
    inspected_ = Inspected();
    inspected_->pixel = pixel;
}

void PixelInspector::clear() {
    inspected_.reset();
    picked_ = {};
    editor_.session().stop_explaining();
}

bool PixelInspector::is_waiting() const {
    return inspected_ && inspected_->busy_since > 0 && now() - inspected_->busy_since < 2 * silent_seconds;
}

bool PixelInspector::is_slow() const {
    return inspected_->busy_since > 0 && now() - inspected_->busy_since > silent_seconds;
}

// ── Answers ────────────────────────────────────────────────────────────────────────────────────────────────

void PixelInspector::update() {
    if (!inspected_) return;
    const std::shared_ptr<const PixelAnswer> answer = editor_.explained();
    const bool explaining = editor_.is_explaining();
    if (!explaining) inspected_->busy_since = 0;
    if (explaining && inspected_->busy_since == 0) inspected_->busy_since = now();
    // The view of the pixel is gone.
    if (!answer && !explaining) return clear();
    if (!answer || answer == inspected_->answer) return;
    if (!answer->fault.empty()) {
        messages_.show(answer->fault);
        return clear();
    }
    take(answer);
}

void PixelInspector::take(std::shared_ptr<const PixelAnswer> answer) {
    inspected_->answer_time = inspected_->answer ? now() : 0;
    inspected_->answer = std::move(answer);
    inspected_->lines_sample = -1;
    inspected_->command_time = -1;
    inspected_->gpu.reset();
    const Explanation& explanation = inspected_->answer->explanation;
    PixelChoice& choice = inspected_->choice;
    choice.sample = std::clamp(choice.sample, 0, explained_sample_count(explanation) - 1);
    const auto& rays = selected_sample(explanation, choice).rays;
    if (choice.selected.ray >= static_cast<int>(rays.size())) choice.selected = {};
    update_picked();
}

void PixelInspector::update_picked() {
    const PixelChoice& choice = inspected_->choice;
    const ExplainedRay& ray = selected_sample(inspected_->answer->explanation, choice)
                                  .rays[static_cast<std::size_t>(choice.selected.ray)];
    const SceneDescription& scene = *editor_.description();
    Picked hit;
    // The reference view may have had other objects.
    if (ray.hit && ray.object < scene.objects.size() &&
        object_label(scene.objects[ray.object], ray.number) == ray.label)
        hit = {ray.material, ray.object, true};
    if (hit.material == picked_.material && hit.object == picked_.object) return;
    picked_ = hit;
}

/// With the same camera and size as when the pixel was clicked?
bool PixelInspector::is_seen_from_here() const {
    const Session& session = editor_.session();
    const PixelQuestion& asked = inspected_->answer->question;
    return asked.width == session.width() && asked.height == session.height() &&
           same_view(asked.camera, session.camera().camera());
}

// ── Remarks ────────────────────────────────────────────────────────────────────────────────────────────────

/// Which device the numbers are from; once the GPU's picture is finished, how far its pixel differs.
std::string PixelInspector::device_remark() {
    const auto frame = editor_.frame(inspected_->pixel.slot);
    if (!frame || frame->device.empty()) return "";
    const PixelQuestion& asked = inspected_->answer->question;
    const bool is_same_picture = frame->on_device && frame->width == asked.width &&
                                 frame->height == asked.height && same_view(frame->camera, asked.camera);
    const std::string cpu = "Computed on the CPU";
    if (!is_same_picture) return cpu + "; the GPU draws";
    if (!frame->reached.finished || !editor_.is_settled(inspected_->answer_time)) {
        inspected_->gpu.reset();
        return cpu + "; the GPU's picture is not finished";
    }
    if (!inspected_->gpu || inspected_->gpu_frame != frame->number) {
        inspected_->gpu = OtherPixel{frame->device, Canvas::pixel_of(*frame->on_device, asked.x, asked.y)};
        inspected_->gpu_frame = frame->number;
    }
    return cpu + "; " + other_pixel_text(inspected_->answer->explanation, *inspected_->gpu);
}

/// Cached: it parses the scene file, which is too slow for every frame.
const std::string& PixelInspector::command_line() {
    Inspected& i = *inspected_;
    if (i.command_time != editor_.last_change())
        i.command = explain_command(editor_.shown_file(i.pixel.slot), i.answer->question).line;
    i.command_time = editor_.last_change();
    return i.command;
}

void PixelInspector::copy_command() {
    const ShownFile shown = editor_.shown_file(inspected_->pixel.slot);
    ExplainCommand command = explain_command(shown, inspected_->answer->question);
    check(command, shown);
    ImGui::SetClipboardText(command.line.c_str());
    messages_.show(command.limitation.empty() ? "The command is copied"
                                              : "Copied, but it prints another pixel: " + command.limitation);
}

// ── Drawing ────────────────────────────────────────────────────────────────────────────────────────────────

void PixelInspector::draw_tab(Ui& ui) {
    if (!inspected_) {
        quiet_text(ui, "Click into the picture: here stands why the pixel has its colour.");
        return;
    }
    const ViewPixel& pixel = inspected_->pixel;
    PixelRemarks remarks;
    if (presenter_.is_comparing()) remarks.picture = pixel.slot == ViewSlot::reference ? "A" : "B";
    if (!inspected_->answer) {
        pixel_heading(ui, pixel.x, pixel.y, remarks.picture);
        if (is_slow()) quiet_text(ui, "Explaining \u2026");
        return;
    }
    remarks.command = command_line();
    remarks.is_elsewhere = !is_seen_from_here();
    remarks.is_again = is_slow();
    remarks.devices = device_remark();
    const PixelRequest request =
        pixel_panel(ui, inspected_->answer->explanation, inspected_->choice, remarks);
    if (request == PixelRequest::copy_command) copy_command();
    if (request == PixelRequest::explain_here) {
        const Session& session = editor_.session();
        const PixelQuestion& asked = inspected_->answer->question;
        return explain(
            {pixel.slot, std::min(asked.x, session.width() - 1), std::min(asked.y, session.height() - 1)});
    }
    update_picked();
    ui.map.state("pixel.command", remarks.command);
    ui.map.state("pixel.elsewhere", remarks.is_elsewhere);
    ui.map.state("pixel.devices", remarks.devices);
}

void PixelInspector::update_lines() {
    if (inspected_->lines_sample == inspected_->choice.sample) return;
    const Explanation& explanation = inspected_->answer->explanation;
    const ExplainedSample& sample = selected_sample(explanation, inspected_->choice);
    inspected_->lines = ray_lines(sample, explanation.origin, editor_.extent());
    inspected_->lines_sample = inspected_->choice.sample;
}

void PixelInspector::draw_rays(Ui& ui) {
    visible_lines_ = 0;
    if (!inspected_ || !inspected_->answer) return;
    update_lines();
    const Explanation& explanation = inspected_->answer->explanation;
    const ViewSlot slot = inspected_->pixel.slot;
    const Area& area = presenter_.area(slot);
    const Area part = presenter_.visible_part(slot);
    const int width = explanation.width;
    const int height = explanation.height;
    const Projection projection(editor_.session().camera().camera(), width, height);
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.PushClipRect({part.x, part.y}, {part.x + part.width, part.y + part.height});
    visible_lines_ =
        draw_lines(area, projection, width, height, inspected_->lines, inspected_->choice.selected);
    // The mark stays on what was clicked when the camera moves.
    const ExplainedRay& first = selected_sample(explanation, inspected_->choice).rays.front();
    const Vec3 clicked =
        first.hit ? Vec3(first.position) : Vec3(first.origin) + Vec3(first.direction) * editor_.extent();
    if (const auto at = projection.point(explanation.origin + clicked))
        draw_mark(ui, {area.x + static_cast<float>(at->x / width) * area.width,
                       area.y + static_cast<float>(at->y / height) * area.height});
    draw.PopClipRect();
}

// ── Map ────────────────────────────────────────────────────────────────────────────────────────────────────

void PixelInspector::report(UiMap& map) const {
    map.state("rays_drawn", static_cast<double>(visible_lines_));
    if (!inspected_) return;
    map.state("explaining", editor_.is_explaining());
    map.state("pixel.picture", inspected_->pixel.slot == ViewSlot::reference ? "A" : "B");
    map.state("pixel.x", static_cast<double>(inspected_->pixel.x));
    map.state("pixel.y", static_cast<double>(inspected_->pixel.y));
    map.state("pixel.material", picked_.material);
    if (!inspected_->answer) return;
    const glm::vec3& color = inspected_->answer->explanation.color;
    map.state("pixel.color", fmt::format("{:.9g} {:.9g} {:.9g}", color.x, color.y, color.z));
}

} // namespace glint::viewer
