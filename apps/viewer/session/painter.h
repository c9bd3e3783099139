#pragma once
// What makes the pictures of one place: the CPU, or a graphics card.

#include "glint/gpu.h"
#include "glint/progressive.h"

#include <functional>
#include <memory>
#include <string>

namespace glint::viewer {

struct Frame;

/// For one thread, the renderer's, which also makes and ends it. A graphics card may throw Error(device)
/// wherever it works.
class Painter {
  public:
    virtual ~Painter() = default;

    /// As Progressive.
    virtual void start(const Scene& scene, const ProgressiveOptions& options) = 0;
    virtual bool advance(double seconds) = 0;
    virtual const Refinement& reached() const = 0;

    /// Puts the picture so far into a frame, whose memory may serve again.
    virtual void show(Frame& frame) = 0;
    /// What works; empty: the CPU.
    virtual std::string device() const = 0;
};

/// Makes painters of a graphics card; called by the renderer's thread. Throws Error(device).
using PainterMaker = std::function<std::unique_ptr<Painter>()>;

/// 0: one thread for each core.
std::unique_ptr<Painter> cpu_painter(int threads);
/// `context` is held as long as the painter is there, and ends after all that it has made.
std::unique_ptr<Painter> gpu_painter(std::shared_ptr<void> context);

} // namespace glint::viewer
