// Cached lookups in the document, and key paths of objects.
#include "file_keys.h"

#include "glint/scene.h"

#include <array>

namespace glint::viewer {

const std::vector<double>& FileKeys::numbers(const std::string& path) const {
    const auto [found, is_new] = numbers_.try_emplace(path);
    if (is_new && document_ != nullptr) found->second = document_->numbers(path);
    return found->second;
}

std::optional<std::string> FileKeys::longer_list(const std::string& path, const std::string& value) const {
    return document_ != nullptr ? document_->longer_list(path, value) : std::nullopt;
}

std::string table_of(const Object& object, std::size_t number_in_kind) {
    return std::string(name_of(object.shape)) + "." +
           (object.name.empty() ? std::to_string(number_in_kind) : object.name);
}

std::string named_key(const SceneDescription& scene, const std::string& key) {
    std::array<std::size_t, std::variant_size_v<Shape>> counts{};
    for (const Object& object : scene.objects) {
        const std::size_t number = counts[object.shape.index()]++;
        const std::string numbered = std::string(name_of(object.shape)) + "." + std::to_string(number) + ".";
        if (!object.name.empty() && key.starts_with(numbered))
            return table_of(object, number) + "." + key.substr(numbered.size());
    }
    return key;
}

} // namespace glint::viewer
