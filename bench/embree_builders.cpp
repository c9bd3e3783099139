// Embree's builders.

#include "builders.h"
#include "embree_scene.h"

namespace glint::bench {
namespace {

Builder builder(const std::string& name, bool high) {
    return {name, [high](const Model& model) {
                auto scene = std::make_shared<const EmbreeScene>(*model.mesh, EmbreeOptions{high, false, {}});
                return Built{scene, scene->build_seconds(), scene->bytes()};
            }};
}

} // namespace

std::vector<Builder> embree_builders() {
    return {builder("Embree MEDIUM", false), builder("Embree HIGH", true)};
}

} // namespace glint::bench
