// Validation of descriptions.

#include "scene/validate.h"

#include "glint/scene.h"
#include "math/vec.h"
#include "scene/keys/check.h"
#include "scene/names.h"
#include "scene/shapes/shapes.h"
#include "scene/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace glint::scene {
namespace {

class Checker {
  public:
    explicit Checker(const SceneDescription& description) : scene_(description), names_(description) {}

    std::vector<Diagnostic> run(Shapes shapes) {
        for_settings(scene_,
                     [&](std::string_view name, const auto& settings) { check_keys(name, settings, {}); });
        if (scene_.camera) check_camera(*scene_.camera);
        for (const Material& material : scene_.materials) check_material(material);
        for (const Object& object : scene_.objects) check_object(object, shapes);
        for (const Light& light : scene_.lights) check_light(light);
        return std::move(found_);
    }

  private:
    void fail(const Location& where, std::string message, std::string hint = {}) {
        found_.push_back({Severity::error, where, std::move(message), std::move(hint), {}});
    }
    void require(bool good, const Location& where, const char* message, const char* hint) {
        if (!good) fail(where, message, hint);
    }
    void fail(const Location& where, KeyFault fault, const std::string& table) {
        // Descriptions made in memory have no source positions: name the table.
        fail(where, std::move(fault.message), fault.hint.empty() ? "in " + table : std::move(fault.hint));
    }

    /// The value of the table's selector; empty if it has none or a wrong one.
    static std::string type_of(const TableSpec& table, const KeyOwner& owner) {
        const KeySpec* selector = find_key(table, table.selector, {});
        if (selector == nullptr) return {};
        const KeyValue value = selector->get(owner);
        return fault_of(*selector, value) ? "" : plain_text(*selector, value);
    }

    /// Checks each value by its key. Names may be empty here, unlike in files.
    template <class T>
    void check_keys(std::string_view name, const T& owner, const Location& where,
                    std::string_view label = {}) {
        const TableSpec& table = description_table(name);
        const std::string type = type_of(table, KeyOwner(owner));
        for (const KeySpec& key : table.keys) {
            // Of rows for one member that of the type.
            const KeySpec* row = find_key(table, key.key, type);
            if (row == nullptr) row = find_key(table, key.key, {});
            if (!key.get || row != &key || key.type == KeyType::text || key.type == KeyType::file) continue;
            if (auto fault = fault_of(key, key.get(KeyOwner(owner))))
                fail(where, *std::move(fault), table.header(label));
        }
    }

    void check_camera(const CameraDescription& camera) {
        const std::size_t before = found_.size();
        check_keys("camera", camera, camera.where);
        if (found_.size() > before) return;
        if (auto fault = view_fault(camera)) fail(camera.where, *std::move(fault), "[camera]");
    }

    void check_material(const Material& material) {
        check_keys("material", material, material.where, material.name);
        if (scene_.whitted.energy != Energy::balanced) return;
        if (auto fault = balance_fault(material)) fail(material.where, *std::move(fault), "[material]");
    }

    void check_object(const Object& object, Shapes shapes) {
        if (names_.material_of(object) == nullptr) fail_material(object);
        if (shapes == Shapes::checked) return;
        const std::size_t before = found_.size();
        check_keys(name_of(object.shape), object, object.where);
        if (found_.size() == before)
            std::visit([&](const auto& shape) { check_shape(shape, object); }, object.shape);
    }

    void fail_material(const Object& object) {
        std::vector<std::string> names;
        for (const Material& m : scene_.materials) names.push_back(m.name);
        const KeyFault fault = unknown_material(object.material);
        fail(object.where, fault.message, did_you_mean(object.material, names, fault.hint));
    }

    void check_shape(const MeshShape& s, const Object& o) {
        require(s.data != nullptr, o.where, "the mesh is not loaded",
                "load_scene() does, or set MeshShape::data");
        if (s.data != nullptr) check_indices(*s.data, o);
    }
    void check_shape(const InstanceShape& s, const Object& o) {
        require(names_.mesh(s.mesh) != nullptr, o.where, "the instance names no mesh of the scene",
                "give the mesh a name and use that");
    }
    template <class Other>
    void check_shape(const Other& s, const Object& o) {
        if (auto fault = shape_fault(s))
            fail(o.where, *std::move(fault), "[[" + std::string(name_of(o.shape)) + "]]");
    }

    void check_indices(const Mesh& mesh, const Object& o) {
        glm::uint highest = 0;
        for (const glm::uvec3& t : mesh.triangles)
            highest = glm::max(highest, glm::max(t.x, glm::max(t.y, t.z)));
        const bool inside = mesh.triangles.empty() || highest < mesh.positions.size();
        require(inside, o.where, "a vertex index of the mesh is out of range", "indices count from 0");
        const std::size_t vertices = mesh.positions.size();
        require((mesh.normals.empty() || mesh.normals.size() == vertices) &&
                    (mesh.colors.empty() || mesh.colors.size() == vertices),
                o.where, "the mesh has not one normal and one colour a vertex",
                "as many as positions, or none");
        require(!inside || has_valid_positions(mesh), o.where, "a vertex of the mesh is not finite",
                "coordinates of what is shown must be finite");
    }
    // Vertices that no face uses do not matter.
    static bool has_valid_positions(const Mesh& mesh) {
        const auto is_valid = [](const glm::vec3& p) {
            return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
        };
        if (mesh.triangles.empty())
            return std::all_of(mesh.positions.begin(), mesh.positions.end(), is_valid);
        return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const glm::uvec3& t) {
            return is_valid(mesh.positions[t.x]) && is_valid(mesh.positions[t.y]) &&
                   is_valid(mesh.positions[t.z]);
        });
    }

    void check_light(const Light& light) {
        const std::size_t before = found_.size();
        check_keys("light", light, light.where);
        if (found_.size() == before)
            check_strength(std::visit([](const auto& kind) { return kind.strength(); }, light.kind),
                           light.where);
    }
    /// Lights are summed in single precision.
    void check_strength(const Vec3& strength, const Location& where) {
        constexpr double limit = std::numeric_limits<float>::max();
        require(largest(strength) <= limit, where, "the light is too strong",
                "color times intensity goes up to 3.4e38");
    }

    const SceneDescription& scene_;
    NameIndex names_;
    std::vector<Diagnostic> found_;
};

} // namespace

std::vector<Diagnostic> find_errors(const SceneDescription& description, Shapes shapes) {
    return Checker(description).run(shapes);
}

void require_valid(const SceneDescription& description, Shapes shapes) {
    std::vector<Diagnostic> errors = find_errors(description, shapes);
    if (!errors.empty()) throw Error(ErrorKind::input, std::move(errors));
}

} // namespace glint::scene
