// Building a scene: validation, baking, trees, and the solids around the camera.

#include "scene/build_scene.h"

#include "glint/limits.h"
#include "math/far_origin.h"
#include "math/trig.h"
#include "scene/bake.h"
#include "scene/contacts.h"
#include "scene/materials.h"
#include "scene/names.h"
#include "scene/validate.h"

#include <algorithm>
#include <variant>

namespace glint {

using trace::Hit;
using trace::PrimKind;
using trace::World;
using trace::WorldInput;
using trace::WorldStats;
} // namespace glint

namespace glint::scene {

namespace {

/// Ambient lights have none: they add up to one number.
LightRecord light_record(const AmbientLight&) { return {}; }

LightRecord light_record(const PointLight& l) {
    LightRecord f{};
    f.kind = light_point;
    f.position = vec3(l.position);
    f.strength = vec3(l.strength());
    return f;
}

LightRecord light_record(const DirectionalLight& l) {
    LightRecord f{};
    f.kind = light_directional;
    f.direction = vec3(glm::normalize(l.direction));
    f.strength = vec3(l.strength());
    return f;
}

LightRecord light_record(const SpotLight& l) {
    LightRecord f{};
    f.kind = light_spot;
    f.position = vec3(l.position);
    f.direction = vec3(glm::normalize(l.direction));
    f.strength = vec3(l.strength());
    f.cos_outer = static_cast<float>(cos_degrees(l.angle));
    f.cos_inner = static_cast<float>(cos_degrees(l.angle * (1 - l.blend)));
    return f;
}

void build_lights(SceneData& scene) {
    dvec3 ambient(0);
    scene.lights.clear();
    for (const Light& light : scene.description.lights) {
        if (const auto* a = std::get_if<AmbientLight>(&light.kind))
            ambient += a->color;
        else
            scene.lights.push_back(std::visit([](const auto& l) { return light_record(l); }, light.kind));
    }
    scene.ambient = vec3(ambient);
}

/// Moves everything that has a position.
void move(SceneDescription& description, const dvec3& by) {
    dmat4 there(1.0), back(1.0);
    there[3] = dvec4(by, 1);
    back[3] = dvec4(-by, 1);
    for (Object& object : description.objects) {
        // An instance is transformed after its mesh, which is moved too.
        const bool instance = std::holds_alternative<InstanceShape>(object.shape);
        object.transform = there * object.transform * (instance ? back : dmat4(1.0));
    }
    const auto move_light = [&](auto& light) {
        if constexpr (requires { light.position; }) light.position += by;
    };
    for (Light& light : description.lights) std::visit(move_light, light.kind);
    description.camera->eye += by;
}

} // namespace

bool shows_glass(const SceneDescription& description) {
    const NameIndex names(description);
    return std::any_of(description.objects.begin(), description.objects.end(), [&](const Object& object) {
        return object.visible && is_transparent(*names.material_of(object));
    });
}

void set_description(SceneData& scene, const SceneDescription& description) {
    scene.has_own_camera = description.camera.has_value();
    scene.description = description;
    if (!scene.has_own_camera) scene.description.camera = fit_camera(description);
    scene.given = nullptr;
    if (scene.origin == dvec3(0)) return;
    scene.given = std::make_shared<SceneDescription>(scene.description);
    move(scene.description, -scene.origin);
}

void build_values(SceneData& scene) {
    const SceneDescription& description = scene.description;
    scene.all_but_view = std::make_shared<int>();
    scene.any_transparent = shows_glass(description);
    scene.materials.clear();
    for (const Material& m : description.materials) scene.materials.push_back(material_record(m));
    scene.any_see_through =
        scene.any_transparent ||
        std::ranges::any_of(description.materials, [](const Material& m) { return m.opacity < 1; });
    scene.any_front_emission = std::ranges::any_of(
        description.materials, [](const Material& m) { return m.emission_sides == EmissionSides::front; });
    build_lights(scene);
    scene.background = vec3(description.render.background);
    scene.index_outside = static_cast<float>(description.whitted.index);
}

void build_light_set(SceneData& scene) {
    scene.light_set = nullptr;
    if (traces_paths(scene.description.render.integrator))
        scene.light_set = std::make_shared<const LightSet>(find_lights(scene));
}

void find_camera_interiors(SceneData& scene) {
    scene.camera_interiors.clear();
    if (!scene.any_transparent) return;
    for (const std::uint32_t id : objects_around(scene, vec3(scene.description.camera->eye)))
        if (scene.materials[scene.objects[id].material].transparency > 0)
            scene.camera_interiors.push_back(id);
    std::sort(
        scene.camera_interiors.begin(), scene.camera_interiors.end(),
        [&](std::uint32_t a, std::uint32_t b) { return scene.objects[a].rank < scene.objects[b].rank; });
}

std::vector<std::uint32_t> surfaces_around(const SceneData& scene, const vec3& point) {
    // Arbitrary directions; the first ray that hits no edge decides: at edges the parity is unreliable.
    constexpr int tries = 8;
    std::vector<Hit> hits;
    for (int i = 0; i < tries; ++i) {
        const float k = static_cast<float>(i);
        Ray ray;
        ray.origin = point;
        ray.direction = vec3(0.5377f + 0.0713f * k, 0.2917f - 0.1291f * k, 0.7825f - 0.0519f * k);
        scene.world.all_hits(ray, hits);
        if (std::none_of(hits.begin(), hits.end(), [](const Hit& hit) { return hit.on_edge; })) break;
    }
    std::erase_if(hits, [](const Hit& hit) { return hit.kind == PrimKind::plane; });
    std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.object < b.object; });
    std::vector<std::uint32_t> around;
    for (auto first = hits.begin(), next = first; first != hits.end(); first = next) {
        next = std::find_if(first, hits.end(), [&](const Hit& hit) { return hit.object != first->object; });
        if ((next - first) % 2 != 0) around.push_back(first->object);
    }
    return around;
}

