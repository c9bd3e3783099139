#include "scene_panel.h"

#include "rows.h"
#include "scene_editor.h"

#include "glint/explain.h"
#include "glint/scene.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

namespace glint::viewer {
namespace {

/// What a pixel of dragging moves.
double step_of(const SceneEditor& editor) { return editor.extent() / 500; }

void material_rows(Ui& ui, const Material& m, const std::string& path, const FileKeys& file,
                   std::vector<Edit>& edits) {
    const TableSpec& table = description_table("material");
    Rows rows(ui, edits, path, table, KeyOwner(m), share_step, file);
    for (const KeySpec& key : table.keys) {
        const bool of_glass = key.key == "index" || key.key == "absorption" || key.key == "fresnel";
        if (of_glass && m.model == MaterialModel::whitted && m.transparency == 0) continue;
        if (key.key == "emission")
            rows.numbers(key);
        else
            rows.row(key);
    }
}

/// Marks the next section, of this name, if it is picked, and opens it if that is new.
class Mark {
  public:
    Mark(const Ui& ui, const std::string& name, bool is_picked, bool is_new) : is_picked_(is_picked) {
        if (!is_picked) return;
        ImGui::PushStyleColor(ImGuiCol_Header, color_of(ui.theme.accent, 0.35f));
        // A section's identity is what follows ###.
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

void materials(Ui& ui, const SceneEditor& editor, const Picked& picked, std::vector<Edit>& edits) {
    const std::vector<Material>& all = editor.description()->materials;
    heading(ui, "Materials");
    for (const Material& material : all) {
        const std::string table = "material." + material.name;
        const Mark mark(ui, table, picked.is(material), picked.is_new);
        if (picked.is_new && picked.is(material)) ImGui::SetScrollHereY(0);
        if (!section(ui, table, material.name, all.size() <= 2, &material.color)) continue;
        material_rows(ui, material, table, editor.keys(), edits);
        ImGui::Spacing();
    }
}

void lights(Ui& ui, const SceneEditor& editor, std::vector<Edit>& edits) {
    const SceneDescription& scene = *editor.description();
    const TableSpec& spec = description_table("light");
    heading(ui, "Lights");
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        const std::string table = "light." + std::to_string(i);
        const Vec3 color = std::visit([](const auto& kind) { return kind.color; }, light.kind);
        if (!section(ui, table, light_label(scene, i), scene.lights.size() == 1, &color)) continue;
        Rows rows(ui, edits, table, spec, KeyOwner(light), step_of(editor), editor.keys());
        for (const KeySpec& key : spec.keys)
            if (key.key != spec.selector && key.key != "name") rows.row(key);
        ImGui::Spacing();
    }
}

std::vector<std::string> material_names(const SceneDescription& scene) {
    std::vector<std::string> names;
    for (const Material& material : scene.materials) names.push_back(material.name);
    return names;
}

std::vector<std::string> mesh_names(const SceneDescription& scene) {
    std::vector<std::string> names;
    for (const Object& object : scene.objects)
        if (std::holds_alternative<MeshShape>(object.shape) && !object.name.empty())
            names.push_back(object.name);
    return names;
}

void object_rows(Ui& ui, const SceneEditor& editor, const Object& object, const std::string& table,
                 std::vector<Edit>& edits) {
    const SceneDescription& scene = *editor.description();
    const TableSpec& spec = description_table(name_of(object.shape));
    Rows rows(ui, edits, table, spec, KeyOwner(object), step_of(editor), editor.keys());
    rows.names("material", material_names(scene));
    rows.row("visible");
    if (is_solid(object.shape)) rows.row("priority");
    for (const KeySpec& key : spec.keys) {
        // The common keys follow the shape's own.
        if (key.key == "name") break;
        if (key.key == "mesh")
            rows.names(key.key, mesh_names(scene));
        else if (key.key != spec.selector)
            rows.row(key);
    }
    // Only their transform moves these.
    const bool is_mesh = std::holds_alternative<MeshShape>(object.shape) ||
                         std::holds_alternative<InstanceShape>(object.shape);
    rows.transform(is_mesh);
}

const Vec3* color_of_material(const SceneDescription& scene, const std::string& name) {
    for (const Material& material : scene.materials)
        if (material.name == name) return &material.color;
    return nullptr;
}

void objects(Ui& ui, const SceneEditor& editor, const Picked& picked, std::vector<Edit>& edits) {
    const SceneDescription& scene = *editor.description();
    heading(ui, "Objects");
    std::array<std::uint32_t, std::variant_size_v<Shape>> counts{};
    // A thousand headings would cost more than the picture.
    constexpr std::size_t max_sections = 300;
    for (std::size_t i = 0; i < std::min(scene.objects.size(), max_sections); ++i) {
        const Object& object = scene.objects[i];
        const std::uint32_t number = counts[object.shape.index()]++;
        const std::string table = table_of(object, number);
        const Mark mark(ui, table, picked.object == i, picked.is_new);
        const std::string label = object_label(object, number) + (object.visible ? "" : "  (hidden)");
        if (!section(ui, table, label, false, color_of_material(scene, object.material))) continue;
        object_rows(ui, editor, object, table, edits);
        ImGui::Spacing();
    }
    if (scene.objects.size() > max_sections)
        quiet_text(ui, fmt::format("and {} more, in the scene file", scene.objects.size() - max_sections));
}

/// Notes and warnings about the file.
void remarks(const Ui& ui, const LoadedFile& scene) {
    if (scene.warnings.empty() && scene.notes.empty()) return;
    heading(ui, "Remarks");
    for (const std::string& note : scene.notes) quiet_text(ui, note);
    for (const Diagnostic& warning : scene.warnings)
        quiet_text(ui, warning.location.line > 0
                           ? fmt::format("line {}: {}", warning.location.line, warning.message)
                           : warning.message);
}

} // namespace

void scene_panel(Ui& ui, const SceneEditor& editor, Picked& picked, std::vector<Edit>& edits) {
    materials(ui, editor, picked, edits);
    lights(ui, editor, edits);
    objects(ui, editor, picked, edits);
    picked.is_new = false;
    remarks(ui, editor.loaded());
}

} // namespace glint::viewer
