// The settings that decide a picture, for its metadata.

#include "glint/keys.h"
#include "glint/render.h"

namespace glint {

std::vector<std::pair<std::string, std::string>> picture_settings(const Scene& scene) {
    std::vector<std::pair<std::string, std::string>> settings{{"glint.version", version()}};
    const auto add = [&](const char* table, const KeyOwner& owner) {
        for (const KeySpec& key : description_table(table).keys)
            if (key.in_metadata)
                settings.emplace_back("glint." + std::string(key.key), plain_text(key, key.get(owner)));
    };
    const SceneDescription& description = scene.description();
    add("render", KeyOwner(description.render));
    switch (description.render.integrator) {
    case Integrator::whitted:
        add("whitted", KeyOwner(description.whitted));
        break;
    case Integrator::path:
    case Integrator::path_simple:
    case Integrator::direct:
        add("path", KeyOwner(description.path));
        break;
    case Integrator::ambient_occlusion:
        add("ambient_occlusion", KeyOwner(description.ambient_occlusion));
    }
    return settings;
}

const char* version() { return GLINT_VERSION; }

} // namespace glint
