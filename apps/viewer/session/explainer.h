#pragma once
// Explains one pixel on a thread of its own, and again whenever its scene changes.

#include "view_slot.h"

#include "glint/explain.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace glint::viewer {

/// Rays are kept for this many samples of a pixel: more would fill the memory, and nobody looks at them.
inline constexpr int explained_samples = 256;

/// The pixel to explain: in which view, seen from where, and the size of that picture.
struct PixelQuestion {
    ViewSlot slot = ViewSlot::main;
    CameraDescription camera;
    int width = 0;
    int height = 0;
    int x = 0;
    int y = 0;
};

/// Immutable once it is published.
struct PixelAnswer {
    PixelQuestion question;
    Explanation explanation; ///< rays of the first samples only: see explained_samples
    std::string fault;       ///< why there is no explanation; empty if there is one
};

/// Thread-safe. No call waits for rays to be traced.
class SessionExplainer {
  public:
    /// `changed`: there is an answer; called on the explainer's thread.
    explicit SessionExplainer(std::function<void()> changed);
    /// Ends within milliseconds.
    ~SessionExplainer();
    SessionExplainer(const SessionExplainer&) = delete;
    SessionExplainer& operator=(const SessionExplainer&) = delete;

    /// The scene of a view, or none. Its own camera and size are ignored. A pixel of that view is explained
    /// again, with the camera of its question; without a scene the question is dropped.
    void set_scene(ViewSlot slot, std::optional<Scene> scene);
    /// Explains this pixel, at once, instead of the one before.
    void ask(const PixelQuestion& question);
    void forget();

    /// The latest answer to the last question; null before the first.
    std::shared_ptr<const PixelAnswer> latest() const;
    /// Is a question waiting for its first or its next answer?
    bool is_busy() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace glint::viewer
