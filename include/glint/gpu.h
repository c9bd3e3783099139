#pragma once
// Rendering on a graphics card, by OpenGL compute shaders: docs/gpu.md. The picture is that of render() up to
// the rounding of the card: the same samples, the same equations, the same rays.

#include "glint/render.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace glint {

/// A device that OpenGL can be had from without a window.
struct GpuDevice {
    std::string name;                 ///< "NVIDIA RTX A4000", "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string driver;               ///< vendor and version of OpenGL
    std::string fault;                ///< why glint cannot use it; empty where it can
    bool software = false;            ///< runs on the CPU
    std::uint64_t largest_buffer = 0; ///< bytes; no part of a scene may be larger
    std::uint64_t buffers = 0;        ///< that a shader can see at once
    std::uint64_t largest_group = 0;  ///< invocations of one work group
};

/// All devices, in the order of their numbers. Where there is none at all, `why` says what is missing.
std::vector<GpuDevice> gpu_devices(std::string* why = nullptr);

/// Bounds that a renderer keeps to. 0: what the device allows, or what the renderer learns from its speed.
/// They change the time, never the picture.
struct GpuLimits {
    std::uint64_t buffer = 0; ///< bytes of the largest buffer
    std::uint32_t pixels = 0; ///< that one dispatch looks at; rounded up to a multiple of 64
    std::uint32_t rays = 0;   ///< of each pixel's tree that one dispatch follows
};

/// Renders on one device. To be used by one thread at a time.
class GpuRenderer {
  public:
    /// The device of that number, or with −1 the first that can be used, those of hardware before software.
    /// Throws Error(device) where there is none, or where the driver refuses the shader.
    explicit GpuRenderer(int device = -1, const GpuLimits& limits = {});
    ~GpuRenderer();
    GpuRenderer(GpuRenderer&&) noexcept;
    GpuRenderer& operator=(GpuRenderer&&) noexcept;

    const GpuDevice& device() const;

    /// Lays a scene in the device's memory for render(), in place of the one before; of scenes that share
    /// their trees (refreeze(), with_view()) the tree stays there. Throws Error(device) for a scene beyond
    /// the device's limits, by name and with the sizes, or where memory runs out: then none is prepared.
    void prepare(const Scene& scene);

    /// Renders the prepared scene. Of the options show, crop, terms, coverage, progress and cancel count;
    /// Aspect::cost has the steps of the GPU's own walk through its own tree. Cancelling ends within one
    /// dispatch, some hundredths of a second. Throws Error(device) where the device is lost, or a ray is in
    /// more than eight transparent solids at once.
    Picture render(const RenderOptions& options = {});

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace glint
