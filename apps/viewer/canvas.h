#pragma once
// Pictures as OpenGL textures, drawn into the window.

#include "ui_map.h"
#include "window.h"

#include "glint/formats.h"
#include "glint/gpu.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace glint::viewer {

class Canvas {
  public:
    /// Needs the window's context. Throws Error(device) if the driver refuses the shader.
    Canvas();
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    /// Puts a picture, as screen_pixels() packs it, into one of two places, 0 or 1.
    void upload(int place, int width, int height, const std::vector<std::uint32_t>& pixels);
    /// Shows one there that is on the graphics card already, in linear light.
    void show(int place, std::shared_ptr<const GpuPicture> picture);
    /// Lets go of what show() put there.
    void drop(int place) { pictures_[static_cast<std::size_t>(place)].on_device.reset(); }
    /// To be called when what was drawn is on its way to the screen.
    void was_drawn() const;

    /// A pixel of a picture that is on the graphics card, in linear light; (0, 0) is top left.
    static glm::vec3 pixel_of(const GpuPicture& picture, int x, int y);

    /// Draws picture `place` over `area`, cut to `part` of it. Where a pixel of the picture covers one of the
    /// screen or more, its edges stay sharp. `view` is for pictures of the graphics card: uploaded ones are
    /// in the colours of the screen.
    void draw(int place, const Area& area, const Area& part, View view, const WindowSize& window) const;

  private:
    struct Texture {
        unsigned name = 0;
        int width = 0;
        int height = 0;
        std::shared_ptr<const GpuPicture> on_device; ///< is shown instead, where it is there
    };
    struct Program {
        explicit Program(const char* fragment_source);
        unsigned name;
        int corners; ///< the place of that uniform
    };
    std::array<Texture, 2> pictures_;
    Program plain_, bent_; ///< with the picture's values as they are, and by the curve of sRGB
    unsigned sampler_ = 0;
    unsigned points_ = 0; ///< an empty vertex array: the shader makes the corners
};

} // namespace glint::viewer
