// How messages and explanations call objects and lights.

#include "glint/scene.h"

namespace glint {

namespace {

// The same as the key path of -D, except that names are quoted.
std::string label(std::string_view type, const std::string& name, std::uint32_t number) {
    return std::string(type) + (name.empty() ? "." + std::to_string(number) : " \"" + name + "\"");
}

} // namespace

std::vector<std::uint32_t> object_numbers(const SceneDescription& scene) {
    std::array<std::uint32_t, std::variant_size_v<Shape>> counts{};
    std::vector<std::uint32_t> numbers;
    for (const Object& object : scene.objects) numbers.push_back(counts[object.shape.index()]++);
    return numbers;
}

std::string object_label(const Object& object, std::uint32_t number) {
    return label(name_of(object.shape), object.name, number);
}

std::string light_label(const SceneDescription& scene, std::size_t light) {
    const Light& l = scene.lights[light];
    return label(std::string(name_of(l)) + " light", l.name, static_cast<std::uint32_t>(light));
}

} // namespace glint
