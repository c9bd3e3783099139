// Nested dielectrics.

#include "render/interior_list.h"

#include <algorithm>

namespace glint::rendering {

using scene::SceneData;

bool is_dielectric(std::uint32_t object, const SceneData& scene) {
    const scene::ObjectData& o = scene.objects[object];
    return o.solid && scene.materials[o.material].transparency > 0.0f;
}

const InteriorList* entered(const InteriorList* list, std::uint32_t object, const SceneData& scene,
                            InteriorArena& arena) {
    const bool owns = list == nullptr || scene.objects[list->owner].rank < scene.objects[object].rank;
    return arena.push({object, owns ? object : list->owner, list});
}

const InteriorList* left(const InteriorList* list, std::uint32_t object, const SceneData& scene,
                         InteriorArena& arena) {
    if (list == nullptr) return nullptr;
    if (list->object == object) return list->rest;
    const InteriorList* rest = left(list->rest, object, scene, arena);
    return rest == list->rest ? list : entered(rest, list->object, scene, arena);
}

const InteriorList* crossed(const InteriorList* list, std::uint32_t object, bool entering,
                            const SceneData& scene, InteriorArena& arena) {
    return entering ? entered(list, object, scene, arena) : left(list, object, scene, arena);
}

bool is_hidden(const InteriorList* list, std::uint32_t object, const SceneData& scene) {
    if (list == nullptr || !is_dielectric(object, scene)) return false;
    return scene.objects[list->owner].rank > scene.objects[object].rank;
}

float refractive_index(const InteriorList* list, const SceneData& scene) {
    if (list == nullptr) return scene.index_outside;
    return scene.materials[scene.objects[list->owner].material].index;
}

std::vector<std::uint32_t> solids_of(const InteriorList* list, const SceneData& scene) {
    std::vector<std::uint32_t> solids;
    for (; list != nullptr; list = list->rest) solids.push_back(list->object);
    std::sort(solids.begin(), solids.end(), [&](std::uint32_t a, std::uint32_t b) {
        return scene.objects[a].rank > scene.objects[b].rank;
    });
    return solids;
}

} // namespace glint::rendering
