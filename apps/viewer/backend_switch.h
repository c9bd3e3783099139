#pragma once
// Selects what renders the pictures, and reports why the CPU stands in for the graphics card.

#include "opengl.h"
#include "session/backend.h"

#include <optional>
#include <string>

namespace glint::viewer {

class Messages;
class Session;
class Window;
struct RenderedFrame;

/// Must outlive the session: the session's GPU backends render in its OpenGL context.
class BackendSwitch {
  public:
    explicit BackendSwitch(const Window& window) : window_(window) {}

    /// Makes the session render on the graphics card or on the CPU. True if that is a change.
    bool select(bool gpu, Session& session);
    /// If the CPU rendered the latest frame although the card is selected, shows the reason once.
    void check(const RenderedFrame& frame, Messages& messages);
    /// Why the CPU rendered the last frame; empty if it was selected, or the card rendered.
    const std::string& why_cpu() const { return why_cpu_; }

  private:
    BackendFactory gpu_factory();

    const Window& window_;
    std::optional<SideContext> context_; ///< created when the card is first selected
    bool gpu_ = false;
    std::string why_cpu_;
};

} // namespace glint::viewer
