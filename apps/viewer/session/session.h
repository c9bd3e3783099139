#pragma once
// Everything behind the window that is no window: a scene file being shown, its camera, its pictures. No call
// waits for reading, freezing or rendering.

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
    bool watch = true; ///< read files again when they or their meshes change
    int width = 800;
    int height = 600;
    double first_picture_seconds = 0.020;
    /// There is something new: a frame, a scene, a status. Called by other threads; it may end the UI's wait.
    std::function<void()> changed;
};

/// What is shown, as values.
struct SessionScene {
    std::string path;
    Scene scene; ///< as frozen; camera and size are those of the file
    std::vector<Diagnostic> warnings;
    std::vector<std::string> notes;
    std::uint64_t loads = 0; ///< how many files were shown so far; edits do not count
};

/// For one thread, the UI's; the work is done by others.
class Session {
  public:
    explicit Session(SessionOptions options = {});
    /// Ends within half a second whatever is under way.
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // ── Files ──────────────────────────────────────────────────────────────────────────────────────────────

    /// Reads a scene or a mesh in the background. What is shown stays until there is something better.
    void open(const std::string& path);
    /// Reads the file again; the camera stays where it is. The same happens by itself when files change.
    void reload();
    void cancel_loading();
    /// What is being read, and why the last file could not be shown.
    LoadStatus load_status() const;

    /// What is shown; none before the first scene.
    std::optional<SessionScene> scene() const;

    // ── Values ─────────────────────────────────────────────────────────────────────────────────────────────

    /// Shows the scene with other values: materials, lights and settings without delay, objects after their
    /// trees are built anew. Camera and size are not taken. Errors of meaning come in load_status().
    void edit(SceneDescription description);
    /// A second picture of the same view, from other values; none ends it.
    void compare(std::optional<SceneDescription> description);
    bool is_comparing() const;
    void set_show(Aspect show, int place = 0);
    Aspect show(int place = 0) const;
    /// Which way rays take through meshes: shows in the time alone.
    void set_kernel(Kernel kernel);
    Kernel kernel() const;
    /// With the sRGB curve, as files have it, or plain numbers.
    void set_tone(View tone);

    /// Who draws: see SessionRenderer.
    void set_backend(PainterMaker gpu);

    // ── View ───────────────────────────────────────────────────────────────────────────────────────────────

    /// Changes the camera: session.move([](CameraControl& c) { c.orbit(0.1, 0); }).
    void move(const std::function<void(CameraControl&)>& change);
    /// Before the camera turns: around what the picture's middle shows. Where it was so aimed already, and
    /// only turned or zoomed since, the target stays; so it does where there is nothing in the middle.
    void aim();
    CameraControl camera() const;
    void resize(int width, int height);
    int width() const;
    int height() const;

    /// The scene as it is seen now: for pick(), explain(), render() and files. None before the first scene.
    std::optional<Scene> view(int place = 0) const;
    /// What stands at a place of the picture, in pixels from the top left.
    std::optional<Pick> pick(double x, double y) const;

    /// The latest picture; none before there is any.
    std::shared_ptr<const Frame> frame(int place = 0) const;

    /// Explains a pixel of the picture in the background, as it is seen now; again whenever the scene of that
    /// picture changes, from the same camera. Overtakes what was asked before.
    void explain(int place, int x, int y);
    void stop_explaining();
    /// The latest answer; none before there is any.
    std::shared_ptr<const PixelAnswer> explained() const;
    bool is_explaining() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace glint::viewer
