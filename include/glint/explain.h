#pragma once
// Explanations of pixels.

#include "glint/explanation.h"
#include "glint/scene.h"

#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace glint {

/// Traces pixel (x, y) again and records everything: the rays of each sample and every term of the light
/// along them. Uses the functions that compute the picture, so the sum equals its pixel bit for bit. (0, 0)
/// is top left. Throws Error(usage) for a pixel outside the picture.
Explanation explain(const Scene& scene, int x, int y);

/// Limits on the detail of an explanation.
struct ExplainLimits {
    int samples = std::numeric_limits<int>::max(); ///< number of samples whose rays are recorded; all samples
                                                   ///< contribute to the pixel
    /// rays with less weight are recorded with their path and radiance but without lights and steps
    float weight = 0;
};

/// Explains many pixels of one scene. Use one explainer per thread.
class Explainer {
  public:
    /// Once `*cancel` is set, pixel() throws Error(cancelled) within one ray.
    explicit Explainer(const Scene& scene, const CancelFlag* cancel = nullptr);
    ~Explainer();
    Explainer(Explainer&&) noexcept;
    Explainer& operator=(Explainer&&) noexcept;

    Explanation pixel(int x, int y, const ExplainLimits& limits = {});

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Explains many pixels, in order, with several threads (0: one per processor of the process). Throws what
/// Explainer::pixel() throws.
std::vector<Explanation> explain_pixels(const Scene& scene, std::span<const PixelCoord> pixels,
                                        const ExplainLimits& limits = {}, int threads = 0,
                                        const CancelFlag* cancel = nullptr);

} // namespace glint
