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
    KernelChoice kernel;                ///< changes the time, never the picture
    const CancelFlag* cancel = nullptr; ///< once it is set, advance() returns within milliseconds
};
inline constexpr int max_coarsest = 64;

/// How good a picture has become.
struct Refinement {
    int step = 0;        ///< every n-th pixel of each row and column is known; 0: nothing is
    int samples = 0;     ///< of each pixel that its value is the mean of; 0: one ray through its centre
    double fraction = 0; ///< of the whole way, by samples
    bool finished = false;
    std::uint64_t rays = 0;
    double seconds = 0; ///< spent in advance()
};

/// Renders in passes: every 8th pixel of each row and column, say, then every 4th, every 2nd, all, by one ray
/// through each centre; then antialiased, with twice as many samples each pass. After the last pass the
/// picture is that of render(), to the bit, whatever was cancelled on the way. Keeps its threads and its
/// memory (some 200 bytes a pixel where there is more than one sample) from scene to scene. For one thread.
class Progressive {
  public:
    explicit Progressive(int threads = 0); ///< 0: one for each core
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

    /// The picture so far, linear; light is interpolated between the pixels that are known.
    const Image& image() const;
    const Refinement& reached() const;
    int threads() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace glint
