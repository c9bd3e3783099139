#include "glint/pick.h"

#include "render/camera_sampler.h"
#include "render/estimators/aov.h"

#include <cmath>

namespace glint {

std::optional<Pick> pick(const Scene& scene, double x, double y) {
    const RenderSettings& settings = scene.render_settings();
    const auto within = [](double coordinate, int count) { return coordinate >= 0 && coordinate < count; };
    if (!within(x, settings.width) || !within(y, settings.height)) return std::nullopt;
    const int px = static_cast<int>(x);
    const int py = static_cast<int>(y);
    const imaging::FilterSample offset{static_cast<float>(x - px - 0.5), static_cast<float>(y - py - 0.5)};
    const rendering::CameraSample sample =
        rendering::CameraSampler(scene.data().description).sample_at({px, py}, 0, offset);

    rendering::RayTree tree;
    rendering::Whitted(scene.data(), rendering::first_hit_settings(scene.data())).trace(sample, &tree);
    const rendering::RayNode& node = tree.nodes.front();
    if (!node.hit) return std::nullopt;
    Pick found;
    found.object = node.hit.object;
    found.material = scene.data().objects[node.hit.object].material;
    found.position = scene.data().origin + Vec3(node.position);
    found.normal = Vec3(node.geometric_normal);
    found.distance = static_cast<double>(node.hit.t);
    found.from_inside = !node.entering;
    return found;
}

} // namespace glint
