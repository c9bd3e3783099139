#pragma once
// Rendering on a graphics card, by OpenGL compute shaders: docs/gpu.md. The picture is that of render() up to
// the rounding of the card: the same samples, the same equations, the same rays.

#include "glint/progressive.h"
#include "glint/render.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace glint {

/// A device that OpenGL can be had from without a window.
struct GpuDevice {
    std::string name;             ///< "NVIDIA RTX A4000", "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string driver;           ///< vendor and version of OpenGL
    std::string fault;            ///< why glint cannot use it; empty where it can
    bool software = false;        ///< runs on the CPU
    std::uint64_t max_buffer = 0; ///< bytes; no part of a scene may be larger
    std::uint64_t buffers = 0;    ///< that a shader can see at once
    std::uint64_t max_group = 0;  ///< invocations of one work group
};

/// All devices, in the order of their numbers. Where there is none at all, `why` says what is missing.
std::vector<GpuDevice> gpu_devices(std::string* why = nullptr);

/// Bounds that a renderer keeps to. 0: what the device allows, or what the renderer learns from its speed.
/// They change the time, never the picture.
struct GpuLimits {
    std::uint64_t buffer = 0; ///< bytes of the largest buffer, where the device allows more
    std::uint32_t pixels = 0; ///< that one dispatch looks at; rounded up to a multiple of 64
    std::uint32_t rays = 0;   ///< of each pixel's tree that one dispatch follows at most
    std::uint32_t steps = 0;  ///< of a pixel's rays through the scene, after which they wait for the next
                              ///< dispatch; a driver may refuse to go on where there are too many
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
    /// their trees (update_scene(), with_view()) the tree stays there. Throws Error(device) for a scene
    /// beyond the device's limits, by name and with the sizes, or where memory runs out: then none is
    /// prepared.
    void prepare(const Scene& scene);

    /// Renders the prepared scene. Of the options show, crop, terms, coverage, progress and cancel count;
    /// Aov::cost has the steps of the GPU's own walk through its own tree. Cancelling ends within one
    /// dispatch, some hundredths of a second. Throws Error(device) where the device is lost, or a ray is in
    /// more than eight transparent solids at once.
    Picture render(const RenderOptions& options = {});

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Stands for the context of OpenGL that is current on the calling thread. Its owner keeps it current
/// wherever what was made in it is used and ended.
struct GpuCurrentContext {};

/// The device of that context, with why glint's shaders cannot run in it, if so.
GpuDevice gpu_device(GpuCurrentContext context);

/// A linear picture that stays on the device: a texture of OpenGL, RGBA in 32-bit floats, its first row the
/// top one. It can be used in every context that shares with the one it was made in, and is let go where such
/// a context is current.
class GpuPicture {
  public:
    ~GpuPicture();
    GpuPicture(const GpuPicture&) = delete;
    GpuPicture& operator=(const GpuPicture&) = delete;

    std::uint32_t texture() const { return texture_; }
    int width() const { return width_; }
    int height() const { return height_; }

    /// To be called after commands that draw it, where they were given: once it is let go, nothing overwrites
    /// it before they are done.
    void was_drawn() const;
    /// Brings it into memory; needs a context to be current.
    Image read() const;

  private:
    friend class GpuPicturePool;
    GpuPicture(int width, int height);
    void leave_to_context();
    void wait_until_drawn();

    std::uint32_t texture_ = 0;
    int width_;
    int height_;
    mutable void* drawn_ = nullptr; ///< a fence of OpenGL
};

/// Progressive on a graphics card: the same passes, and after the last one the bits of GpuRenderer's picture.
/// What `show` of the options asks for is numbers, as of Progressive. To be used by one thread at a time.
class GpuProgressive {
  public:
    /// On a device of its own, by number or the best: see GpuRenderer.
    explicit GpuProgressive(int device = -1);
    /// In a context that is there: a window's, or one that shares with it and is current on another thread.
    /// Throws Error(device) where it is older than OpenGL 4.3 or refuses the shader.
    explicit GpuProgressive(GpuCurrentContext context);
    ~GpuProgressive();
    GpuProgressive(const GpuProgressive&) = delete;
    GpuProgressive& operator=(const GpuProgressive&) = delete;

    const GpuDevice& device() const;

    /// Begins a picture; the kernel of the options does not count. What is on the device of the scene before
    /// stays there: trees that both share, and everything where only camera and size differ. Throws
    /// Error(usage) for an impossible step, and Error(device) as GpuRenderer does: then the picture before is
    /// gone, and none is begun.
    void start(const Scene& scene, const ProgressiveOptions& options = {});

    /// Goes on for about so many seconds, by dispatches of some hundredths of a second, and at least to the
    /// end of the first pass. False when nothing is left to do. After a cancelled call the next goes on where
    /// it stood. Throws Error(device) where the device is lost, or cannot follow a ray: then the picture is
    /// gone, and there is nothing to go on with before the next start().
    bool advance(double seconds);

    const Refinement& reached() const;
    /// The picture so far, as it is now: what is done later is seen in the next one alone. None before the
    /// first pass. For what works in a GpuCurrentContext; the textures of a device of its own cannot be
    /// used outside: see image().
    std::shared_ptr<const GpuPicture> picture() const;
    /// The same, brought into memory; without pixels where there is none.
    Image image() const;
    /// How often the device was given anything of a scene beside its camera.
    int upload_count() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace glint
