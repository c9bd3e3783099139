#pragma once
// Rendering on a graphics card with OpenGL compute shaders: docs/gpu.md. Pictures equal those of render() up
// to the rounding of the card: same samples, equations and rays.

#include "glint/progressive.h"
#include "glint/render.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace glint {

namespace gpu {
class GpuPicturePool;
}

/// A device that offers OpenGL without a window.
struct GpuDevice {
    std::string name;             ///< "NVIDIA RTX A4000", "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string driver;           ///< vendor and version of OpenGL
    std::string fault;            ///< why glint cannot use it; empty if it can
    bool software = false;        ///< runs on the CPU
    std::uint64_t max_buffer = 0; ///< largest size of a buffer in bytes, which limits every array of a scene
    std::uint64_t buffers = 0;    ///< number of storage buffers available to a shader
    std::uint64_t max_group = 0;  ///< largest number of invocations in a work group
};

/// All devices in order of their numbers. If there is none, `*why` explains what is missing.
std::vector<GpuDevice> gpu_devices(std::string* why = nullptr);

/// Limits for a renderer. 0: the limit of the device, or adapted to its speed. They affect time, never the
/// picture.
struct GpuLimits {
    std::uint64_t buffer = 0; ///< largest buffer in bytes, if below that of the device
    std::uint32_t pixels = 0; ///< pixels per dispatch; rounded up to a multiple of 64
    std::uint32_t rays = 0;   ///< rays of each pixel per dispatch
    std::uint32_t steps = 0;  ///< traversal steps per pixel and dispatch, after which rays wait for the next
                              ///< one; drivers may abort dispatches that take too long
};

/// Renders on one device. For use by one thread at a time.
class GpuRenderer {
  public:
    /// Uses the device with that number; −1: the first usable one, hardware before software. Throws
    /// Error(device) if there is none or the driver rejects the shader.
    explicit GpuRenderer(int device = -1, const GpuLimits& limits = {});
    ~GpuRenderer();
    GpuRenderer(GpuRenderer&&) noexcept;
    GpuRenderer& operator=(GpuRenderer&&) noexcept;

    const GpuDevice& device() const;

    /// Uploads a scene for render(), replacing the previous one; a tree shared with it (update_scene(),
    /// with_view()) is not uploaded again. Throws Error(device) for a scene beyond the device's limits,
    /// naming these and the sizes, or if memory runs out; then no scene is prepared.
    void prepare(const Scene& scene);

    /// Renders the prepared scene. Uses show, crop, terms, coverage, progress and cancel of the options;
    /// Aov::cost counts steps of the GPU's own traversal. Cancelling takes effect within one dispatch, some
    /// hundredths of a second. Throws Error(device) if the device is lost, or if a ray is inside more than
    /// eight transparent solids at once.
    Picture render(const RenderOptions& options = {});

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Denotes the OpenGL context current on the calling thread. The caller keeps it current while using or
/// destroying objects made in it.
struct GpuCurrentContext {};

/// The device of that context, with the reason if it cannot run glint's shaders.
GpuDevice gpu_device(GpuCurrentContext context);

/// A linear picture on the device: an OpenGL texture, RGBA in 32-bit floats, top row first. It can be used in
/// all contexts that share objects with the one it was made in, and must be destroyed while such a context is
/// current.
class GpuPicture {
  public:
    ~GpuPicture();
    GpuPicture(const GpuPicture&) = delete;
    GpuPicture& operator=(const GpuPicture&) = delete;

    std::uint32_t texture() const { return texture_; }
    int width() const { return width_; }
    int height() const { return height_; }

    /// To be called after issuing commands that read the texture: it is not overwritten before these
    /// complete.
    void was_drawn() const;
    /// Reads it back to memory; a context must be current.
    Image read() const;

  private:
    friend class gpu::GpuPicturePool;
    GpuPicture(int width, int height);
    void leave_to_context();
    void wait_until_drawn();

    std::uint32_t texture_ = 0;
    int width_;
    int height_;
    mutable void* drawn_ = nullptr; ///< an OpenGL fence
};

/// Progressive rendering on a graphics card, with the passes of Progressive; the final picture equals
/// GpuRenderer's bit for bit. The values for `show` are raw, as with Progressive. For use by one thread at a
/// time.
class GpuProgressive {
  public:
    /// Uses a device of its own, see GpuRenderer.
    explicit GpuProgressive(int device = -1);
    /// Uses the current context: a window's, or one that shares with it on another thread. Throws
    /// Error(device) if it is older than OpenGL 4.3 or rejects the shader.
    explicit GpuProgressive(GpuCurrentContext context);
    ~GpuProgressive();
    GpuProgressive(const GpuProgressive&) = delete;
    GpuProgressive& operator=(const GpuProgressive&) = delete;

    const GpuDevice& device() const;

    /// Starts a picture; the kernel of the options is ignored. Data shared with the previous scene stays on
    /// the device: shared trees, and everything if only camera and size differ. Throws Error(usage) for an
    /// invalid step, and Error(device) as GpuRenderer does; then the previous picture is lost and none
    /// is started.
    void start(const Scene& scene, const ProgressiveOptions& options = {});

    /// Continues for about `seconds` in dispatches of some hundredths of a second, at least to the end of the
    /// first pass. Returns false if there is nothing left to do. After cancelling, the next call continues.
    /// Throws Error(device) if the device is lost or cannot trace a ray; then the picture is lost until the
    /// next start().
    bool advance(double seconds);

    const Refinement& reached() const;
    /// The picture so far; later work appears only in later results. None before the first pass. Only for a
    /// GpuCurrentContext: textures of an own device cannot be used outside, see image().
    std::shared_ptr<const GpuPicture> picture() const;
    /// The picture so far, read back to memory; empty if there is none.
    Image image() const;
    /// Number of scene uploads, not counting camera changes.
    int upload_count() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace glint
