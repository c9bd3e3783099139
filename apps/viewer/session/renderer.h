#pragma once
// Renders the views of a session on a thread of its own: a coarse picture soon, then better ones, from the
// start again whenever something changes.

#include "backend.h"
#include "rendered_frame.h"
#include "view_slot.h"

#include "glint/kernels.h"
#include "glint/picture_files.h"

#include <functional>
#include <memory>
#include <optional>

namespace glint::viewer {

/// Thread-safe. No call waits for rendering.
class SessionRenderer {
  public:
    struct Options {
        int threads = 0; ///< 0: one for each processor
        /// How long the first picture after a change may take; sets how coarse it is.
        double first_picture_seconds = 0.020;
        std::function<void()> changed; ///< there is a new frame; called on the renderer's thread
    };

    explicit SessionRenderer(Options options);
    /// Ends within milliseconds.
    ~SessionRenderer();
    SessionRenderer(const SessionRenderer&) = delete;
    SessionRenderer& operator=(const SessionRenderer&) = delete;

    /// The scene of a view, or none. Its own camera and size are ignored.
    void set_scene(ViewSlot slot, std::optional<Scene> scene);
    void set_show(ViewSlot slot, Aov show);
    /// How meshes are traversed: changes the time, never the picture.
    void set_kernel(Kernel kernel);
    /// How linear light becomes colours of the screen. Nothing is rendered again.
    void set_tone(View tone);
    /// Camera and size of all views.
    void set_camera(const CameraDescription& camera, int width, int height);
    /// Renders with the GPU backends that `gpu` creates, or, if it is empty, on the CPU. The frame shown
    /// stays until there is one that is not coarser; with every pixel known, one sample a pixel replaces an
    /// antialiased picture. Scenes that the GPU cannot render, and all after a fault of it, the CPU renders;
    /// the GPU is tried again with the next scene or the next call.
    void set_backend(BackendFactory gpu);

    /// The latest frame of a view; null before the first one, and without a scene.
    std::shared_ptr<const RenderedFrame> latest(ViewSlot slot) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace glint::viewer
