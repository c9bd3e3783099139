#pragma once
// Where a picture is rendered: on the CPU or on a graphics card.

#include "arguments.h"
#include "console.h"

#include "glint/gpu.h"

#include <string>

namespace glint::cli {

/// A picture and, where it came from a graphics card, the name of that.
struct RenderedPicture {
    Picture picture;
    std::string device; ///< empty: the CPU
};

/// Renders where --backend says; what is not light, on the CPU. `auto` takes a graphics card where there is
/// one, and says in one line why it takes the CPU instead. Throws Error(device) where --backend gpu cannot be
/// had.
RenderedPicture render_on_backend(const Arguments& arguments, const Scene& scene,
                                  const RenderOptions& options, Console& console);

/// The devices as text for `glint info --devices`.
std::string devices_text();

} // namespace glint::cli
