// Values and steps of the light model for one ray or light.
#include "pixel_derivation.h"

#include "glint/explanation_files.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cstring>

namespace glint::viewer {
namespace {

/// A name and its value.
void value_row(Ui& ui, const char* name, const std::string& value) {
    label_row(ui, name);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(value.c_str());
    ImGui::PopTextWrapPos();
}

void topic_line(Ui& ui, const Step& step) {
    heading(ui, step.topic);
    if (!*step.section) return;
    const std::string section = std::string("report ") + step.section;
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(section.c_str()).x);
    ImGui::TextDisabled("%s", section.c_str());
}

/// "symbol = formula", then `numbers`, the formula with its values, then the result; one line for a step
/// without formula. `numbers` may be empty.
void step_lines(Ui& ui, const Step& step, const std::string& numbers) {
    ImGui::PushFont(ui.theme.fixed);
    ImGui::PushTextWrapPos(0);
    if (step.formula.empty()) {
        ImGui::TextUnformatted(fmt::format("{} = {}", step.symbol, quantity_text(step.result)).c_str());
    } else {
        ImGui::TextUnformatted(fmt::format("{} = {}", step.symbol, step.formula).c_str());
        ImGui::Indent();
        if (!numbers.empty()) ImGui::TextUnformatted(("= " + numbers).c_str());
        ImGui::TextUnformatted(fmt::format("= {}", quantity_text(step.result)).c_str());
        ImGui::Unindent();
    }
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    tooltip(step.meaning);
    if (*step.note) quiet_text(ui, step.note);
}

void steps(Ui& ui, const std::vector<Step>& all, const ExplainedRay& ray,
           const ExplainedLight* light = nullptr) {
    const char* topic = "";
    for (const Step& step : all) {
        if (std::strcmp(topic, step.topic) != 0) topic_line(ui, step);
        topic = step.topic;
        step_lines(ui, step, formula_in_numbers(step, ray, light));
    }
}

/// Refraction at the surface, or total reflection.
void refraction(Ui& ui, const ExplainedRay& ray) {
    heading(ui, "through the surface");
    ImGui::PushFont(ui.theme.fixed);
    ImGui::PushTextWrapPos(0);
    if (ray.total_reflection)
        ImGui::Text("%.4g\u00b0 is beyond the critical angle of %.4g\u00b0: all of it is reflected",
                    double(ray.degrees_before), double(ray.critical_degrees));
    else
        ImGui::Text("n\u2081 sin \u03b8\u2081 = n\u2082 sin \u03b8\u2082\n%.4g \u00b7 sin %.4g\u00b0 = %.4g "
                    "\u00b7 sin %.4g\u00b0",
                    double(ray.index_before), double(ray.degrees_before), double(ray.index_after),
                    double(ray.degrees_after));
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    if (!ray.total_reflection && ray.critical_degrees < 90)
        quiet_text(ui, fmt::format("total reflection from {:.4g}\u00b0 on", ray.critical_degrees));
}

/// Far from zero a position has more digits.
std::string position_text(const glm::vec3& position, const glm::dvec3& origin) {
    if (origin == glm::dvec3(0)) return number_text(position);
    const glm::dvec3 p = origin + glm::dvec3(position);
    return fmt::format("({:.12g}, {:.12g}, {:.12g})", p.x, p.y, p.z);
}

void surface(Ui& ui, const ExplainedRay& ray, const glm::dvec3& origin) {
    value_row(ui, "meets", fmt::format("{}, {}", ray.label, ray.entering ? "from outside" : "from inside"));
    value_row(ui, "material", ray.material);
    value_row(ui, "after", fmt::format("{:.5g}", ray.distance));
    value_row(ui, "at", position_text(ray.position, origin));
    value_row(ui, "normal", number_text(ray.shading_normal));
    if (ray.shading_normal != ray.geometric_normal)
        value_row(ui, "true normal", number_text(ray.geometric_normal));
    if (!ray.inside.empty()) value_row(ui, "inside", fmt::to_string(fmt::join(ray.inside, ", ")));
    if (!ray.passed_over.empty())
        value_row(ui, "passed over", fmt::to_string(fmt::join(ray.passed_over, ", ")));
    if (ray.gain > 1)
        quiet_text(ui, fmt::format("gain {:.3g}: more light leaves this surface than arrives", ray.gain));
}

} // namespace

std::string number_text(const glm::vec3& values) { return quantity_text(values, 5); }

void draw_swatch(const ImVec2& corner, const ImVec2& size, const glm::vec3& light) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 end(corner.x + size.x, corner.y + size.y);
    draw.AddRectFilled(corner, end, ImGui::GetColorU32(screen_color(Vec3(light))), 0.15f * size.y);
    draw.AddRect(corner, end, ImGui::GetColorU32(ImGuiCol_Border), 0.15f * size.y);
}

void draw_ray(Ui& ui, const ExplainedRay& ray, const glm::dvec3& origin) {
    heading(ui, fmt::format("{} ray, weight {}", ray_kind_name(ray.kind), number_text(ray.weight)).c_str());
    quiet_text(ui, ray.why);
    value_row(ui, "from", position_text(ray.origin, origin));
    if (ray.hit) surface(ui, ray, origin);
    if (ray.hit && ray.crosses) refraction(ui, ray);
    steps(ui, ray.given, ray);
    steps(ui, ray.steps, ray);
}

void draw_light(Ui& ui, const ExplainedRay& ray, const ExplainedLight& light, const glm::dvec3& origin) {
    heading(ui, light.label.c_str());
    value_row(ui, "distance", fmt::format("{:.5g}", light.distance));
    value_row(ui, "n \u00b7 l", fmt::format("{:.5g}  ({:.4g}\u00b0)", light.cosine, light.degrees));
    value_row(ui, "attenuation", fmt::format("{:.5g}", light.attenuation));
    if (light.asked)
        value_row(ui, "shadow ray", "from " + position_text(light.shadow_origin, origin));
    else
        quiet_text(ui, "no shadow ray: nothing arrives, or nothing of it would be seen");
    for (const Blocker& blocker : light.blockers)
        value_row(ui, blocker.share > 0 ? "passes" : "blocked by",
                  fmt::format("{} at {:.5g}, \u03c4 = {:.3g}{}", blocker.label, blocker.distance,
                              blocker.transparency, blocker.passed_over ? ", passed over" : ""));
    steps(ui, light.steps, ray, &light);
}

} // namespace glint::viewer
