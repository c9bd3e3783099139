// From the number of a sample to its camera ray.

#include "render/camera_sampler.h"

namespace glint::rendering {

PinholeCamera camera_of(const SceneDescription& scene) {
    const CameraDescription& c = *scene.camera;
    return imaging::pinhole_camera(c.eye, c.direction, c.up, c.fov, c.fov_axis, scene.render.width,
                                   scene.render.height);
}

SampleNumbers::SampleNumbers(const RenderSettings& settings, const Pixel& pixel, std::uint32_t index)
    : key_(pixel_key(static_cast<uint>(settings.seed), static_cast<uint>(settings.seed >> 32),
                     static_cast<uint>(pixel.x), static_cast<uint>(pixel.y))),
      index_(index) {}

CameraSampler::CameraSampler(const SceneDescription& scene)
    : settings_(scene.render), camera_(camera_of(scene)), filter_(settings_.filter) {}

imaging::FilterSample CameraSampler::film_sample(const Pixel& pixel, int index) const {
    const vec2 u = SampleNumbers(settings_, pixel, static_cast<std::uint32_t>(index)).film();
    return filter_.sample(u.x, u.y);
}

CameraSample CameraSampler::sample_at(const Pixel& pixel, int index, const imaging::FilterSample& at) const {
    return {camera_.eye, pinhole_direction(camera_, pixel.x, pixel.y, at.dx, at.dy), pixel,
            static_cast<std::uint32_t>(index), at.weight};
}

} // namespace glint::rendering
