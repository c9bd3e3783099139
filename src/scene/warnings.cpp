// Warnings about valid but suspicious scenes.

#include "geometry/mesh.h"
#include "glint/keys.h"
#include "scene/scene_data.h"
#include "scene/validate.h"

#include "math/index.h"
#include "math/random.shared.h"
#include "math/trig.h"
#include "shading/light_gain.h"

#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>

namespace glint {

using trace::Hit;
namespace {

constexpr std::uint32_t probes_per_object = 64;

std::string title(const Object& object) {
    const std::string type(name_of(object.shape));
    return object.name.empty() ? type : type + " \"" + object.name + "\"";
}

std::string rounded(double x) {
    char number[32];
    std::snprintf(number, sizeof number, "%.2g", x);
    return number;
}

class WarningFinder {
  public:
    explicit WarningFinder(const scene::SceneData& scene) : scene_(scene), description_(scene.description) {
        for (std::uint32_t id = 0; id < scene.objects.size(); ++id)
            if (glass(id) && scene.objects[id].solid) glass_solids_.push_back(id);
    }

    std::vector<Diagnostic> run() {
        check_lights();
        check_camera();
        check_precision();
        for (const Material& m : description_.materials) check_gain(m);
        check_open_glass();
        if (scene_.any_transparent) check_overlaps();
        return std::move(found_);
    }

  private:
    void warn(const Location& where, std::string message, std::string hint) {
        found_.push_back({Severity::warning, where, std::move(message), std::move(hint), {}});
    }
    const Object& object(std::uint32_t id) const { return description_.objects[id]; }
    bool glass(std::uint32_t id) const {
        return object(id).visible && scene_.materials[scene_.objects[id].material].transparency > 0;
    }

    void check_lights() {
        if (description_.lights.empty()) {
            const bool glows = std::any_of(description_.materials.begin(), description_.materials.end(),
                                           [](const Material& m) { return m.emission != Vec3(0); });
            if (!glows) warn({}, "the scene has no light: everything will be black", "add a [[light]]");
        }
        for (const Light& light : description_.lights) {
            const KeySpec* position = find_key(description_table("light"), "position", name_of(light));
            if (position) check_inside(std::get<Vec3>(position->get(KeyOwner(light))), light.where);
        }
    }

    // Without glass it is not known which meshes are closed: find out for those around the position.
    std::vector<std::uint32_t> everything_around(const Vec3& position) const {
        std::vector<std::uint32_t> around = scene::objects_around(scene_, vec3(position));
        if (scene_.any_transparent) return around;
        for (const std::uint32_t id : scene::surfaces_around(scene_, vec3(position)))
            if (const Mesh* mesh = mesh_of(id);
                mesh != nullptr && geometry::is_closed(mesh->positions, mesh->triangles))
                around.push_back(id);
        return around;
    }
    const Mesh* mesh_of(std::uint32_t id) const {
        if (const auto* mesh = std::get_if<MeshShape>(&object(id).shape)) return mesh->data.get();
        const auto* instance = std::get_if<InstanceShape>(&object(id).shape);
        if (instance == nullptr) return nullptr;
        return std::get<MeshShape>(scene::find_mesh(description_, instance->mesh)->shape).data.get();
    }

    void check_inside(const Vec3& position, const Location& where) {
        for (const std::uint32_t id : everything_around(position))
            warn(where, "the light is inside " + title(object(id)),
                 "what is outside will be in its shadow; move the light out if that is not meant");
    }

    void check_camera() {
        const CameraDescription& camera = *description_.camera;
        for (const std::uint32_t id : everything_around(camera.eye))
            warn(camera.where, "the camera is inside " + title(object(id)),
                 "move it out if that is not meant");
    }

    // Coordinates have single precision: far from the origin their steps exceed what a pixel shows.
    void check_precision() {
        const CameraDescription& camera = *description_.camera;
        const RenderSettings& r = description_.render;
        const double a_pixel = 2 * tan_degrees(camera.fov / 2) / fov_side(camera.fov_axis, r.width, r.height);
        for (std::uint32_t id = 0; id < scene_.objects.size(); ++id) {
            const Bounds& box = scene_.objects[id].bounds;
            if (box.empty()) continue;
            const dvec3 middle = (dvec3(box.lo) + dvec3(box.hi)) / 2.0;
            const dvec3 far = glm::abs(middle);
            const double step = std::max({far.x, far.y, far.z}) * 0x1p-23;
            const double pixels = step / (glm::length(middle - camera.eye) * a_pixel);
            if (!(pixels > 1)) continue;
            warn(object(id).where,
                 title(object(id)) + " is so far from the origin that single precision has steps of " +
                     rounded(step) + " there, about " + rounded(pixels) + " pixels",
                 "move everything, the camera too, nearer to the origin");
        }
    }

