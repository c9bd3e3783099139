#pragma once
// Progressive rendering of one view, on the CPU or on a GPU.

#include "glint/gpu.h"
#include "glint/progressive.h"

#include <functional>
#include <memory>
#include <string>

namespace glint::viewer {

struct RenderedFrame;

/// Created, used and destroyed on one thread, the renderer's. A GPU backend may throw Error(device) from any
/// call but the destructor. The interface lets tests inject GPU faults.
class Backend {
  public:
    virtual ~Backend() = default;

    /// As Progressive::start().
    virtual void start(const Scene& scene, const ProgressiveOptions& options) = 0;
    /// As Progressive::advance().
    virtual bool advance(double seconds) = 0;
    /// As Progressive::reached().
    virtual const Refinement& reached() const = 0;

    /// Copies the picture so far, and its size, into a frame; memory of the frame is reused.
    virtual void copy_to(RenderedFrame& frame) = 0;
    /// The GPU's name; empty: the CPU.
    virtual std::string device() const = 0;
};

/// Creates a GPU backend; called on the renderer's thread. Throws Error(device).
using BackendFactory = std::function<std::unique_ptr<Backend>()>;

/// `threads` = 0: one for each processor.
std::unique_ptr<Backend> cpu_backend(int threads);
/// Renders in the OpenGL context that is current. `context` keeps it current: the backend holds it for its
/// lifetime and releases it after everything it has created.
std::unique_ptr<Backend> gpu_backend(std::shared_ptr<void> context);

} // namespace glint::viewer
