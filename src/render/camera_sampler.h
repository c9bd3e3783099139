#pragma once
// Camera samples: from a pixel and the index of a sample to a camera ray and its weight.

#include "glint/render.h"
#include "imaging/camera.h"
#include "imaging/filter.h"
#include "render/camera_sample.h"

#include <cstdint>

namespace glint::rendering {

/// Samples that are traced together: enough to fill batches of rays, few enough to stay in the cache.
inline constexpr int batch_samples = 256;

/// The camera of a scene, whose description must have one.
PinholeCamera camera_of(const SceneDescription& scene);

/// What the pairs of random numbers of a sample are for.
enum class SampleDimension : std::uint32_t { film, hemisphere };

/// A pair of numbers in [0, 1): a function of the seed, the pixel, the sample and the dimension alone.
vec2 random_pair(const RenderSettings& settings, const Pixel& pixel, int index, SampleDimension dimension);

/// Makes camera samples. They depend only on the scene, the pixel and the index of the sample.
class CameraSampler {
  public:
    explicit CameraSampler(const SceneDescription& scene);

    /// Sample `index` of a pixel that has several. The only sample of a pixel goes through its centre.
    CameraSample sample(const Pixel& pixel, int index) const {
        return sample_at(pixel, index, film_sample(pixel, index));
    }
    CameraSample centre(const Pixel& pixel) const { return sample_at(pixel, 0, imaging::FilterSample{}); }

    /// Offset from the pixel's centre and weight of a sample, and the camera sample there.
    imaging::FilterSample film_sample(const Pixel& pixel, int index) const;
    CameraSample sample_at(const Pixel& pixel, int index, const imaging::FilterSample& at) const;

    const PinholeCamera& camera() const { return camera_; }
    const imaging::PixelFilterSampler& filter() const { return filter_; }

  private:
    const RenderSettings settings_;
    const PinholeCamera camera_;
    const imaging::PixelFilterSampler filter_;
};

/// Every second bit of a number, moved together.
inline int even_bits(std::uint32_t x) {
    x &= 0x55555555u;
    x = (x | x >> 1) & 0x33333333u;
    x = (x | x >> 2) & 0x0f0f0f0fu;
    x = (x | x >> 4) & 0x00ff00ffu;
    return static_cast<int>((x | x >> 8) & 0x0000ffffu);
}

/// Point i of the Morton curve: neighbours on it are neighbours in the plane.
inline int morton_x(std::uint32_t i) { return even_bits(i); }
inline int morton_y(std::uint32_t i) { return even_bits(i >> 1); }

} // namespace glint::rendering
