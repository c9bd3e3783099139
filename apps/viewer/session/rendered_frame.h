#pragma once
// A rendered picture together with what is known about it.

#include "glint/gpu.h"
#include "glint/image.h"
#include "glint/progressive.h"
#include "glint/scene.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace glint::viewer {

/// A snapshot of one view. Immutable once the renderer has published it.
struct RenderedFrame {
    int width = 0;
    int height = 0;
    Image image; ///< linear, AOVs as visible() maps them to colours; empty while the GPU holds the picture
    std::vector<std::uint32_t> screen;           ///< screen_pixels() of `image`
    std::shared_ptr<const GpuPicture> on_device; ///< the picture in GPU memory; null if `image` holds it
    std::string device;                          ///< GPU that rendered it; empty: the CPU
    std::string why_cpu; ///< why the CPU rendered it although the GPU was selected, with the driver's log
                         ///< after the first line if there is one
    Aov show = Aov::final;
    CameraDescription camera;
    Refinement reached;
    std::uint64_t number = 0; ///< increases from frame to frame
    double rays_per_second = 0;
};

/// The linear picture, read back from the GPU if it is there: then the GPU's context, or one that shares with
/// it, must be current.
inline Image image_of(const RenderedFrame& frame) {
    return frame.on_device ? frame.on_device->read() : frame.image;
}

} // namespace glint::viewer
