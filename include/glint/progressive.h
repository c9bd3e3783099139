#pragma once
// Progressive rendering for interactive views.

#include "glint/image.h"
#include "glint/kernels.h"
#include "glint/render.h"
#include "glint/scene.h"

#include <cstdint>
#include <memory>

namespace glint {

struct ProgressiveOptions {
    /// The first pass measures every n-th pixel of each row and column, the next every n/2-th, and so on: a
    /// power of two from 1 to max_coarsest.
    int coarsest = 8;
    Aov show = Aov::final;
    KernelChoice kernel;                ///< affects time, never the picture
    const CancelFlag* cancel = nullptr; ///< once it is set, advance() returns within milliseconds
};
inline constexpr int max_coarsest = 64;

/// Progress of a picture.
struct Refinement {
    int step = 0;        ///< every n-th pixel of each row and column is known; 0: nothing is
    int samples = 0;     ///< samples per pixel so far; 0: one ray through the centre
    double fraction = 0; ///< fraction of all samples done
    bool finished = false;
    std::uint64_t rays = 0;
    double seconds = 0; ///< time spent in advance()
};

/// Renders in passes: every 8th pixel of each row and column, for example, then every 4th, every 2nd and all
/// with one ray through each centre, then antialiased with twice as many samples each pass. The final picture
/// equals that of render() bit for bit, regardless of cancelling in between. Keeps its threads and memory
/// (some 200 bytes a pixel with more than one sample) between scenes. For use by one thread at a time.
class Progressive {
  public:
    explicit Progressive(int threads = 0); ///< 0: one for each processor that may be used
    ~Progressive();
    Progressive(const Progressive&) = delete;
    Progressive& operator=(const Progressive&) = delete;

    /// Begins a picture; the one before stays in image() until the first pass has ended. Throws Error(usage),
    /// and begins nothing, for an impossible step.
    void start(const Scene& scene, const ProgressiveOptions& options = {});

    /// Goes on for about `seconds`, and at least to the end of the first pass. False when nothing is
    /// left to do: the picture is finished, or none was started. After a cancelled call the work that was
    /// whole is kept, and the next call goes on.
    bool advance(double seconds);

    /// The picture so far, linear; unknown pixels are interpolated.
    const Image& image() const;
    const Refinement& reached() const;
    int threads() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace glint
