// Layout, textures and the wipe line.
#include "presenter.h"

#include "layout.h"
#include "scene_editor.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace glint::viewer {
namespace {

/// A triangle of the grip, `side` = −1 to the left of the line, 1 to the right.
void draw_arrowhead(ImDrawList& draw, const ImVec2& middle, float grip, float side) {
    draw.AddTriangleFilled({middle.x + side * 0.7f * grip, middle.y},
                           {middle.x + side * 0.2f * grip, middle.y + side * 0.4f * grip},
                           {middle.x + side * 0.2f * grip, middle.y - side * 0.4f * grip},
                           IM_COL32(40, 40, 40, 255));
}

/// A small label in an upper corner of the picture.
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

} // namespace

bool Presenter::is_comparing() const { return state_.compare != CompareMode::off && editor_.has_kept(); }

bool Presenter::is_finished() const {
    const auto frame = editor_.frame();
    // Of another quantity it may be the last picture before a shader that is still being compiled.
    return frame && frame->reached.finished && frame->show == state_.show && editor_.is_settled() &&
           frame->width == editor_.session().width() && frame->height == editor_.session().height();
}

// ── Layout ─────────────────────────────────────────────────────────────────────────────────────────────────

void Presenter::lay_out(const Area& space, float scale) {
    const RenderSettings& render = editor_.description()->render;
    const auto [width, height] = size_.value_or(std::pair(render.width, render.height));
    const float ratio = window_.size().pixels_per_unit();
    Area rest = space;
    if (is_side_by_side()) {
        const float gap = 4 * scale;
        rest.width = (rest.width - gap) / 2;
        areas_[ViewSlot::reference] = fit(rest, width, height, ratio);
        rest.x += rest.width + gap;
    }
    areas_[ViewSlot::main] = fit(rest, width, height, ratio);
    Session& session = editor_.session();
    const auto pixels = [ratio](float units) { return static_cast<int>(std::lround(units * ratio)); };
    const Area& main = areas_[ViewSlot::main];
    const std::pair wanted = size_.value_or(std::pair(pixels(main.width), pixels(main.height)));
    if (wanted == std::pair(session.width(), session.height())) return;
    session.resize(wanted.first, wanted.second);
    editor_.note_change();
}

const Area& Presenter::area(ViewSlot slot) const {
    const bool is_apart = slot == ViewSlot::reference && state_.compare == CompareMode::side_by_side;
    return areas_[is_apart ? ViewSlot::reference : ViewSlot::main];
}

float Presenter::wipe_x() const { return areas_[ViewSlot::main].x + areas_[ViewSlot::main].width * wipe_; }

Area Presenter::visible_part(ViewSlot slot) const {
    Area part = area(slot);
    if (!is_comparing() || state_.compare != CompareMode::wipe) return part;
    const float left = part.width * wipe_;
    if (slot == ViewSlot::main) part.x += left;
    part.width = slot == ViewSlot::reference ? left : part.width - left;
    return part;
}

std::span<const Area> Presenter::mouse_areas() const {
    return std::span(areas_.values).first(is_side_by_side() ? 2 : 1);
}

ViewPixel Presenter::pixel_at(const PicturePosition& position) const {
    ViewPixel pixel;
    if (is_comparing() && editor_.frame(ViewSlot::reference)) {
        const bool in_reference =
            state_.compare == CompareMode::side_by_side ? position.picture == 1 : position.u < wipe_;
        if (in_reference) pixel.slot = ViewSlot::reference;
    }
    const Session& session = editor_.session();
    pixel.x = std::clamp(static_cast<int>(position.u * session.width()), 0, session.width() - 1);
    pixel.y = std::clamp(static_cast<int>(position.v * session.height()), 0, session.height() - 1);
    return pixel;
}

// ── Pictures ───────────────────────────────────────────────────────────────────────────────────────────────

/// True if the main view has a new picture.
bool Presenter::update_textures() {
    bool is_new = false;
    for (const ViewSlot slot : view_slots) {
        const auto frame = editor_.frame(slot);
        if (!frame) canvas_.drop(slot);
        if (!frame || shown_numbers_[slot] == frame->number) continue;
        if (frame->on_device)
            canvas_.show(slot, frame->on_device);
        else
            canvas_.upload(slot, frame->image.width, frame->image.height, frame->screen);
        shown_numbers_[slot] = frame->number;
        is_new |= slot == ViewSlot::main;
    }
    return is_new;
}

