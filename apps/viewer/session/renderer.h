#pragma once
// Pictures of scenes on a thread of their own: first soon, then better, and begun anew whenever something
// changes.

#include "painter.h"

#include "glint/formats.h"
#include "glint/progressive.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glint::viewer {

/// A picture as it was at one moment. Nobody changes it any more.
struct Frame {
    int width = 0;
    int height = 0;
    Image image; ///< linear; aspects as visible() shows them. Empty where a graphics card keeps the picture
    std::vector<std::uint32_t> screen;           ///< screen_pixels() of that image
    std::shared_ptr<const GpuPicture> on_device; ///< a picture that a graphics card keeps
    std::string device;                          ///< what drew it; empty: the CPU
    std::string why_cpu; ///< why the CPU drew it though a graphics card was to, with the
                         ///< driver's log if there is one
    Aspect show = Aspect::final;
    CameraDescription camera;
    Refinement reached;
    std::uint64_t number = 0; ///< each is higher than that of the frame before
    double rays_per_second = 0;
};

/// Brought back from a graphics card where it keeps the picture: then its context, or one that shares with
/// it, must be current.
inline Image image_of(const Frame& frame) { return frame.on_device ? frame.on_device->read() : frame.image; }

/// Two places have pictures: 0 is the scene, 1 what it is compared with.
inline constexpr int picture_places = 2;

/// All functions may be called by any thread, and none waits for rendering.
class SessionRenderer {
  public:
    struct Options {
        int threads = 0; ///< 0: one for each core
        /// How long the first picture after a change may take: it is as coarse as that needs.
        double first_picture_seconds = 0.020;
        std::function<void()> changed; ///< there is a new frame; called by the renderer's thread
    };

    explicit SessionRenderer(Options options);
    /// Ends within milliseconds.
    ~SessionRenderer();
    SessionRenderer(const SessionRenderer&) = delete;
    SessionRenderer& operator=(const SessionRenderer&) = delete;

    /// A scene for a place, or none. Its own camera and size do not count.
    void set_scene(int place, std::optional<Scene> scene);
    void set_show(int place, Aspect show);
    /// Which way rays take through meshes.
    void set_kernel(Kernel kernel);
    /// How pictures become colours of the screen. Nothing is rendered anew.
    void set_tone(View tone);
    /// From where all places are seen, and how large.
    void set_view(const CameraDescription& camera, int width, int height);
    /// Who draws: the graphics card whose painters `gpu` makes, or the CPU. What is shown stays until there
    /// is something not coarser: once every pixel is known, a picture with one ray through each replaces an
    /// antialiased one. What the card cannot draw, and all after a fault of it, the CPU draws; the card is
    /// tried again with the next scene or the next call.
    void set_backend(PainterMaker gpu);

    /// The latest picture of a place; none before there is any, or where there is no scene.
    std::shared_ptr<const Frame> latest(int place) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace glint::viewer
