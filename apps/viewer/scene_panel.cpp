#include "scene_panel.h"

#include "object_names.h"
#include "object_rows.h"

#include "glint/explain.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace glint::viewer {
namespace {

/// A slider's end for a number that has none: a round one above what it is now.
double end_for(double value, double usual) {
    if (value <= usual) return usual;
    return std::pow(10.0, std::ceil(std::log10(value * 1.0001)));
}

void material_rows(Ui& ui, const Material& m, std::vector<Edit>& edits) {
    Rows rows(ui, edits, "material." + m.name);
    rows.color("color", "color", m.color, "c: what the surface scatters, channel by channel");
    rows.number("ambient", "ambient", m.ambient, {0, end_for(m.ambient, 1)},
                "kₐ: the share of the ambient light, which stands for light from everywhere");
    rows.number("diffuse", "diffuse", m.diffuse, {0, end_for(m.diffuse, 1)},
                "k_d: the share of the arriving light that is scattered evenly");
    rows.number("highlight", "highlight k", m.highlight, {0, end_for(m.highlight, 1)},
                "k: how strong the highlight is");
    rows.number("shininess", "shininess n", m.shininess, {1, end_for(m.shininess, 1000), "%.3g", true},
                "n: how small and sharp the highlight is, (n·h)ⁿ");
    rows.number("reflectivity", "reflectivity", m.reflectivity, {0, end_for(m.reflectivity, 1)},
                "ρ: how much of what the mirror ray sees is added");
    rows.number("transparency", "transparency", m.transparency, {0, 1},
                "τ: how much of what lies behind is added; the rest of the local light stays");
    if (m.transparency > 0) {
        rows.number("index", "index", m.index, {1, end_for(m.index, 2.5)}, "η: the index of refraction");
        rows.place("absorption", "absorption", m.absorption, 0.002,
                   "σ: light lost inside, per unit of way and channel");
        rows.check("fresnel", "fresnel", m.fresnel, "mirror and refracted ray share by Fresnel's equations");
    }
    rows.place("emission", "emission", m.emission, 0.005, "light that the surface gives of itself");
}

struct LightRows {
    Rows& rows;
    double step;
    std::optional<double> radiant; ///< where the file gives the radiant intensity

    void operator()(const AmbientLight& l) const {
        rows.color("color", "color", l.color, "A: light from everywhere");
    }
    void operator()(const PointLight& l) const {
        rows.place("position", "position", l.position, step, "");
        rows.color("color", "color", l.color, "");
        intensity(l.intensity);
    }
    void operator()(const DirectionalLight& l) const {
        rows.place("direction", "direction", l.direction, 0.005, "the way the light travels");
        rows.color("color", "color", l.color, "");
        rows.number("irradiance", "irradiance", l.irradiance, {0, end_for(l.irradiance * 2, 1)},
                    "a white matte surface facing the light shows this");
    }
    void operator()(const SpotLight& l) const {
        rows.place("position", "position", l.position, step, "");
        rows.place("direction", "direction", l.direction, 0.005, "the way the light travels");
        rows.number("angle", "angle", l.angle, {1, 90, "%.3g°"}, "half angle of the cone");
        rows.number("blend", "blend", l.blend, {0, 1}, "the share of the cone over which it fades");
        rows.color("color", "color", l.color, "");
        intensity(l.intensity);
    }

  private:
    /// By the one of its two names that the file uses.
    void intensity(double value) const {
        if (radiant)
            rows.number("radiant_intensity", "radiant int.", *radiant, {0, end_for(*radiant * 2, 1)},
                        "W/sr; π is what an intensity of 1 is");
        else
            rows.number("intensity", "intensity", value, {0, end_for(value * 2, 1)},
                        "a white matte surface facing the light at distance 1 shows this");
    }
};

/// Marks the section that comes next, of this name, where it is picked, and opens it where that is new.
class Mark {
  public:
    Mark(const Ui& ui, const std::string& name, bool is_picked, bool is_new) : is_picked_(is_picked) {
        if (!is_picked) return;
        const Tint& accent = ui.theme.accent;
        ImGui::PushStyleColor(ImGuiCol_Header, ImVec4(accent.red, accent.green, accent.blue, 0.35f));
        // What follows ### is all that names a section.
        if (is_new) ImGui::GetStateStorage()->SetBool(ImGui::GetID(("###" + name).c_str()), true);
    }
    ~Mark() {
        if (is_picked_) ImGui::PopStyleColor();
    }
    Mark(const Mark&) = delete;
    Mark& operator=(const Mark&) = delete;

  private:
    bool is_picked_;
};

void materials(Ui& ui, const SceneDescription& scene, const Picked& picked, std::vector<Edit>& edits) {
    heading(ui, "Materials");
    for (const Material& material : scene.materials) {
        const std::string table = "material." + material.name;
        const Mark mark(ui, table, picked.is(material), picked.is_new);
        if (picked.is_new && picked.is(material)) ImGui::SetScrollHereY(0);
        if (!section(ui, table, material.name, scene.materials.size() <= 2, &material.color)) continue;
        material_rows(ui, material, edits);
        ImGui::Spacing();
    }
}

const Vec3* color_of(const SceneDescription& scene, const std::string& material) {
    for (const Material& m : scene.materials)
        if (m.name == material) return &m.color;
    return nullptr;
}

void objects(Ui& ui, const SceneDescription& scene, double size, const FileKeys& keys, const Picked& picked,
             std::vector<Edit>& edits) {
    heading(ui, "Objects");
    std::array<std::size_t, std::variant_size_v<Shape>> counts{};
    // A thousand headings would cost more than the picture: the clipper draws what is seen of the closed
    // ones.
    constexpr std::size_t most = 300;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const std::string table = table_of(object, counts[object.shape.index()]++);
        if (i >= most) continue;
        const Mark mark(ui, table, picked.object == i, picked.is_new);
        const std::string label = object_label(scene, i) + (object.visible ? "" : "  (hidden)");
        if (!section(ui, table, label, false, color_of(scene, object.material))) continue;
        object_rows(ui, scene, object, table, size / 500, keys, edits);
        ImGui::Spacing();
    }
    if (scene.objects.size() > most)
        quiet_text(ui, "and " + std::to_string(scene.objects.size() - most) + " more, in the scene file");
}

void lights(Ui& ui, const SceneDescription& scene, double size, const FileKeys& keys,
            std::vector<Edit>& edits) {
    heading(ui, "Lights");
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        const std::string table = "light." + std::to_string(i);
        const Vec3 color = std::visit([](const auto& kind) { return kind.color; }, light.kind);
        if (!section(ui, table, light_label(scene, i), scene.lights.size() == 1, &color)) continue;
        Rows rows(ui, edits, table);
        const std::vector<double>& radiant = keys.numbers(table + ".radiant_intensity");
        std::visit(
            LightRows{rows, size / 500, radiant.empty() ? std::nullopt : std::optional(radiant.front())},
            light.kind);
        ImGui::Spacing();
    }
}

} // namespace

void scene_panel(Ui& ui, const SceneDescription& scene, double size, const FileKeys& keys, Picked& picked,
                 std::vector<Edit>& edits) {
    materials(ui, scene, picked, edits);
    lights(ui, scene, size, keys, edits);
    objects(ui, scene, size, keys, picked, edits);
    picked.is_new = false;
}

} // namespace glint::viewer