bool Presenter::draw() {
    const bool is_new = update_textures();
    if (!editor_.frame()) return is_new;
    const WindowSize size = window_.size();
    if (!is_comparing() || !editor_.frame(ViewSlot::reference)) {
        canvas_.draw(ViewSlot::main, areas_[ViewSlot::main], areas_[ViewSlot::main], state_.view, size);
        return is_new;
    }
    for (const ViewSlot slot : {ViewSlot::reference, ViewSlot::main})
        canvas_.draw(slot, area(slot), visible_part(slot), state_.view, size);
    return is_new;
}

// ── Comparison ─────────────────────────────────────────────────────────────────────────────────────────────

void Presenter::draw_comparison(Ui& ui) {
    editor_.compare(is_comparing());
    if (!is_comparing()) return;
    if (is_side_by_side()) {
        ui.map.area("reference", areas_[ViewSlot::reference]);
        draw_label(ui, areas_[ViewSlot::reference], "A", false);
        draw_label(ui, areas_[ViewSlot::main], "B", false);
        return;
    }
    draw_label(ui, areas_[ViewSlot::main], "A", false);
    draw_label(ui, areas_[ViewSlot::main], "B", true);
    draw_wipe_line(ui);
}

void Presenter::draw_wipe_line(Ui& ui) {
    const Area& picture = areas_[ViewSlot::main];
    const float x = wipe_x();
    const float grip = 9 * ui.theme.scale;
    const float middle = picture.y + picture.height / 2;
    ui.map.area("wipe", {x - grip, middle - grip, 2 * grip, 2 * grip});
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.AddLine({x, picture.y}, {x, picture.y + picture.height}, IM_COL32(0, 0, 0, 120), 3);
    draw.AddLine({x, picture.y}, {x, picture.y + picture.height}, IM_COL32(255, 255, 255, 220), 1);
    draw.AddCircleFilled({x, middle}, grip, IM_COL32(255, 255, 255, 220));
    draw_arrowhead(draw, {x, middle}, grip, -1);
    draw_arrowhead(draw, {x, middle}, grip, 1);
    drag_wipe_line(grip);
}

void Presenter::drag_wipe_line(float grip) {
    const ImGuiIO& io = ImGui::GetIO();
    const Area& picture = areas_[ViewSlot::main];
    const float x = wipe_x();
    const bool near = std::abs(io.MousePos.x - x) < grip && picture.contains(x - 1, io.MousePos.y);
    if (near && !io.WantCaptureMouse && io.MouseClicked[0]) dragging_wipe_ = true;
    if (near || dragging_wipe_) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    // In a slow frame the last movement and the release arrive together.
    if (dragging_wipe_) wipe_ = std::clamp((io.MousePos.x - picture.x) / picture.width, 0.0f, 1.0f);
    if (!io.MouseDown[0]) dragging_wipe_ = false;
}

// ── Map ────────────────────────────────────────────────────────────────────────────────────────────────────

void Presenter::report(UiMap& map) {
    constexpr const char* modes[] = {"off", "wipe", "side by side"};
    map.state("compare", modes[static_cast<std::size_t>(state_.compare)]);
    map.state("wipe", static_cast<double>(wipe_));
    if (editor_.description() != nullptr) report_picture(map);
}

void Presenter::report_picture(UiMap& map) {
    map.state("finished", is_finished());
    const Vec3 eye = editor_.session().camera().camera().eye;
    map.state("camera.eye", fmt::format("{:.6g} {:.6g} {:.6g}", eye.x, eye.y, eye.z));
    const auto frame = editor_.frame();
    if (!frame) return;
    map.state("samples", static_cast<double>(frame->reached.samples));
    map.state("drawn_by", frame->device.empty() ? "CPU" : frame->device);
    map.state("on_device", frame->on_device != nullptr);
    if (!frame->why_cpu.empty()) map.state("why_cpu", frame->why_cpu);
    // Reading back from the graphics card is slow: finished pictures only.
    if (frame->on_device && !frame->reached.finished) return;
    if (hashed_number_ != frame->number) hash_ = picture_hash(image_of(*frame));
    hashed_number_ = frame->number;
    map.state("picture_hash", hash_);
}

} // namespace glint::viewer
