// Warnings about valid but suspicious scenes.

#include "geometry/mesh.h"
#include "geometry/point_cloud.h"
#include "glint/keys.h"
#include "math/trig.h"
#include "scene/hidden_solids.h"
#include "scene/names.h"
#include "scene/scene_data.h"
#include "scene/text.h"
#include "scene/validate.h"
#include "scene/walls.h"
#include "shading/light_gain.h"

#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace glint {
namespace {

class WarningFinder {
  public:
    explicit WarningFinder(const scene::SceneData& scene)
        : scene_(scene), description_(scene.description),
          paths_(traces_paths(scene.description.render.integrator)), numbers_(object_numbers(description_)) {}

    std::vector<Diagnostic> run() {
        const bool shows_light = paths_ || description_.render.integrator == Integrator::whitted;
        if (shows_light) check_lights();
        if (paths_) check_light_of_paths();
        check_camera();
        check_walls();
        check_precision();
        check_framing();
        if (shows_light) check_light_model();
        return std::move(found_);
    }

  private:
    void warn(const Location& where, std::string message, std::string hint) {
        found_.push_back({Severity::warning, where, std::move(message), std::move(hint), {}});
    }
    const Object& object(std::uint32_t id) const { return description_.objects[id]; }
    std::string title(const Object& object) const {
        return object_label(object,
                            numbers_[static_cast<std::size_t>(&object - description_.objects.data())]);
    }
    bool glass(std::uint32_t id) const {
        return object(id).visible && scene_.materials[scene_.objects[id].material].transparency > 0;
    }

    void check_light_model() {
        for (const Material& m : description_.materials) {
            check_gain(m);
            check_opacity(m);
        }
        check_open_glass();
        if (scene_.any_transparent) check_hidden();
        if (!paths_) check_branching();
    }

    void check_lights() {
        if (description_.lights.empty()) {
            const bool glows = std::any_of(description_.materials.begin(), description_.materials.end(),
                                           [](const Material& m) { return m.emission != Vec3(0); });
            const bool sky = paths_ && description_.render.background != Vec3(0);
            if (!glows && !sky)
                warn({}, "the scene has no light: everything will be black", "add a [[light]]");
        }
        for (std::size_t i = 0; i < description_.lights.size(); ++i) {
            const Light& light = description_.lights[i];
            const KeySpec* position = find_key(description_table("light"), "position", name_of(light));
            if (position) check_inside(std::get<Vec3>(position->get(KeyOwner(light))), i);
        }
    }

    // What paths read in another way than Whitted's model.
    void check_light_of_paths() {
        for (const Light& light : description_.lights)
            if (std::holds_alternative<AmbientLight>(light.kind))
                warn(light.where, "path tracing leaves ambient lights out: light from everywhere is indirect",
                     "remove it, or brighten the background");
        for (std::uint32_t id = 0; id < scene_.objects.size(); ++id) {
            const bool emits = scene_.materials[scene_.objects[id].material].emission != vec3(0.0f);
            if (object(id).visible && emits && std::holds_alternative<PlaneShape>(object(id).shape))
                warn(object(id).where,
                     title(object(id)) + " emits light and is infinite: paths find its light by chance alone",
                     "a rectangle or a disk is sampled as a light, with less noise");
        }
    }

    // Without glass it is not known which meshes are closed: find out for those around the position.
    std::vector<std::uint32_t> everything_around(const Vec3& position) {
        std::vector<std::uint32_t> around = scene::objects_around(scene_, vec3(position));
        if (scene_.any_transparent) return around;
        for (const std::uint32_t id : scene::surfaces_around(scene_, vec3(position)))
            if (const Mesh* mesh = mesh_of(id); mesh != nullptr && is_closed(*mesh)) around.push_back(id);
        return around;
    }
    bool is_closed(const Mesh& mesh) {
        const auto [known, is_new] = closed_.try_emplace(&mesh);
        if (is_new) known->second = geometry::is_closed(mesh.positions, mesh.triangles);
        return known->second;
    }
    const Mesh* mesh_of(std::uint32_t id) const {
        if (const auto* mesh = std::get_if<MeshShape>(&object(id).shape)) return mesh->data.get();
        const auto* instance = std::get_if<InstanceShape>(&object(id).shape);
        if (instance == nullptr) return nullptr;
        return std::get<MeshShape>(names_.mesh(instance->mesh)->shape).data.get();
    }

