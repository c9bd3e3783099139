// The pixel's colour, the tree of its rays, and the derivation below.
#include "pixel_panel.h"

#include "pixel_derivation.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace glint::viewer {
namespace {

std::string row_text(const ExplainedRay& ray) {
    if (!ray.hit) return ray.end == RayEnd::absorbed ? "lost in a solid" : "background";
    return fmt::format("{}  \u00b7  {}", ray.label, ray.material);
}

std::string row_text(const ExplainedLight& light) {
    if (light.cosine <= 0) return light.label + "  \u00b7  behind the surface";
    for (const Blocker& blocker : light.blockers)
        if (blocker.share <= 0) return fmt::format("{}  \u00b7  behind {}", light.label, blocker.label);
    if (light.shadow < 1) return fmt::format("{}  \u00b7  {:.3g} gets through", light.label, light.shadow);
    return fmt::format("{}  \u00b7  {:.0f}\u00b0", light.label, light.degrees);
}

/// The tree of a sample: a row for each ray and each shadow ray.
class RayTreeView {
  public:
    RayTreeView(Ui& ui, const ExplainedSample& sample, RayId& selected)
        : ui_(ui), sample_(sample), selected_(selected) {}

    void draw() { draw_ray(0); }

  private:
    void draw_ray(int number) {
        const ExplainedRay& ray = sample_.rays[static_cast<std::size_t>(number)];
        row({number, -1}, ray.depth, kind_of(ray), row_text(ray), ray.weight * ray.radiance,
            fmt::format("ray:{}", number));
        for (std::size_t i = 0; i < ray.lights.size(); ++i) {
            const ExplainedLight& light = ray.lights[i];
            row({number, static_cast<int>(i)}, ray.depth + 1, kind_of(light), row_text(light),
                ray.weight * (light.diffuse + light.highlight), fmt::format("ray:{}:light:{}", number, i));
        }
        if (ray.reflected >= 0) draw_ray(ray.reflected);
        if (ray.refracted >= 0) draw_ray(ray.refracted);
    }

    void row(const RayId& id, int depth, LineKind kind, const std::string& text,
             const glm::vec3& contribution, const std::string& name) {
        const float size = ImGui::GetFontSize();
        ImGui::PushID(name.c_str());
        const ImVec2 start = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x;
        if (ImGui::Selectable("##row", id == selected_)) selected_ = id;
        ui_.map.item(name);
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        const float x = start.x + static_cast<float>(std::min(depth, 12)) * 0.9f * size;
        const ImU32 color = ImGui::GetColorU32(color_of(style_of(kind).tint));
        // Rays are bars, shadow rays are dots.
        if (id.light < 0)
            draw.AddRectFilled({x, start.y + 0.1f * size}, {x + 0.28f * size, start.y + 0.95f * size}, color,
                               0.1f * size);
        else
            draw.AddCircleFilled({x + 0.14f * size, start.y + 0.54f * size}, 0.17f * size, color);
        const float swatch = 1.3f * size;
        const ImVec2 corner(start.x + width - swatch, start.y + 0.08f * size);
        draw.PushClipRect(start, {corner.x - 0.3f * size, start.y + 2 * size}, true);
        draw.AddText({x + 0.6f * size, start.y}, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
        draw.PopClipRect();
        draw_swatch(corner, {swatch, 0.9f * size}, contribution);
        ImGui::PopID();
    }

    Ui& ui_;
    const ExplainedSample& sample_;
    RayId& selected_;
};

void draw_legend() {
    const float size = ImGui::GetFontSize();
    for (int i = 0; i < line_kind_count; ++i) {
        const LineStyle& style = style_of(static_cast<LineKind>(i));
        const float needed = ImGui::CalcTextSize(style.name).x + 1.4f * size;
        if (i > 0) ImGui::SameLine(0, 0.7f * size);
        if (ImGui::GetContentRegionAvail().x < needed) ImGui::NewLine();
        const ImVec2 start = ImGui::GetCursorScreenPos();
        ImGui::GetWindowDrawList()->AddCircleFilled({start.x + 0.3f * size, start.y + 0.55f * size},
                                                    0.22f * size, ImGui::GetColorU32(color_of(style.tint)));
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 0.75f * size);
        ImGui::TextDisabled("%s", style.name);
    }
}

PixelRequest draw_pixel(Ui& ui, const Explanation& explanation, const PixelRemarks& remarks) {
    PixelRequest request = PixelRequest::none;
    const float size = ImGui::GetFontSize();
    draw_swatch(ImGui::GetCursorScreenPos(), {2.2f * size, 2.2f * size}, explanation.color);
    ImGui::Dummy({2.2f * size, 2.2f * size});
    ImGui::SameLine();
    ImGui::BeginGroup();
    pixel_heading(ui, explanation.x, explanation.y, remarks.picture);
    ImGui::TextUnformatted(number_text(explanation.color).c_str());
    ImGui::EndGroup();
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize("Copy command").x -
                    2 * ImGui::GetStyle().FramePadding.x);
    if (button(ui, "copy_command", "Copy command", remarks.command.c_str()))
        request = PixelRequest::copy_command;
    if (remarks.is_again) quiet_text(ui, "The scene has changed: explaining again \u2026");
    if (!remarks.devices.empty()) quiet_text(ui, remarks.devices);
    if (!remarks.is_elsewhere) return request;
    quiet_text(ui, fmt::format("As seen when it was clicked, {} \u00d7 {} pixels.", explanation.width,
                               explanation.height));
    if (button(ui, "explain_here", "Explain as seen now", "the pixel of the same numbers"))
        request = PixelRequest::explain_here;
    return request;
}

