#include "object_names.h"

#include <array>

namespace glint::viewer {
namespace {

constexpr std::array<const char*, std::variant_size_v<Shape>> shape_words{
    "plane", "sphere", "cylinder", "triangle", "polyhedron", "mesh", "instance"};

} // namespace

const char* shape_word(const Object& object) { return shape_words[object.shape.index()]; }

std::string table_of(const Object& object, std::size_t number_in_kind) {
    return std::string(shape_word(object)) + "." +
           (object.name.empty() ? std::to_string(number_in_kind) : object.name);
}

std::string named_key(const SceneDescription& scene, const std::string& key) {
    std::array<std::size_t, shape_words.size()> counts{};
    for (const Object& object : scene.objects) {
        const std::size_t number = counts[object.shape.index()]++;
        const std::string numbered = std::string(shape_word(object)) + "." + std::to_string(number) + ".";
        if (!object.name.empty() && key.starts_with(numbered))
            return table_of(object, number) + "." + key.substr(numbered.size());
    }
    return key;
}

} // namespace glint::viewer
