// Nested dielectrics.

#include "render/interior_list.h"

namespace glint::rendering {

using scene::SceneData;

bool is_dielectric(std::uint32_t object, const SceneData& scene) {
    const scene::ObjectData& o = scene.objects[object];
    return o.solid && scene.materials[o.material].transparency > 0.0f;
}

const InteriorList* entered(const InteriorList* list, std::uint32_t object, const SceneData& scene,
                            InteriorArena& arena) {
    if (list == nullptr || scene.objects[list->object].rank <= scene.objects[object].rank)
        return arena.push(object, list);
    return arena.push(list->object, entered(list->rest, object, scene, arena));
}

const InteriorList* left(const InteriorList* list, std::uint32_t object, InteriorArena& arena) {
    if (list == nullptr) return nullptr;
    if (list->object == object) return list->rest;
    const InteriorList* rest = left(list->rest, object, arena);
    return rest == list->rest ? list : arena.push(list->object, rest);
}

const InteriorList* crossed(const InteriorList* list, std::uint32_t object, bool entering,
                            const SceneData& scene, InteriorArena& arena) {
    return entering ? entered(list, object, scene, arena) : left(list, object, arena);
}

bool can_be_hidden(std::uint32_t object, const SceneData& scene) { return scene.objects[object].solid; }

bool is_hidden(const InteriorList* list, std::uint32_t object, const SceneData& scene) {
    if (list == nullptr || !can_be_hidden(object, scene)) return false;
    return scene.objects[list->object].rank > scene.objects[object].rank;
}

float refractive_index(const InteriorList* list, const SceneData& scene) {
    if (list == nullptr) return scene.index_outside;
    return scene.materials[scene.objects[list->object].material].index;
}

} // namespace glint::rendering
