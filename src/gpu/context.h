#pragma once
// OpenGL without a window: devices by EGL, and a context on one of them.

#include "glint/gpu.h"

#include <cstdint>
#include <memory>
#include <new>
#include <string>
#include <vector>

namespace glint::gpu {

/// A context of OpenGL 4.3 or later, core profile, on no surface. Current on a thread between enter() and
/// leave().
class GpuContext {
  public:
    /// On the device with that number; −1: the first usable one. Throws Error(device) if it cannot be used.
    explicit GpuContext(int device);
    /// The context that is current on this thread and is kept so by its owner: enter() and leave() do
    /// nothing. Throws Error(device) if it lacks what the shaders need.
    explicit GpuContext(GpuCurrentContext current);
    ~GpuContext();
    GpuContext(const GpuContext&) = delete;
    GpuContext& operator=(const GpuContext&) = delete;

    const GpuDevice& device() const;
    /// Replaces the device's own limit.
    void set_max_buffer(std::uint64_t bytes);

    /// Makes it current on this thread. Throws Error(device) if the device is lost or another thread has it.
    void enter() const;
    bool try_enter() const noexcept; ///< the same; false instead of an error
    void leave() const;
    bool is_current() const; ///< on this thread

    /// Throws Error(device) if the device was lost or an operation failed since the last call; `doing` names
    /// the operation: "rendering".
    void check(const std::string& doing) const;
    /// Error messages of the driver since the context was made.
    const std::vector<std::string>& complaints() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Keeps a context current for as long as it lives.
class GpuScope {
  public:
    explicit GpuScope(const GpuContext& context) : context_(context), entered_(true) { context_.enter(); }
    /// For destructors: a context that can no longer be entered keeps its objects, and they end with it.
    GpuScope(const GpuContext& context, std::nothrow_t) noexcept
        : context_(context), entered_(context.try_enter()) {}
    ~GpuScope() {
        if (entered_) context_.leave();
    }
    GpuScope(const GpuScope&) = delete;
    GpuScope& operator=(const GpuScope&) = delete;

  private:
    const GpuContext& context_;
    const bool entered_;
};

} // namespace glint::gpu
