#pragma once
// Camera samples: from a pixel and the index of a sample to a camera ray and its weight.

#include "glint/render.h"
#include "imaging/camera.h"
#include "imaging/filter.h"
#include "math/sobol.h"
#include "render/camera_sample.h"

#include <cstdint>

namespace glint::rendering {

/// Samples that are traced together: enough to fill batches of rays, few enough to stay in the cache.
inline constexpr int batch_samples = 256;

/// The camera of a scene, whose description must have one.
PinholeCamera camera_of(const SceneDescription& scene);

/// The random numbers of a sample: functions of the seed, the pixel, the sample and what they are for alone.
/// Each vertex of a path has its own, so that nothing that happens at one moves those of another.
class SampleNumbers {
  public:
    SampleNumbers() = default;
    SampleNumbers(const RenderSettings& settings, const Pixel& pixel, std::uint32_t index);

    /// Where on the film; of the direction in which a path leaves vertex 0 (the first hit), 1, …
    vec2 film() const { return sample_pair(key_, index_, 0); }
    vec2 direction(int vertex) const { return sample_pair(key_, index_, after(vertex)); }
    /// Of the point on a light, joint with the numbers by which the path came to the vertex.
    vec2 light(int vertex) const { return second_pair(key_, index_, after(vertex) - 1); }
    float lobe(int vertex) const { return choice(vertex).x; }
    float emitter(int vertex) const { return choice(vertex).y; }
    float point_light(int vertex) const { return second_choice(vertex).x; }
    float roulette(int vertex) const { return second_choice(vertex).y; }
    /// Whether a path goes straight through the surface that it meets next.
    float crossing(int crossed) const { return sample_pair(key_, index_, first_crossing + after(crossed)).x; }

  private:
    static constexpr std::uint32_t first_choice = 1U << 20U;
    static constexpr std::uint32_t first_crossing = 1U << 21U;
    vec2 choice(int vertex) const { return sample_pair(key_, index_, first_choice + after(vertex)); }
    vec2 second_choice(int vertex) const { return second_pair(key_, index_, first_choice + after(vertex)); }
    static std::uint32_t after(int vertex) { return static_cast<std::uint32_t>(vertex) + 1; }

    std::uint32_t key_ = 0;
    std::uint32_t index_ = 0;
};

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
