#pragma once
// Pictures as OpenGL textures, drawn into the window with the tone curve that files get.

#include "ui_map.h"
#include "window.h"

#include "glint/formats.h"
#include "glint/gpu.h"

#include <array>
#include <memory>

namespace glint::viewer {

class Canvas {
  public:
    /// Needs the window's context. Throws Error(device) if the driver refuses the shader.
    Canvas();
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    /// Puts a linear picture into one of two places, 0 or 1.
    void upload(int place, const Image& image);
    /// Shows one there that is on the graphics card already.
    void show(int place, std::shared_ptr<const GpuPicture> picture);
    /// To be called when what was drawn is on its way to the screen.
    void was_drawn() const;
    bool holds(int place) const { return pictures_[static_cast<std::size_t>(place)].width > 0; }

    /// Draws picture `place` over `area`, cut to `part` of it. Where a pixel of the picture covers one of the
    /// screen or more, its edges stay sharp.
    void draw(int place, const Area& area, const Area& part, View view, const WindowSize& window) const;

  private:
    struct Texture {
        unsigned name = 0;
        int width = 0;
        int height = 0;
        std::shared_ptr<const GpuPicture> on_device; ///< is shown instead, where it is there
    };
    std::array<Texture, 2> pictures_;
    unsigned program_ = 0;
    unsigned sampler_ = 0;
    unsigned points_ = 0; ///< an empty vertex array: the shader makes the corners
    int place_of_corners_ = 0;
    int place_of_curve_ = 0;
};

} // namespace glint::viewer
