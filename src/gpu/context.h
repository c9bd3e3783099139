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
    explicit GpuContext(int device);
    /// The context that is current on this thread, whose owner keeps it so: enter() and leave() do nothing.
    /// Throws Error(device) where it cannot do what the shaders need.
    explicit GpuContext(GpuCurrentContext current);
    ~GpuContext();
    GpuContext(const GpuContext&) = delete;
    GpuContext& operator=(const GpuContext&) = delete;

    const GpuDevice& device() const;
    /// So many bytes stand in the place of the device's own limit.
    void set_max_buffer(std::uint64_t bytes);

    /// Makes it current on this thread. Throws Error(device) where that cannot be: the device is lost, or
    /// another thread has it.
    void enter() const;
    bool try_enter() const noexcept; ///< the same; false in place of an error
    void leave() const;
    bool is_current() const; ///< on this thread

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

/// The same for destructors. A context that cannot be entered any more keeps its objects, and they go with
/// it.
class GpuEnding {
  public:
    explicit GpuEnding(const GpuContext& context) noexcept
        : context_(context), entered_(context.try_enter()) {}
    ~GpuEnding() {
        if (entered_) context_.leave();
    }
    GpuEnding(const GpuEnding&) = delete;
    GpuEnding& operator=(const GpuEnding&) = delete;

  private:
    const GpuContext& context_;
    const bool entered_;
};

} // namespace glint
