#pragma once
// Where a picture is rendered: on the CPU or on a graphics card.

#include "arguments.h"
#include "console.h"

#include "glint/gpu.h"

#include <optional>
#include <string>

namespace glint::cli {

/// A picture and, where it came from a graphics card, the name of that.
struct RenderedPicture {
    Picture picture;
    std::string device; ///< empty: the CPU
};

/// What --backend asks for, kept from picture to picture: the card's programs, and what it holds of a scene.
class Backend {
  public:
    Backend(const Arguments& arguments, Console& console);

    /// Renders where --backend says. `auto` takes a graphics card where there is one, and says in one line
    /// why it takes the CPU instead; with -v all of what a driver says. Throws Error(device) where --backend
    /// gpu cannot be had.
    RenderedPicture render(const Scene& scene, const RenderOptions& options);

    /// The same, but nothing where the CPU would render.
    std::optional<RenderedPicture> render_on_card(const Scene& scene, const RenderOptions& options);

  private:
    void tell(const std::string& why);
    RenderedPicture on_gpu(const Scene& scene, const RenderOptions& options);

    std::string wanted_; ///< cpu, gpu or auto
    Console& console_;
    std::optional<GpuRenderer> gpu_;
    std::string told_; ///< why the CPU renders, as it was said last
};

/// The devices as text for `glint info --devices`.
std::string devices_text();

} // namespace glint::cli
