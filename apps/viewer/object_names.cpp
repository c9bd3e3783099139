#include "object_names.h"

#include "glint/scene.h"

#include <array>

namespace glint::viewer {

std::string table_of(const Object& object, std::size_t number_in_kind) {
    return std::string(name_of(object.shape)) + "." +
           (object.name.empty() ? std::to_string(number_in_kind) : object.name);
}

std::string named_key(const SceneDescription& scene, const std::string& key) {
    std::array<std::size_t, shape_names.size()> counts{};
    for (const Object& object : scene.objects) {
        const std::size_t number = counts[object.shape.index()]++;
        const std::string numbered = std::string(name_of(object.shape)) + "." + std::to_string(number) + ".";
        if (!object.name.empty() && key.starts_with(numbered))
            return table_of(object, number) + "." + key.substr(numbered.size());
    }
    return key;
}

} // namespace glint::viewer