    // More light leaves than arrives.
    void check_gain(const Material& m) {
        const double brightest = std::max({m.color.x, m.color.y, m.color.z});
        const bool balanced = description_.whitted.energy == Energy::balanced;
        const double gain =
            shading::light_gain(brightest, m.diffuse, m.reflectivity, m.transparency, balanced);
        if (gain <= 1.0000001) return;
        char number[32];
        std::snprintf(number, sizeof number, "%.2f", gain);
        warn(m.where, "material \"" + m.name + "\" gives " + number + " times the light that it gets",
             "lower diffuse, reflectivity or transparency, or set energy = \"balanced\" in [whitted]");
    }

    void check_open_glass() {
        for (std::uint32_t id = 0; id < scene_.objects.size(); ++id) {
            const bool mesh = std::holds_alternative<MeshShape>(object(id).shape) ||
                              std::holds_alternative<InstanceShape>(object(id).shape);
            if (mesh && glass(id) && !scene_.objects[id].solid)
                warn(object(id).where, title(object(id)) + " is made of glass but is not closed",
                     "its faces are drawn as thin panes; close its holes for a solid that refracts");
        }
    }

    // Samples the faces of each solid by chords of its box: is a face inside another solid that owns the
    // space, or does it coincide with a face of glass?
    void check_overlaps() {
        for (std::uint32_t id = 0; id < scene_.objects.size(); ++id) {
            if (!object(id).visible || !scene_.objects[id].solid || scene_.objects[id].bounds.empty())
                continue;
            Probe probe;
            for (std::uint32_t i = 0; i < probes_per_object; ++i) shoot(id, i, probe);
            if (probe.coincident != invalid_index)
                warn(object(id).where,
                     title(object(id)) + " and " + title(object(probe.coincident)) +
                         " have coincident glass faces",
                     "let one overlap the other a little, or leave a gap");
            if (probe.faces > 0 && probe.hidden == probe.faces)
                warn(object(id).where,
                     title(object(id)) + " is hidden inside " + title(object(probe.owner)) +
                         ", which owns the space",
                     "move it behind that object in the file, or give it a higher priority");
        }
    }

    struct Probe {
        int faces = 0;
        int hidden = 0;
        std::uint32_t coincident = invalid_index;
        std::uint32_t owner = invalid_index;
    };

    // A chord of the object's box between two points drawn by number.
    Ray chord(std::uint32_t id, std::uint32_t i) const {
        const Bounds& box = scene_.objects[id].bounds;
        vec3 ends[2];
        for (std::uint32_t e = 0; e < 2; ++e) {
            const vec2 a = sample_pair(id, i, 2 * e);
            const vec2 b = sample_pair(id, i, 2 * e + 1);
            ends[e] = box.lo + box.extent() * vec3(a.x, a.y, b.x);
        }
        Ray ray;
        ray.direction = ends[1] - ends[0];
        ray.origin = ends[0] - ray.direction * 8.0f;
        return ray;
    }

    void shoot(std::uint32_t id, std::uint32_t i, Probe& probe) {
        hits_.clear();
        const Ray ray = chord(id, i);
        scene_.world.all_hits(ray, hits_);
        for (std::size_t k = 0; k < hits_.size(); ++k) {
            if (hits_[k].object != id) continue;
            ++probe.faces;
            find_owner(id, ray.origin + ray.direction * hits_[k].t, probe);
            if (glass(id) && k + 1 < hits_.size()) find_coincident(hits_[k], hits_[k + 1], probe);
        }
    }

    void find_owner(std::uint32_t id, const vec3& p, Probe& probe) const {
        const bool near_glass =
            std::any_of(glass_solids_.begin(), glass_solids_.end(), [&](std::uint32_t other) {
                const Bounds& box = scene_.objects[other].bounds;
                return other != id && (box.empty() || (glm::all(glm::greaterThanEqual(p, box.lo)) &&
                                                       glm::all(glm::lessThanEqual(p, box.hi))));
            });
        if (!near_glass) return;
        for (const std::uint32_t around : scene::objects_around(scene_, p)) {
            if (around == id || !glass(around) || scene_.objects[around].rank < scene_.objects[id].rank)
                continue;
            ++probe.hidden;
            probe.owner = around;
            return;
        }
    }

    void find_coincident(const Hit& a, const Hit& b, Probe& probe) const {
        const bool solid_glass = glass(b.object) && scene_.objects[b.object].solid;
        if (a.object == b.object || !solid_glass) return;
        if (b.t - a.t <= a.t * 0x1p-20f) probe.coincident = b.object;
    }

    const scene::SceneData& scene_;
    const SceneDescription& description_;
    std::vector<std::uint32_t> glass_solids_;
    std::vector<Hit> hits_;
    std::vector<Diagnostic> found_;
};

} // namespace

std::vector<Diagnostic> warnings(const Scene& scene) { return WarningFinder(scene.data()).run(); }

} // namespace glint
