#pragma once
// OpenGL without a window: devices by EGL, and a context that belongs to one of them.

#include "glint/gpu.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace glint {

/// A context of OpenGL 4.3 or later, core profile, on no surface. Current on a thread between enter() and
/// leave().
class GpuContext {
  public:
    /// Throws Error(device) where the device of that number (−1: the first usable) cannot be used.
    /// `largest_buffer` bytes stand in the place of the device's own limit, unless 0.
    explicit GpuContext(int device, std::uint64_t largest_buffer = 0);
    /// The context that is current on this thread, whose owner keeps it so: enter() and leave() do nothing.
    /// Throws Error(device) where it cannot do what the shaders need.
    explicit GpuContext(GpuCurrentContext current);
    ~GpuContext();
    GpuContext(const GpuContext&) = delete;
    GpuContext& operator=(const GpuContext&) = delete;

    const GpuDevice& device() const;
    void enter() const; ///< makes it current on this thread
    void leave() const;

    /// Throws Error(device) where the device was lost or an operation failed since the last call; `doing`
    /// says what was being done: "rendering".
    void check(const std::string& doing) const;
    /// What the driver complained of since the context was made.
    const std::vector<std::string>& complaints() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Holds a context current for as long as it lives.
class GpuScope {
  public:
    explicit GpuScope(const GpuContext& context) : context_(context) { context_.enter(); }
    ~GpuScope() { context_.leave(); }
    GpuScope(const GpuScope&) = delete;
    GpuScope& operator=(const GpuScope&) = delete;

  private:
    const GpuContext& context_;
};

} // namespace glint
