// The pixel that is explained: asked for by a click, told by the panel, drawn into the picture.
#include "app.h"
#include "overlay.h"

#include "glint/explain.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace glint::viewer {
namespace {

/// A change takes a moment to reach the pictures.
constexpr double settled_seconds = 0.25;

const ExplainedRay& chosen_ray(const Explanation& explanation, const PixelChoice& choice) {
    return explanation.samples[static_cast<std::size_t>(choice.sample)]
        .rays[static_cast<std::size_t>(choice.place.ray)];
}

} // namespace

/// Which of the two pictures is seen there.
ViewSlot App::slot_at(const PicturePlace& where) const {
    if (!is_comparing() || !bench_.frame(ViewSlot::reference)) return ViewSlot::main;
    if (state_.compare == CompareMode::side_by_side)
        return where.picture == 1 ? ViewSlot::reference : ViewSlot::main;
    return where.across < state_.wipe ? ViewSlot::reference : ViewSlot::main;
}

/// Where a picture can be seen; less than its area where the other one hides it.
Area App::seen_part(ViewSlot slot) const {
    Area part =
        slot == ViewSlot::reference && state_.compare == CompareMode::side_by_side ? reference_ : picture_;
    if (!is_comparing() || state_.compare != CompareMode::wipe) return part;
    const float left = part.width * state_.wipe;
    if (slot == ViewSlot::main) part.x += left;
    part.width = slot == ViewSlot::reference ? left : part.width - left;
    return part;
}

void App::explain_at(const PicturePlace& where) {
    Session& session = bench_.session();
    const int x = std::clamp(static_cast<int>(where.across * session.width()), 0, session.width() - 1);
    const int y = std::clamp(static_cast<int>(where.down * session.height()), 0, session.height() - 1);
    explain(slot_at(where), x, y);
    state_.panel = true;
    state_.tab = Tab::pixel;
    state_.turn_to_tab = true;
}

void App::explain(ViewSlot slot, int x, int y) {
    bench_.session().explain(slot, x, y);
    pixel_.emplace();
    pixel_->slot = slot;
    pixel_->x = x;
    pixel_->y = y;
}

void App::let_go() {
    pixel_.reset();
    picked_ = {};
    bench_.session().stop_explaining();
}

/// Takes what the session has explained since the last frame.
void App::follow_explained() {
    if (!pixel_) return;
    const std::shared_ptr<const PixelAnswer> answer = bench_.explained();
    const bool explaining = bench_.is_explaining();
    if (!explaining) pixel_->busy_since = 0;
    if (explaining && pixel_->busy_since == 0) pixel_->busy_since = now();
    // The picture that it was of is gone.
    if (!answer && !explaining) return let_go();
    if (!answer || answer == pixel_->answer) return;
    if (!answer->fault.empty()) {
        notice(answer->fault);
        return let_go();
    }
    pixel_->since = pixel_->answer ? now() : 0;
    pixel_->answer = answer;
    pixel_->lines_of_sample = -1;
    pixel_->gpu.reset();
    PixelChoice& choice = pixel_->choice;
    choice.sample = std::clamp(choice.sample, 0, explained_sample_count(answer->explanation) - 1);
    const auto& rays = answer->explanation.samples[static_cast<std::size_t>(choice.sample)].rays;
    if (choice.place.ray >= static_cast<int>(rays.size())) choice.place = {};
    mark_picked();
}

/// Is the pixel seen as it was when it was clicked?
bool App::is_where_it_was() const {
    const Session& session = bench_.session();
    const PixelQuestion& asked = pixel_->answer->question;
    return asked.width == session.width() && asked.height == session.height() &&
           same_view(asked.camera, session.camera().camera());
}

/// What the graphics card makes of the pixel, once its picture is finished.
std::string App::compare_with_gpu() {
    const auto frame = bench_.frame(pixel_->slot);
    if (!frame || frame->device.empty()) return "";
    const PixelQuestion& asked = pixel_->answer->question;
    const bool is_its_picture = frame->on_device && frame->width == asked.width &&
                                frame->height == asked.height && same_view(frame->camera, asked.camera);
    const std::string ours = "Computed on the CPU";
    if (!is_its_picture) return ours + "; the GPU draws";
    const double calm = now() - std::max(pixel_->since, last_change_);
    if (!frame->reached.finished || bench_.status().busy || calm < settled_seconds) {
        pixel_->gpu.reset();
        return ours + "; the GPU's picture is not finished";
    }
    if (!pixel_->gpu || pixel_->gpu_frame != frame->number) {
        pixel_->gpu = OtherPixel{frame->device, Canvas::pixel_of(*frame->on_device, asked.x, asked.y)};
        pixel_->gpu_frame = frame->number;
    }
    return ours + "; " + other_pixel_text(pixel_->answer->explanation, *pixel_->gpu);
}

