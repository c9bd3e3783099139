// Updating a scene with new materials, lights, settings or camera, sharing its trees.

#include "scene/build_scene.h"
#include "scene/contacts.h"
#include "scene/names.h"
#include "scene/validate.h"

#include <algorithm>
#include <variant>
#include <vector>

namespace glint {

using scene::SceneData;

namespace {

/// Whether two objects result in the same trees. Names count, since instances refer to them.
bool same_object(const Object& a, const Object& b) {
    return a.name == b.name && a.visible == b.visible && a.priority == b.priority &&
           a.transform == b.transform && a.shape == b.shape;
}

bool same_objects(const std::vector<Object>& a, const std::vector<Object>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_object);
}

void build_materials_of_objects(SceneData& scene) {
    const SceneDescription& description = scene.description;
    const scene::NameIndex names(description);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Material* material = names.material_of(description.objects[i]);
        scene.objects[i].material = static_cast<std::uint32_t>(material - description.materials.data());
    }
}

std::vector<bool> transparent_objects(const SceneData& scene) {
    std::vector<bool> transparent;
    for (const scene::ObjectData& object : scene.objects)
        transparent.push_back(scene.materials[object.material].transparency > 0);
    return transparent;
}

} // namespace

Scene update_scene(const Scene& scene, const SceneDescription& description,
                   const BuildSceneOptions& options) {
    if (!same_objects(scene.description().objects, description.objects))
        return build_scene(description, options);
    scene::require_valid(description, scene::Shapes::checked);
    if (scene::shows_glass(description) && !scene.data().solids_known)
        return build_scene(description, options);

    auto scene_data = std::make_shared<SceneData>(scene.data());
    scene::set_description(*scene_data, description);
    scene::build_values(*scene_data);
    build_materials_of_objects(*scene_data);
    if (transparent_objects(*scene_data) != transparent_objects(scene.data())) {
        parallel::TaskPool pool(options.threads);
        scene::find_contacts(*scene_data, pool);
    }
    scene::build_light_set(*scene_data);
    scene::find_camera_interiors(*scene_data);
    return Scene(std::move(scene_data));
}

Scene with_view(const Scene& scene, const CameraDescription& camera, int width, int height) {
    SceneDescription view;
    view.camera = camera;
    view.render.width = width;
    view.render.height = height;
    scene::require_valid(view);
    auto scene_data = std::make_shared<SceneData>(scene.data());
    const auto set_view = [&](SceneDescription& description) {
        description.camera = camera;
        description.render.width = width;
        description.render.height = height;
    };
    if (scene_data->given) {
        auto given = std::make_shared<SceneDescription>(*scene_data->given);
        set_view(*given);
        scene_data->given = std::move(given);
    }
    set_view(scene_data->description);
    scene_data->description.camera->eye -= scene_data->origin;
    scene_data->has_own_camera = true;
    scene::find_camera_interiors(*scene_data);
    return Scene(std::move(scene_data));
}

} // namespace glint
