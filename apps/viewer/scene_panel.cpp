#include "scene_panel.h"

#include "key_rows.h"
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

void material_rows(Ui& ui, const Material& m, const std::string& path, const FileKeys& file,
                   std::vector<Edit>& edits) {
    const TableSpec& table = description_table("material");
    KeyRows rows(ui, edits, path, table, KeyOwner(m), share_step, file);
    for (const KeySpec& key : table.keys) {
        const bool of_glass = key.key == "index" || key.key == "absorption" || key.key == "fresnel";
        if (of_glass && m.transparency == 0) continue;
        if (key.key == "emission")
            rows.numbers(key);
        else
            rows.row(key);
    }
}

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

void materials(Ui& ui, const SceneDescription& scene, const FileKeys& file, const Picked& picked,
               std::vector<Edit>& edits) {
    heading(ui, "Materials");
    for (const Material& material : scene.materials) {
        const std::string table = "material." + material.name;
        const Mark mark(ui, table, picked.is(material), picked.is_new);
        if (picked.is_new && picked.is(material)) ImGui::SetScrollHereY(0);
        if (!section(ui, table, material.name, scene.materials.size() <= 2, &material.color)) continue;
        material_rows(ui, material, table, file, edits);
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
        KeyRows rows(ui, edits, table, description_table("light"), KeyOwner(light), size / 500, keys);
        for (const KeySpec& key : description_table("light").keys)
            if (key.key != "type") rows.row(key);
        ImGui::Spacing();
    }
}

} // namespace

void scene_panel(Ui& ui, const SceneDescription& scene, double size, const FileKeys& keys, Picked& picked,
                 std::vector<Edit>& edits) {
    materials(ui, scene, keys, picked, edits);
    lights(ui, scene, size, keys, edits);
    objects(ui, scene, size, keys, picked, edits);
    picked.is_new = false;
}

} // namespace glint::viewer
