#pragma once
// Where the samples of a picture lie: from a pixel and a sample's number to a camera ray and its weight.

#include "glint/render.h"
#include "imaging/camera.h"
#include "imaging/filter.h"
#include "render/whitted.h"

#include <cstdint>
#include <optional>

namespace glint {

/// Samples that are traced together: enough to fill batches of rays, few enough to stay in the cache.
inline constexpr int batch_samples = 256;

/// The camera of a scene, whose description must have one.
PinholeCamera camera_of(const SceneDescription& scene);

/// The crop, or all of the picture. Throws Error(usage) for a crop that does not lie inside.
Rect picture_area(const RenderSettings& settings, const std::optional<Rect>& crop);

/// What a place on the film depends on: scene, pixel of the whole picture and number of the sample alone.
class SamplePlaces {
  public:
    explicit SamplePlaces(const SceneDescription& scene);

    /// Sets origin and direction of sample i of a pixel and returns its weight. Where a pixel has one sample,
    /// that goes through its centre.
    float aim(int x, int y, int i, Sample& sample) const;
    /// The ray through a pixel's centre.
    void aim_at_centre(int x, int y, Sample& sample) const;

    const PinholeCamera& camera() const { return camera_; }
    const PixelFilterSampler& filter() const { return filter_; }

    /// Where on the film sample i of a pixel lies, and the ray through a place on the film.
    FilterSample place(int x, int y, int i) const;
    void aim(int x, int y, const FilterSample& place, Sample& sample) const;

  private:
    const RenderSettings settings_;
    const PinholeCamera camera_;
    const PixelFilterSampler filter_;
};

/// Every second bit of a number, moved together.
inline int even_bits(std::uint32_t x) {
    x &= 0x55555555u;
    x = (x | x >> 1) & 0x33333333u;
    x = (x | x >> 2) & 0x0f0f0f0fu;
    x = (x | x >> 4) & 0x00ff00ffu;
    return static_cast<int>((x | x >> 8) & 0x0000ffffu);
}

/// Place i on Morton's curve: neighbours on it are neighbours in the plane.
inline int morton_x(std::uint32_t i) { return even_bits(i); }
inline int morton_y(std::uint32_t i) { return even_bits(i >> 1); }

} // namespace glint
