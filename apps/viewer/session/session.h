#pragma once
// Everything behind the window that is not a window: the scene file shown, its camera, its pictures. No call
// waits for reading, building or rendering.

#include "camera.h"
#include "explainer.h"
#include "loader.h"
#include "renderer.h"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace glint::viewer {

struct SessionOptions {
    LoadOptions load;
    int threads = 0;   ///< 0: one for each processor
    bool watch = true; ///< reload files when they or their meshes change
    int width = 800;
    int height = 600;
    double first_picture_seconds = 0.020;
    /// There is a new frame, scene or status. Called on other threads; may wake the UI.
    std::function<void()> changed;
};

/// For one thread, the UI's; the work is done on others. Ends within half a second, whatever is under way.
class Session {
  public:
    explicit Session(SessionOptions options = {});

    // ── Files ──────────────────────────────────────────────────────────────────────────────────────────────

    /// Reads a scene or a mesh in the background. The scene shown stays until the new one is ready.
    void open(const std::string& path) { loader_.open(path); }
    /// Reads the file again and keeps the camera, as happens by itself when a file changes.
    void reload() { loader_.reload(); }
    void cancel_loading() { loader_.cancel(); }
    /// What is being read, and why the last file could not be shown.
    LoadStatus load_status() const { return loader_.status(); }

    /// The scene shown, with edits; none before the first one.
    std::optional<LoadedFile> scene() const;

    // ── Values ─────────────────────────────────────────────────────────────────────────────────────────────

    /// Shows the scene with other values: materials, lights and settings at once, objects after their trees
    /// are rebuilt. Camera and size are ignored. Invalid values are reported by load_status().
    void edit(SceneDescription description) { loader_.edit(ViewSlot::main, std::move(description)); }
    /// Shows other values in the reference view, from the same camera; none ends the comparison.
    void compare(std::optional<SceneDescription> description);
    bool is_comparing() const;
    void set_show(Aov show, ViewSlot slot = ViewSlot::main);
    Aov show(ViewSlot slot = ViewSlot::main) const { return show_[slot]; }
    /// How meshes are traversed: changes the time, never the picture.
    void set_kernel(Kernel kernel);
    Kernel kernel() const { return kernel_; }
    /// With the sRGB curve, as in files, or linear values unchanged.
    void set_tone(View tone) { renderer_.set_tone(tone); }

    /// See SessionRenderer::set_backend().
    void set_backend(BackendFactory gpu) { renderer_.set_backend(std::move(gpu)); }

    // ── View ───────────────────────────────────────────────────────────────────────────────────────────────

    /// Changes the camera: session.move([](CameraControl& c) { c.orbit(0.1, 0); }).
    void move(const std::function<void(CameraControl&)>& change);
    /// Moves the camera around what the middle of the picture shows, as CameraControl::orbit(). A target so
    /// picked stays while the camera only orbits or zooms; so does any target while the middle shows nothing.
    /// The eye does not pass through a wall, that is a flat object or a solid that it is in: it stays before
    /// it, nearer to the target.
    void orbit(double right, double up);
    CameraControl camera() const;
    void resize(int width, int height);
    int width() const { return width_; }
    int height() const { return height_; }

    /// The scene of a view with the current camera and size, for pick(), explain(), render() and files. None
    /// before the first scene.
    std::optional<Scene> scene_in_view(ViewSlot slot = ViewSlot::main) const;

    /// The latest picture of a view; null before there is any.
    std::shared_ptr<const RenderedFrame> frame(ViewSlot slot = ViewSlot::main) const {
        return renderer_.latest(slot);
    }

    /// Explains a pixel in the background, with the current camera; again, with the same camera, whenever the
    /// scene of its view changes. Replaces an earlier question.
    void explain(ViewSlot slot, int x, int y);
    void stop_explaining() { explainer_.forget(); }
    /// The latest answer; null before there is any.
    std::shared_ptr<const PixelAnswer> explained() const { return explainer_.latest(); }
    bool is_explaining() const { return explainer_.is_busy(); }

  private:
    SessionLoader::Options loader_options();
    // Called on the loader's thread.
    void show_file(LoadedFile file);
    void show_edit(ViewSlot slot, Scene edited);
    // With `mutex_` held.
    CameraControl home(const Scene& scene) const;
    void pick_orbit_target();
    void stay_before_walls(const Vec3& from);
    void set_scene(ViewSlot slot, std::optional<Scene> scene);

    const SessionOptions options_;

    // Of the UI's thread alone.
    PerView<Aov> show_;
    Kernel kernel_ = Kernel::automatic;

    mutable std::mutex mutex_;
    // Guarded by `mutex_`; as only the UI's thread writes the size, that thread reads it without.
    int width_;
    int height_;
    std::optional<LoadedFile> scene_;
    PerView<std::optional<Scene>> scenes_; ///< as edited
    bool comparing_ = false;
    CameraControl camera_;

    // Thread-safe. Last, so that they end first: their threads call back.
    SessionRenderer renderer_;
    SessionExplainer explainer_;
    SessionLoader loader_;
};

} // namespace glint::viewer
