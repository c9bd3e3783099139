#include "render/camera_sampler.h"

#include "math/random.shared.h"

namespace glint {
PinholeCamera camera_of(const SceneDescription& scene) {
    const CameraDescription& c = *scene.camera;
    return pinhole_camera(c.eye, c.direction, c.up, c.fov, c.fov_axis, scene.render.width,
                          scene.render.height);
}

Rect picture_area(const RenderSettings& settings, const std::optional<Rect>& crop) {
    if (!crop) return {0, 0, settings.width, settings.height};
    const Rect c = *crop;
    const bool inside = c.x >= 0 && c.y >= 0 && c.width >= 1 && c.height >= 1 &&
                        c.width <= settings.width - c.x && c.height <= settings.height - c.y;
    if (inside) return c;
    throw Error(ErrorKind::usage, "the crop does not lie inside the picture",
                "expected x, y, width, height within " + std::to_string(settings.width) + "x" +
                    std::to_string(settings.height));
}

CameraSampler::CameraSampler(const SceneDescription& scene)
    : settings_(scene.render), camera_(camera_of(scene)), filter_(settings_.filter) {}

FilterSample CameraSampler::film_sample(const Pixel& pixel, int index) const {
    if (settings_.spp == 1) return {};
    const auto key = pixel_key(static_cast<uint>(settings_.seed), static_cast<uint>(settings_.seed >> 32),
                               static_cast<uint>(pixel.x), static_cast<uint>(pixel.y));
    const vec2 u = sample_pair(key, static_cast<uint>(index), 0);
    return filter_.sample(u.x, u.y);
}

CameraSample CameraSampler::sample_at(const Pixel& pixel, int index, const FilterSample& at) const {
    CameraSample sample;
    sample.origin = camera_.eye;
    sample.direction = pinhole_direction(camera_, pixel.x, pixel.y, at.dx, at.dy);
    sample.pixel = pixel;
    sample.index = static_cast<std::uint32_t>(index);
    sample.weight = at.weight;
    return sample;
}

} // namespace glint
