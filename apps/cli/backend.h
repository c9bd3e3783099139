#pragma once
// Renders on the CPU or on a graphics card, as --backend asks.

#include "arguments.h"
#include "console.h"

#include "glint/gpu.h"

#include <optional>
#include <string>

namespace glint::cli {

/// A picture and the device that rendered it.
struct RenderedPicture {
    Picture picture;
    std::string device; ///< empty: the CPU
};

/// Keeps the graphics card's programs and buffers from picture to picture.
class Backend {
  public:
    Backend(const Arguments& arguments, Console& console);

    /// `auto` uses a graphics card if there is one; else it reports in a line why the CPU renders, with -v
    /// including the driver's log. Throws Error(device) if --backend gpu is impossible.
    RenderedPicture render(const Scene& scene, const RenderOptions& options);

    /// The same, but none if the CPU would render.
    std::optional<RenderedPicture> render_on_card(const Scene& scene, const RenderOptions& options);

  private:
    void report_fallback(const std::string& why);
    RenderedPicture render_on_gpu(const Scene& scene, const RenderOptions& options);

    std::string wanted_; ///< cpu, gpu or auto
    Console& console_;
    std::optional<GpuRenderer> gpu_;
    std::string reported_; ///< the last reason reported
};

/// The devices as text for `glint info --devices`.
std::string devices_text();

} // namespace glint::cli