std::vector<std::uint32_t> objects_around(const SceneData& scene, const vec3& point) {
    std::vector<std::uint32_t> around = surfaces_around(scene, point);
    std::erase_if(around, [&](std::uint32_t id) { return !scene.objects[id].solid; });
    for (const HalfSpace& half : scene.half_spaces)
        if (glm::dot(half.plane.normal, dvec3(point)) < half.plane.offset) around.push_back(half.object);
    return around;
}

namespace {

/// A better tree pays off if many rays use it: architecture gains as much in 20 to 270 rays a triangle as the
/// better tree costs; scans gain nothing (docs/performance.md).
BuildQuality quality_for(const SceneDescription& description, const WorldInput& input) {
    constexpr double rays_a_triangle = 200;
    double triangles = 0;
    for (const auto& mesh : input.meshes) triangles += static_cast<double>(mesh.triangles.size());
    for (const auto& mesh : input.shared_meshes) triangles += static_cast<double>(mesh.triangles->size());
    const RenderSettings& r = description.render;
    const double samples = double(r.width) * double(r.height) * sample_counts(r).mean();
    const double rays = samples * (1.0 + static_cast<double>(description.lights.size()));
    return rays < rays_a_triangle * triangles ? BuildQuality::fast : BuildQuality::high;
}

void check_cancel(const BuildSceneOptions& options) {
    if (options.cancel != nullptr && options.cancel->load(std::memory_order_relaxed))
        throw parallel::TasksCancelled();
}

void report(const BuildSceneOptions& options, const char* activity, double fraction) {
    check_cancel(options);
    if (options.progress) options.progress({activity, fraction});
}

/// Bakes about zero, and about an origin in the scene if that turns out to lie far from zero.
Baked bake_about_origin(SceneData& scene, const SceneDescription& description,
                        const BuildSceneOptions& options) {
    set_description(scene, description);
    const auto bake_all = [&] {
        return bake(scene.description, scene.solids_known, [&] { check_cancel(options); });
    };
    Baked baked = bake_all();
    // Bounds in single precision give an origin that is nearer, but not always near.
    for (int i = 0; i < 3; ++i) {
        Bounds core;
        for (const ObjectData& object : baked.objects) core.grow(object.core);
        const dvec3 step = far_origin(core);
        if (step == dvec3(0)) break;
        scene.origin += step;
        set_description(scene, description);
        baked = {}; // its memory is needed
        baked = bake_all();
    }
    return baked;
}

std::shared_ptr<SceneData> make_scene_data(const SceneDescription& description,
                                           const BuildSceneOptions& options) {
    report(options, "checking the scene", 0);
    require_valid(description);
    auto scene = std::make_shared<SceneData>();

    report(options, "placing the objects", 0);
    scene->solids_known = shows_glass(description) || options.find_solids;
    Baked baked = bake_about_origin(*scene, description, options);
    build_values(*scene);
    scene->objects = std::move(baked.objects);
    scene->attributes = std::move(baked.attributes);
    scene->normal_matrices = std::move(baked.normal_matrices);
    for (const WorldInput::Plane& plane : baked.input.planes)
        if (scene->objects[plane.object].solid) scene->half_spaces.push_back({plane.object, plane});

    report(options, "building the trees", 0);
    parallel::TaskPool pool(options.threads, options.cancel);
    baked.input.quality = quality_for(description, baked.input);
    scene->world = World(std::move(baked.input), pool);
    report(options, "building the trees", 1);
    find_contacts(*scene, pool);
    build_light_set(*scene);
    find_camera_interiors(*scene);
    return scene;
}

} // namespace

} // namespace glint::scene

namespace glint {

Scene build_scene(const SceneDescription& description, const BuildSceneOptions& options) {
    require_memory(build_memory(description), "building the scene", "use meshes of fewer triangles");
    try {
        return Scene(scene::make_scene_data(description, options));
    } catch (const parallel::TasksCancelled&) {
        throw Error(ErrorKind::cancelled, "building the scene was cancelled");
    }
}

SceneStats Scene::stats() const {
    const WorldStats world = data_->world.stats();
    const Bounds bounds = data_->world.bounds();
    SceneStats stats;
    stats.objects = data_->objects.size();
    stats.triangles = world.triangles;
    for (std::size_t kind = 0; kind < geometry::quadric_names.size(); ++kind)
        stats.quadrics.push_back({geometry::quadric_names[kind], world.quadrics[kind]});
    stats.planes = world.planes;
    stats.lights = data_->description.lights.size();
    stats.tree_nodes = world.nodes;
    stats.tree_depth = world.depth;
    if (world.triangles > 0) stats.tree_quality = world.quality == BuildQuality::fast ? "fast" : "high";
    stats.bytes = world.bytes;
    stats.bounds_min = data_->origin + Vec3(bounds.lo);
    stats.bounds_max = data_->origin + Vec3(bounds.hi);
    return stats;
}

const SceneDescription& Scene::description() const {
    return data_->given ? *data_->given : data_->description;
}

const CameraDescription& Scene::camera() const { return *description().camera; }

bool Scene::has_own_camera() const { return data_->has_own_camera; }

const RenderSettings& Scene::render_settings() const { return data_->description.render; }

} // namespace glint
