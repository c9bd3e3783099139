#pragma once
// Explains one pixel on a thread of its own, and again whenever its scene changes.

#include "glint/explain.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace glint::viewer {

/// Of so many samples of a pixel the rays are kept: more would fill the memory, and nobody looks at them.
inline constexpr int explained_samples = 256;

/// Which pixel is to be explained: of which picture, from where, and how large that is.
struct PixelQuestion {
    int place = 0; ///< as SessionRenderer has places
    CameraDescription camera;
    int width = 0;
    int height = 0;
    int x = 0;
    int y = 0;
};

/// What came of it. Nobody changes it any more.
struct PixelAnswer {
    PixelQuestion question;
    Explanation explanation; ///< rays of the first samples only: see explained_samples
    std::string fault;       ///< why there is none; empty where there is
};

/// All functions may be called by any thread, and none waits for rays to be traced.
class SessionExplainer {
  public:
    /// `changed`: there is an answer; called by the explainer's thread.
    explicit SessionExplainer(std::function<void()> changed);
    /// Ends within milliseconds.
    ~SessionExplainer();
    SessionExplainer(const SessionExplainer&) = delete;
    SessionExplainer& operator=(const SessionExplainer&) = delete;

    /// A scene for a place, or none. Its own camera and size do not count. What is explained there is
    /// explained again, from the camera of its question; without a scene the question is dropped.
    void set_scene(int place, std::optional<Scene> scene);
    /// Explains that pixel in place of the one before, at once.
    void ask(const PixelQuestion& question);
    void forget();

    /// The latest answer to the question asked last; none before there is any.
    std::shared_ptr<const PixelAnswer> latest() const;
    /// Is a question to be answered, for the first time or again?
    bool is_busy() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace glint::viewer
