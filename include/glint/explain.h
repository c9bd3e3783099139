#pragma once
// The pixel that explains itself.

#include "glint/explanation.h"
#include "glint/scene.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace glint {

/// Traces pixel (x, y) of the scene's picture again and keeps everything: the rays of each of its samples and
/// every term of the light along them. The same functions compute the picture, so the sum is its pixel, bit
/// for bit. (0, 0) is top left. Throws Error(usage) for a pixel outside the picture.
Explanation explain(const Scene& scene, int x, int y);

/// What explanations call an object, by its index: sphere "ball", or sphere #3, the third object of the file.
std::string object_label(const SceneDescription& scene, std::size_t object);
/// And a light: point light 2, the second light of the file.
std::string light_label(const SceneDescription& scene, std::size_t light);

/// How much of a pixel is told.
struct ExplainLimits {
    int samples =
        std::numeric_limits<int>::max(); ///< all make the pixel, but only of the first ones rays are kept
    float weight = 0; ///< rays that weigh less have a way and what they bring, but neither lights nor steps
};

/// The same for many pixels of one scene. One explainer for each thread.
class Explainer {
  public:
    /// Once `cancel` is set, pixel() throws Error(cancelled), within one ray.
    explicit Explainer(const Scene& scene, const CancelFlag* cancel = nullptr);
    ~Explainer();
    Explainer(Explainer&&) noexcept;
    Explainer& operator=(Explainer&&) noexcept;

    Explanation pixel(int x, int y, const ExplainLimits& limits = {});

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Many pixels, in their order, explained by several threads (0: one for each core). Throws what
/// Explainer::pixel() does.
std::vector<Explanation> explain_pixels(const Scene& scene, std::span<const PixelCoord> pixels,
                                        const ExplainLimits& limits = {}, int threads = 0,
                                        const CancelFlag* cancel = nullptr);

} // namespace glint
