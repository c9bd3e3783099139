// A scene again with other materials, lights, settings or another camera, over the same trees.

#include "scene/freeze.h"
#include "scene/validate.h"

#include <algorithm>
#include <variant>

namespace glint {
namespace {

/// Do the objects make the same trees? Names count, since instances go by them.
bool same_place(const Object& a, const Object& b) {
    return a.name == b.name && a.visible == b.visible && a.priority == b.priority &&
           a.transform == b.transform && a.shape == b.shape;
}

bool same_places(const std::vector<Object>& a, const std::vector<Object>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_place);
}

void throw_if_any(std::vector<Diagnostic> errors) {
    if (!errors.empty()) throw Error(ErrorKind::input, std::move(errors));
}

void freeze_materials_of_objects(FrozenScene& scene) {
    const SceneDescription& description = scene.description;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Material* material = material_of(description, description.objects[i]);
        scene.objects[i].material = static_cast<std::uint32_t>(material - description.materials.data());
    }
}

} // namespace

Scene refreeze(const Scene& scene, const SceneDescription& description, const FreezeOptions& options) {
    if (!same_places(scene.description().objects, description.objects)) return freeze(description, options);
    throw_if_any(find_errors(description, Shapes::checked));
    if (shows_glass(description) && !scene.frozen().solids_known) return freeze(description, options);

    auto frozen = std::make_shared<FrozenScene>(scene.frozen());
    frozen->description = description;
    if (!description.camera) frozen->description.camera = frame(description);
    freeze_values(*frozen);
    freeze_materials_of_objects(*frozen);
    find_camera_media(*frozen);
    return Scene(std::move(frozen));
}

Scene with_view(const Scene& scene, const CameraDescription& camera, int width, int height) {
    SceneDescription view;
    view.camera = camera;
    view.render.width = width;
    view.render.height = height;
    throw_if_any(find_errors(view));
    auto frozen = std::make_shared<FrozenScene>(scene.frozen());
    frozen->description.camera = camera;
    frozen->description.render.width = width;
    frozen->description.render.height = height;
    find_camera_media(*frozen);
    return Scene(std::move(frozen));
}

} // namespace glint