    // The light of a lamp in glass shines through it.
    void check_inside(const Vec3& position, std::size_t light) {
        const bool shines_through = paths_ ? description_.path.shadows == PathShadows::transmissive
                                           : description_.whitted.shadows == Shadows::transmissive;
        for (const std::uint32_t id : everything_around(position))
            if (!glass(id) || !shines_through)
                warn(description_.lights[light].where,
                     light_label(description_, light) + " is inside " + title(object(id)),
                     "what is outside will be in its shadow; move the light out if that is not meant");
    }

    void check_walls() {
        if (const auto wall = scene::wall_before_camera(scene_))
            warn(description_.camera->where, "the camera sees nothing but " + title(object(*wall)),
                 "it hides the objects behind it; move the camera to their side");
        std::vector<std::size_t> numbers; // of the lights that scene_.lights has
        for (std::size_t i = 0; i < description_.lights.size(); ++i)
            if (!std::holds_alternative<AmbientLight>(description_.lights[i].kind)) numbers.push_back(i);
        for (const scene::ShutLight& shut : scene::lights_behind_walls(scene_)) {
            const std::size_t light = numbers[shut.light];
            warn(description_.lights[light].where,
                 light_label(description_, light) +
                     " lights nothing that the camera sees: " + title(object(shut.wall)) + " is in between",
                 "move the light to the camera's side of it");
        }
    }

    void check_camera() {
        const CameraDescription& camera = *description_.camera;
        for (const std::uint32_t id : everything_around(camera.eye))
            warn(camera.where, "the camera is inside " + title(object(id)),
                 "move it out if that is not meant");
    }

    // Single precision rounds coordinates about the origin of the world, double those of the scene.
    void check_precision() {
        constexpr double visible = 0.1; // pixels
        const CameraDescription& camera = *description_.camera;
        const RenderSettings& r = description_.render;
        const double a_pixel = 2 * tan_degrees(camera.fov / 2) / fov_side(camera.fov_axis, r.width, r.height);
        for (std::uint32_t id = 0; id < scene_.objects.size(); ++id) {
            const Bounds& box = scene_.objects[id].core;
            if (box.empty()) continue;
            const dvec3 middle = (dvec3(box.lo) + dvec3(box.hi)) / 2.0;
            const double radius = glm::length(dvec3(box.extent())) / 2;
            const double error =
                (largest(middle) + largest(camera.eye)) * 0x1p-24 + largest(middle + scene_.origin) * 0x1p-52;
            const double pixels = error / (std::max(glm::length(middle - camera.eye), radius) * a_pixel);
            if (!(pixels > visible)) continue;
            warn(
                object(id).where,
                "precision moves " + title(object(id)) + " by up to " + scene::rounded(error) + ", about " +
                    scene::rounded(pixels) + " pixels: the scene is large compared with it",
                "move it and the camera nearer to the middle of the scene, or leave out objects that are far "
                "from the others");
        }
    }

    std::ptrdiff_t outliers_of(const Mesh& mesh) {
        const auto [known, is_new] = outliers_.try_emplace(&mesh);
        if (is_new) {
            const Bounds kept = geometry::cloud_without_outliers(mesh.positions);
            known->second =
                std::ranges::count_if(mesh.positions, [&](const glm::vec3& p) { return !kept.contains(p); });
        }
        return known->second;
    }

    void check_framing() {
        if (scene_.has_own_camera) return;
        for (std::uint32_t id = 0; id < scene_.objects.size(); ++id) {
            const Mesh* mesh = object(id).visible ? mesh_of(id) : nullptr;
            if (mesh == nullptr || !mesh->triangles.empty()) continue;
            const auto outliers = outliers_of(*mesh);
            if (outliers == 0) continue;
            warn(object(id).where,
                 std::to_string(outliers) + " of the " + std::to_string(mesh->positions.size()) +
                     " points of " + title(object(id)) + " lie far from the others and are not framed",
                 "remove them from its file, or add a [camera]");
        }
    }

    // More light leaves than arrives.
    void check_gain(const Material& m) {
        if (m.model != MaterialModel::whitted) return;
        const double brightest = std::max({m.color.x, m.color.y, m.color.z});
        const bool balanced = description_.whitted.energy == Energy::balanced;
        const double gain =
            shading::light_gain(brightest, m.diffuse, m.reflectivity, m.transparency, balanced);
        if (gain <= 1.0000001 || description_.whitted.energy_chosen) return;
        char number[32];
        std::snprintf(number, sizeof number, "%.2f", gain);
        warn(m.where, "material \"" + m.name + "\" gives " + number + " times the light that it gets",
             "lower diffuse, reflectivity or transparency, or set energy = \"balanced\" in [whitted]; "
             "\"report\" there says that it is meant");
    }

