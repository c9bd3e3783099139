#include "scene/media.h"

namespace glint {

const Media* with(const Media* list, std::uint32_t object, const FrozenScene& scene, MediaArena& arena) {
    if (list == nullptr || scene.objects[list->object].rank <= scene.objects[object].rank)
        return arena.push(object, list);
    return arena.push(list->object, with(list->rest, object, scene, arena));
}

const Media* without(const Media* list, std::uint32_t object, MediaArena& arena) {
    if (list == nullptr) return nullptr;
    if (list->object == object) return list->rest;
    const Media* rest = without(list->rest, object, arena);
    return rest == list->rest ? list : arena.push(list->object, rest);
}

const Media* across(const Media* list, std::uint32_t object, bool entering, const FrozenScene& scene,
                    MediaArena& arena) {
    return entering ? with(list, object, scene, arena) : without(list, object, arena);
}

bool hidden(const Media* list, std::uint32_t object, const FrozenScene& scene) {
    if (list == nullptr || !scene.objects[object].solid) return false;
    return scene.objects[list->object].rank > scene.objects[object].rank;
}

float index_of(const Media* list, const FrozenScene& scene) {
    if (list == nullptr) return scene.index_outside;
    return scene.materials[scene.objects[list->object].material].index;
}

} // namespace glint
