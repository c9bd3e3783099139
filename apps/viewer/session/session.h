#pragma once
// Everything behind the window that is not a window: the scene file shown, its camera, its pictures. No call
// waits for reading, building or rendering.

#include "camera.h"
#include "explainer.h"
#include "loader.h"
#include "renderer.h"

#include "glint/pick.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glint::viewer {

struct SessionOptions {
    LoadOptions load;
    int threads = 0;   ///< 0: one for each core
    bool watch = true; ///< reload files when they or their meshes change
    int width = 800;
    int height = 600;
    double first_picture_seconds = 0.020;
    /// There is a new frame, scene or status. Called on other threads; may wake the UI.
    std::function<void()> changed;
};

/// The scene that is shown.
struct SessionScene {
    std::string path;
    Scene scene; ///< with the camera and size of the file
    std::vector<Diagnostic> warnings;
    std::vector<std::string> notes;
    std::uint64_t loads = 0; ///< number of files shown so far; edits do not count
};

/// For one thread, the UI's; the work is done on others.
class Session {
  public:
    explicit Session(SessionOptions options = {});
    /// Ends within half a second, whatever is under way.
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // ── Files ──────────────────────────────────────────────────────────────────────────────────────────────

    /// Reads a scene or a mesh in the background. The scene shown stays until the new one is ready.
    void open(const std::string& path);
    /// Reads the file again and keeps the camera, as happens by itself when a file changes.
    void reload();
    void cancel_loading();
    /// What is being read, and why the last file could not be shown.
    LoadStatus load_status() const;

    /// The scene shown; none before the first one.
    std::optional<SessionScene> scene() const;

    // ── Values ─────────────────────────────────────────────────────────────────────────────────────────────

    /// Shows the scene with other values: materials, lights and settings at once, objects after their trees
    /// are rebuilt. Camera and size are ignored. Invalid values are reported by load_status().
    void edit(SceneDescription description);
    /// Shows other values in the reference view, from the same camera; none ends the comparison.
    void compare(std::optional<SceneDescription> description);
    bool is_comparing() const;
    void set_show(Aov show, ViewSlot slot = ViewSlot::main);
    Aov show(ViewSlot slot = ViewSlot::main) const;
    /// How meshes are traversed: changes the time, never the picture.
    void set_kernel(Kernel kernel);
    Kernel kernel() const;
    /// With the sRGB curve, as in files, or linear values unchanged.
    void set_tone(View tone);

    /// See SessionRenderer::set_backend().
    void set_backend(BackendFactory gpu);

    // ── View ───────────────────────────────────────────────────────────────────────────────────────────────

    /// Changes the camera: session.move([](CameraControl& c) { c.orbit(0.1, 0); }).
    void move(const std::function<void(CameraControl&)>& change);
    /// Call before the camera orbits: sets the orbit's target to what the middle of the picture shows. A
    /// target so picked stays while the camera only orbits or zooms; so does any target while the middle
    /// shows nothing.
    void pick_orbit_target();
    CameraControl camera() const;
    void resize(int width, int height);
    int width() const;
    int height() const;

    /// The scene of a view with the current camera and size, for pick(), explain(), render() and files. None
    /// before the first scene.
    std::optional<Scene> scene_in_view(ViewSlot slot = ViewSlot::main) const;
    /// The first hit at a point of the main view, in pixels from the top left.
    std::optional<Pick> pick(double x, double y) const;

    /// The latest picture of a view; null before there is any.
    std::shared_ptr<const RenderedFrame> frame(ViewSlot slot = ViewSlot::main) const;

    /// Explains a pixel in the background, with the current camera; again, with the same camera, whenever the
    /// scene of its view changes. Replaces an earlier question.
    void explain(ViewSlot slot, int x, int y);
    void stop_explaining();
    /// The latest answer; null before there is any.
    std::shared_ptr<const PixelAnswer> explained() const;
    bool is_explaining() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace glint::viewer