    void check_opacity(const Material& m) {
        if (m.opacity == 1) return;
        warn(m.where, "material \"" + m.name + "\" is drawn opaque: Whitted's light model reads no opacity",
             "use transparency instead, or another integrator");
    }

    void check_open_glass() {
        for (std::uint32_t id = 0; id < scene_.objects.size(); ++id) {
            const bool mesh = std::holds_alternative<MeshShape>(object(id).shape) ||
                              std::holds_alternative<InstanceShape>(object(id).shape);
            if (mesh && glass(id) && !scene_.objects[id].solid) warn_of_panes(id);
        }
    }

    void warn_of_panes(std::uint32_t id) {
        const Mesh& mesh = *mesh_of(id);
        if (geometry::has_no_holes(mesh.positions, mesh.triangles))
            warn(object(id).where,
                 title(object(id)) + " is made of glass, but not all its faces are wound alike",
                 "its faces are drawn as thin panes; turn the faces that are the wrong way round for a solid "
                 "that refracts");
        else
            warn(object(id).where, title(object(id)) + " is made of glass but is not closed",
                 "its faces are drawn as thin panes; close its holes for a solid that refracts");
    }

    void check_hidden() {
        for (const scene::HiddenSolid& hidden : scene::find_hidden_solids(scene_))
            warn(object(hidden.object).where,
                 title(object(hidden.object)) + " is hidden inside " + title(object(hidden.owner)) +
                     ", which owns the space",
                 "move it behind that object in the file, or give it a higher priority");
    }

    // Where a ray meets glass it may branch in two; where mirrors send all branches back it does again.
    void check_branching() {
        constexpr int harmless_depth = 16;
        const int depth = description_.whitted.max_depth;
        const bool ends_by_weight = description_.whitted.min_weight >= WhittedSettings{}.min_weight;
        if (depth <= harmless_depth || ends_by_weight || !scene_.any_transparent) return;
        Bounds branching;
        const Object* glass_object = nullptr;
        for (std::uint32_t id = 0; id < scene_.objects.size(); ++id) {
            if (!glass(id) || !branches(id)) continue;
            if (glass_object == nullptr) glass_object = &object(id);
            branching.grow(scene_.objects[id].bounds);
        }
        if (glass_object == nullptr || !is_among_mirrors(branching)) return;
        const std::string number = std::to_string(depth);
        warn(glass_object->where,
             "max_depth = " + number + " lets rays that branch at " + title(*glass_object) +
                 " among mirrors become up to 2^" + number + " a sample",
             "leave min_weight in [whitted] at its default, or lower max_depth; 8 to " +
                 std::to_string(harmless_depth) + " are enough for most");
    }

    bool branches(std::uint32_t id) const {
        const MaterialRecord& m = scene_.materials[scene_.objects[id].material];
        return m.reflectivity > 0 || (m.flags & material_fresnel) != 0;
    }

    // Between two mirrors, or inside of one.
    bool is_among_mirrors(const Bounds& box) const {
        int mirrors = 0;
        for (std::uint32_t id = 0; id < scene_.objects.size(); ++id) {
            const bool mirror = scene_.materials[scene_.objects[id].material].reflectivity > 0;
            if (!object(id).visible || glass(id) || !mirror) continue;
            const Bounds& around = scene_.objects[id].bounds;
            const bool surrounds = glm::all(glm::lessThanEqual(around.lo, box.lo)) &&
                                   glm::all(glm::lessThanEqual(box.hi, around.hi));
            mirrors += surrounds ? 2 : 1;
        }
        return mirrors >= 2;
    }

    const scene::SceneData& scene_;
    const SceneDescription& description_;
    const bool paths_;                   ///< the picture is path traced
    std::vector<std::uint32_t> numbers_; ///< of the objects
    std::vector<Diagnostic> found_;
    const scene::NameIndex names_{description_};
    // Of the meshes that were looked at, each once for all objects that show it.
    std::map<const Mesh*, bool> closed_;
    std::map<const Mesh*, std::ptrdiff_t> outliers_;
};

} // namespace

std::vector<Diagnostic> warnings(const Scene& scene) { return WarningFinder(scene.data()).run(); }

} // namespace glint
