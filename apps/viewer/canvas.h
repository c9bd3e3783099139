#pragma once
// The pictures of both views as OpenGL textures, drawn into the window.

#include "session/view_slot.h"
#include "ui_map.h"
#include "window.h"

#include "glint/gpu.h"
#include "glint/picture_files.h"

#include <glm/vec3.hpp>

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

    /// Uploads a view's picture, packed by screen_pixels().
    void upload(ViewSlot slot, int width, int height, const std::vector<std::uint32_t>& pixels);
    /// Shows a picture that is on the graphics card already, in linear light, instead of an upload.
    void show(ViewSlot slot, std::shared_ptr<const GpuPicture> picture);
    /// Releases what show() holds.
    void drop(ViewSlot slot) { pictures_[slot].on_device.reset(); }
    /// Call after the commands of draw() have been submitted: see GpuPicture::was_drawn().
    void was_drawn() const;

    /// Reads a pixel of a picture on the graphics card, in linear light; (0, 0) is top left.
    static glm::vec3 pixel_of(const GpuPicture& picture, int x, int y);

    /// Draws a view's picture over `area`, clipped to `part` of it; magnified pixels keep sharp edges.
    /// `view`: the tone of pictures on the graphics card. Uploaded ones are in colours of the screen.
    void draw(ViewSlot slot, const Area& area, const Area& part, View view, const WindowSize& window) const;

  private:
    struct Texture {
        unsigned name = 0;
        int width = 0;
        int height = 0;
        std::shared_ptr<const GpuPicture> on_device; ///< shown instead of the texture, if not null
    };
    struct Program {
        explicit Program(const char* fragment_source);
        unsigned name;
        int corners; ///< location of the uniform
    };
    PerView<Texture> pictures_;
    Program plain_; ///< copies values
    Program srgb_;  ///< applies the sRGB curve
    unsigned sampler_ = 0;
    unsigned points_ = 0; ///< an empty vertex array: the shader computes the corners
};

} // namespace glint::viewer