/// For that a large scene is parsed: not for every frame.
const std::string& App::command_line() {
    ExplainedPixel& p = *pixel_;
    if (p.command_of != p.answer || p.command_time != last_change_)
        p.command = explain_command(bench_.shown_file(p.slot), p.answer->question).line;
    p.command_of = p.answer;
    p.command_time = last_change_;
    return p.command;
}

void App::copy_command() {
    const ShownFile shown = bench_.shown_file(pixel_->slot);
    ExplainCommand command = explain_command(shown, pixel_->answer->question);
    check(command, shown);
    ImGui::SetClipboardText(command.line.c_str());
    notice(command.limitation.empty() ? "The command is copied"
                                      : "Copied, but it prints another pixel: " + command.limitation);
}

void App::draw_pixel_tab() {
    if (!pixel_) {
        quiet_text(ui_, "Click into the picture: here stands why the pixel has its colour.");
        return;
    }
    const bool is_long = pixel_->busy_since > 0 && now() - pixel_->busy_since > silent_seconds;
    PixelRemarks remarks;
    if (is_comparing()) remarks.picture = pixel_->slot == ViewSlot::reference ? "A" : "B";
    if (!pixel_->answer) {
        pixel_heading(ui_, pixel_->x, pixel_->y, remarks.picture);
        if (is_long) quiet_text(ui_, "Explaining \u2026");
        return;
    }
    remarks.command = command_line();
    remarks.is_elsewhere = !is_where_it_was();
    remarks.is_again = is_long;
    remarks.devices = compare_with_gpu();
    const PixelWish wish = pixel_panel(ui_, pixel_->answer->explanation, pixel_->choice, remarks);
    if (wish == PixelWish::copy_command) copy_command();
    if (wish == PixelWish::explain_here) {
        const Session& session = bench_.session();
        const PixelQuestion& asked = pixel_->answer->question;
        return explain(pixel_->slot, std::min(asked.x, session.width() - 1),
                       std::min(asked.y, session.height() - 1));
    }
    mark_picked();
    if (!ui_.map.is_kept()) return;
    ui_.map.state("pixel.command", remarks.command);
    ui_.map.state("pixel.elsewhere", remarks.is_elsewhere);
    ui_.map.state("pixel.devices", remarks.devices);
}

/// The Scene panel marks what the chosen ray meets.
void App::mark_picked() {
    const ExplainedRay& ray = chosen_ray(pixel_->answer->explanation, pixel_->choice);
    const SceneDescription& scene = *bench_.description();
    Picked met;
    // A may have had other objects.
    if (ray.hit && ray.object < scene.objects.size() && object_label(scene, ray.object) == ray.label)
        met = {ray.material, ray.object, true};
    if (met.material == picked_.material && met.object == picked_.object) return;
    picked_ = met;
}

void App::draw_explained() {
    rays_drawn_ = 0;
    if (!pixel_ || !pixel_->answer) return;
    const Explanation& explanation = pixel_->answer->explanation;
    const ExplainedSample& sample = explanation.samples[static_cast<std::size_t>(pixel_->choice.sample)];
    if (pixel_->lines_of_sample != pixel_->choice.sample) {
        pixel_->lines = ray_lines(sample, bench_.extent());
        pixel_->lines_of_sample = pixel_->choice.sample;
    }
    const ViewSlot slot = pixel_->slot;
    const Area& area =
        slot == ViewSlot::reference && state_.compare == CompareMode::side_by_side ? reference_ : picture_;
    const Area part = seen_part(slot);
    const int width = explanation.width;
    const int height = explanation.height;
    const Projection projection(bench_.session().camera().camera(), width, height);
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.PushClipRect({part.x, part.y}, {part.x + part.width, part.y + part.height});
    rays_drawn_ = draw_rays(area, projection, width, height, pixel_->lines, pixel_->choice.place);
    // The mark stays on what was clicked when the camera moves.
    const ExplainedRay& first = sample.rays.front();
    const Vec3 seen =
        first.hit ? Vec3(first.position) : Vec3(first.origin) + Vec3(first.direction) * bench_.extent();
    if (const auto at = projection.point(seen)) draw_mark(ui_, area, at->x / width, at->y / height);
    draw.PopClipRect();
}

void App::tell_pixel() {
    if (!pixel_) return;
    UiMap& map = ui_.map;
    map.state("explaining", bench_.is_explaining());
    map.state("pixel.picture", pixel_->slot == ViewSlot::reference ? "A" : "B");
    map.state("pixel.x", static_cast<double>(pixel_->x));
    map.state("pixel.y", static_cast<double>(pixel_->y));
    map.state("pixel.material", picked_.material);
    if (!pixel_->answer) return;
    const glm::vec3& color = pixel_->answer->explanation.color;
    map.state("pixel.color", fmt::format("{:.9g} {:.9g} {:.9g}", color.x, color.y, color.z));
}

} // namespace glint::viewer
