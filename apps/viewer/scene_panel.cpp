#include "scene_panel.h"

#include "glint/explain.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace glint::viewer {
namespace {

constexpr std::array shape_words{"plane", "sphere", "cylinder", "triangle", "polyhedron", "mesh", "instance"};

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

std::vector<std::string> material_names(const SceneDescription& scene) {
    std::vector<std::string> names;
    for (const Material& material : scene.materials) names.push_back(material.name);
    return names;
}

/// The rows of one shape each.
struct ShapeRows {
    Rows& rows;
    double step;

    void operator()(const PlaneShape& s) const {
        rows.place("normal", "normal", s.normal, 0.005, "at right angles to the plane; of any length");
        rows.length("offset", "offset", s.offset, step, "normal · p = offset");
    }
    void operator()(const SphereShape& s) const {
        rows.place("center", "center", s.center, step, "");
        rows.length("radius", "radius", s.radius, step, "");
    }
    void operator()(const CylinderShape& s) const {
        rows.place("base", "base", s.base, step, "centre of the bottom disc");
        rows.place("axis", "axis", s.axis, 0.005, "the way up; of any length");
        rows.length("height", "height", s.height, step, "");
        rows.length("radius", "radius", s.radius, step, "");
    }
    void operator()(const TriangleShape&) const {}
    void operator()(const PolyhedronShape& s) const {
        rows.place("center", "center", s.center, step, "");
        if (s.kind == PolyhedronKind::box) {
            rows.place("size", "size", s.size, step, "lengths of the edges");
            return;
        }
        rows.length("radius", "radius", s.radius, step, "of the circumscribed sphere");
        if (s.kind != PolyhedronKind::prism && s.kind != PolyhedronKind::pyramid) return;
        rows.whole("sides", "sides", s.sides, 3, std::max(s.sides, 24), "");
        rows.length("height", "height", s.height, step, "");
        rows.place("axis", "axis", s.axis, 0.005, "the way up; of any length");
    }
    void operator()(const MeshShape& s) const {
        constexpr std::array words{"auto", "flat", "smooth"};
        rows.choice("normals", "normals", words[static_cast<std::size_t>(s.normals)],
                    {words.begin(), words.end()}, "the mesh's own, one a triangle, or smooth ones");
    }
    void operator()(const InstanceShape&) const {}
};

struct LightRows {
    Rows& rows;
    double step;

    void operator()(const AmbientLight& l) const {
        rows.color("color", "color", l.color, "A: light from everywhere");
    }
    void operator()(const PointLight& l) const {
        rows.place("position", "position", l.position, step, "");
        rows.color("color", "color", l.color, "");
        strength("intensity", l.intensity);
    }
    void operator()(const DirectionalLight& l) const {
        rows.place("direction", "direction", l.direction, 0.005, "the way the light travels");
        rows.color("color", "color", l.color, "");
        strength("irradiance", l.irradiance);
    }
    void operator()(const SpotLight& l) const {
        rows.place("position", "position", l.position, step, "");
        rows.place("direction", "direction", l.direction, 0.005, "the way the light travels");
        rows.number("angle", "angle", l.angle, {1, 90, "%.3g°"}, "half angle of the cone");
        rows.number("blend", "blend", l.blend, {0, 1}, "the share of the cone over which it fades");
        rows.color("color", "color", l.color, "");
        strength("intensity", l.intensity);
    }

  private:
    void strength(const char* key, double value) const {
        rows.number(key, key, value, {0, end_for(value * 2, 1)},
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

/// How -D names an object: by its name, else by its number among its kind.
std::string table_of(const Object& object, std::size_t number_in_kind) {
    const std::string kind = shape_words[object.shape.index()];
    return kind + "." + (object.name.empty() ? std::to_string(number_in_kind) : object.name);
}

void objects(Ui& ui, const SceneDescription& scene, double size, const Picked& picked,
             std::vector<Edit>& edits) {
    heading(ui, "Objects");
    const std::vector<std::string> names = material_names(scene);
    std::array<std::size_t, shape_words.size()> counts{};
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
        Rows rows(ui, edits, table);
        rows.choice("material", "material", object.material, names, "");
        rows.check("visible", "visible", object.visible, "hidden ones are gone for all rays");
        std::visit(ShapeRows{rows, size / 500}, object.shape);
        ImGui::Spacing();
    }
    if (scene.objects.size() > most)
        quiet_text(ui, "and " + std::to_string(scene.objects.size() - most) + " more, in the scene file");
}

void lights(Ui& ui, const SceneDescription& scene, double size, std::vector<Edit>& edits) {
    heading(ui, "Lights");
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        const std::string table = "light." + std::to_string(i);
        const Vec3 color = std::visit([](const auto& kind) { return kind.color; }, light.kind);
        if (!section(ui, table, light_label(scene, i), scene.lights.size() == 1, &color)) continue;
        Rows rows(ui, edits, table);
        std::visit(LightRows{rows, size / 500}, light.kind);
        ImGui::Spacing();
    }
}

} // namespace

void scene_panel(Ui& ui, const SceneDescription& scene, double size, Picked& picked,
                 std::vector<Edit>& edits) {
    materials(ui, scene, picked, edits);
    lights(ui, scene, size, edits);
    objects(ui, scene, size, picked, edits);
    picked.is_new = false;
}

} // namespace glint::viewer