void choose_sample(Ui& ui, const Explanation& explanation, PixelChoice& choice) {
    const int samples = explained_sample_count(explanation);
    choice.sample = std::clamp(choice.sample, 0, samples - 1);
    if (samples < 2) return;
    int shown = choice.sample + 1;
    label_row(ui, "sample", explanation.rule.c_str());
    const std::size_t all = explanation.samples.size();
    if (ImGui::SliderInt("##sample", &shown, 1, samples, fmt::format("%d of {}", all).c_str())) {
        choice.sample = std::clamp(shown, 1, samples) - 1;
        choice.selected = {};
    }
    ui.map.item("pixel.sample");
}

} // namespace

void pixel_heading(const Ui& ui, int x, int y, const std::string& picture) {
    const std::string of = picture.empty() ? "" : " of " + picture;
    heading(ui, fmt::format("Pixel {}, {}{}", x, y, of).c_str());
}

int explained_sample_count(const Explanation& explanation) {
    const auto has_rays = [](const ExplainedSample& sample) { return !sample.rays.empty(); };
    return static_cast<int>(std::count_if(explanation.samples.begin(), explanation.samples.end(), has_rays));
}

PixelRequest pixel_panel(Ui& ui, const Explanation& explanation, PixelChoice& choice,
                         const PixelRemarks& remarks) {
    const PixelRequest request = draw_pixel(ui, explanation, remarks);
    choose_sample(ui, explanation, choice);
    const ExplainedSample& sample = explanation.samples[static_cast<std::size_t>(choice.sample)];
    if (choice.selected.ray >= static_cast<int>(sample.rays.size())) choice.selected = {};

    // The tree takes up to about half of the panel; the derivation scrolls below it.
    ImGui::Spacing();
    draw_legend();
    std::size_t rows = sample.rays.size();
    for (const ExplainedRay& ray : sample.rays) rows += ray.lights.size();
    const float wanted = (static_cast<float>(rows) + 0.5f) * ImGui::GetTextLineHeightWithSpacing();
    ImGui::BeginChild("tree", {0, std::min(wanted, 0.45f * ImGui::GetContentRegionAvail().y)});
    RayTreeView(ui, sample, choice.selected).draw();
    ImGui::EndChild();
    ImGui::Separator();
    ImGui::BeginChild("working", {0, 0});
    const ExplainedRay& ray = sample.rays[static_cast<std::size_t>(choice.selected.ray)];
    if (choice.selected.light >= 0 && choice.selected.light < static_cast<int>(ray.lights.size()))
        draw_light(ui, ray, ray.lights[static_cast<std::size_t>(choice.selected.light)], explanation.origin);
    else
        draw_ray(ui, ray, explanation.origin);
    ImGui::EndChild();
    return request;
}

} // namespace glint::viewer
