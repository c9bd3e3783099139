// Checks across tables of a scene.

#include "formats/scene/read.h"
#include "glint/limits.h"
#include "math/vec.h"
#include "scene/keys/check.h"
#include "scene/names.h"
#include "scene/shapes/shapes.h"
#include "scene/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace glint::formats {

using scene::in_quotes;
using scene::ShapeBox;

namespace {

constexpr std::size_t enough_candidates = 2000;

bool within_limits(const ShapeBox& box, const Mat4& transform) {
    if (box.empty()) return true;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p{corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y,
                     corner & 4 ? box.hi.z : box.lo.z};
        // Negated comparison, so that NaN is out of range.
        if (!(largest(Vec3(transform * glm::dvec4(p, 1))) <= coordinate_limit)) return false;
    }
    return true;
}

Mat4 scaling(const Vec3& scale) {
    Mat4 m{1};
    for (int i = 0; i < 3; ++i) m[i][i] = scale[i];
    return m;
}

class SceneCheck {
  public:
    SceneCheck(const ReadScene& scene, Problems& problems)
        : scene_(scene), description_(scene.description), names_(description_), problems_(problems) {}

    void run() {
        gather_candidates();
        for (std::size_t i = 0; i < description_.objects.size(); ++i) {
            check_references(description_.objects[i], scene_.objects[i]);
            check_geometry(description_.objects[i], scene_.objects[i]);
        }
        for (std::size_t i = 0; i < description_.lights.size(); ++i)
            check_name("light", description_.lights[i].name, scene_.lights[i]);
        check_energy();
    }

    void check_meshes() {
        for (std::size_t i = 0; i < description_.objects.size(); ++i)
            check_mesh_extent(description_.objects[i], scene_.objects[i]);
    }

  private:
    /// Names to suggest.
    void gather_candidates() {
        for (const Material& material : description_.materials)
            if (material_names_.size() < enough_candidates) material_names_.push_back(material.name);
        for (const Object& object : description_.objects)
            if (std::holds_alternative<MeshShape>(object.shape) && !object.name.empty() &&
                mesh_names_.size() < enough_candidates)
                mesh_names_.push_back(object.name);
    }

    void check_name(const std::string& table, const std::string& name, const SourcePos& pos) {
        if (name.empty()) return;
        const auto [first, is_new] = named_.emplace(std::pair(table, name), pos);
        if (!is_new)
            problems_.error(pos, "another " + table + " is named " + in_quotes(name),
                            first->second.line > 0
                                ? "the first is named on line " + std::to_string(first->second.line)
                                : "names are unique within a type of table");
    }

    void check_references(const Object& object, const ObjectPositions& positions) {
        check_name(positions.table, object.name, positions.name);
        if (!object.material.empty() && names_.material_of(object) == nullptr) {
            const scene::KeyFault fault = scene::unknown_material(object.material);
            problems_.error(positions.material, fault.message,
                            problems_.suggestion(object.material, material_names_, fault.hint));
        }
        const auto* instance = std::get_if<InstanceShape>(&object.shape);
        if (instance && !instance->mesh.empty() && names_.mesh(instance->mesh) == nullptr)
            problems_.error(
                positions.shape, "unknown mesh " + in_quotes(instance->mesh),
                problems_.suggestion(instance->mesh, mesh_names_, "expected the name of a [[mesh]]"));
    }

    void check_geometry(const Object& object, const ObjectPositions& positions) {
        if (!positions.good) return;
        if (auto fault =
                std::visit([](const auto& shape) { return scene::shape_fault(shape); }, object.shape))
            return problems_.error(positions.shape, std::move(fault->message), std::move(fault->hint));
        if (std::holds_alternative<MeshShape>(object.shape)) return;
        const ShapeBox around = std::visit([](const auto& shape) { return scene::box(shape); }, object.shape);
        if (!within_limits(around, Mat4{1}))
            report_limit(positions.shape, object, "reaches");
        else if (!within_limits(around, object.transform))
            report_limit(positions.transform, object, "is moved");
    }

    void check_mesh_extent(const Object& object, const ObjectPositions& positions) {
        const Object* mesh_object = &object;
        Mat4 whole{1};
        if (const auto* instance = std::get_if<InstanceShape>(&object.shape)) {
            mesh_object = names_.mesh(instance->mesh);
            if (!mesh_object) return;
            whole = object.transform;
        }
        const auto* mesh = std::get_if<MeshShape>(&mesh_object->shape);
        if (!mesh || !mesh->data) return;
        whole = whole * mesh_object->transform * scaling(mesh->scale);
        if (!within_limits(box_of(*mesh->data, *mesh), whole))
            report_limit(positions.shape, object, "reaches");
    }

    /// Bounds of a mesh, computed once for all its instances.
    const ShapeBox& box_of(const Mesh& data, const MeshShape& mesh) {
        const auto [entry, is_new] = boxes_.try_emplace(&data);
        if (is_new) entry->second = scene::box(mesh);
        return entry->second;
    }

    void report_limit(const SourcePos& pos, const Object& object, const char* verb) {
        const std::string who = object.name.empty() ? "the object" : in_quotes(object.name);
        problems_.error(pos, who + " " + verb + " beyond 10^12 scene units", "coordinates are within ±10^12");
    }

    void check_energy() {
        if (description_.whitted.energy != Energy::balanced) return;
        for (std::size_t i = 0; i < description_.materials.size(); ++i)
            if (auto fault = scene::balance_fault(description_.materials[i]))
                problems_.error(scene_.materials[i], std::move(fault->message), std::move(fault->hint));
    }

    const ReadScene& scene_;
    const SceneDescription& description_;
    scene::NameIndex names_;
    Problems& problems_;
    std::vector<std::string> material_names_;
    std::vector<std::string> mesh_names_;
    std::map<std::pair<std::string, std::string>, SourcePos> named_; ///< by table and name
    std::map<const Mesh*, ShapeBox> boxes_;
};

} // namespace

void check_scene(const ReadScene& scene, Problems& problems) { SceneCheck(scene, problems).run(); }

void check_mesh_extents(const ReadScene& scene, Problems& problems) {
    SceneCheck(scene, problems).check_meshes();
}

} // namespace glint::formats
