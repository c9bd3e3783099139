#pragma once
// Contexts of OpenGL beside the window's, and what OpenGL has to say.

#include <memory>

struct GLFWwindow;

namespace glint::viewer {

class Window;

/// Tells standard error what OpenGL complains of in the context that is current, from now on.
void listen_to_opengl();
/// How often it did, in all contexts.
int opengl_complaints();

/// Objects of OpenGL that exist in the current context and those that share with it.
struct OpenGlObjects {
    int textures = 0;
    int buffers = 0;
};
OpenGlObjects opengl_objects();

/// A context that shares with the window's and can draw nowhere: for a thread that works on what the window
/// draws. Made and ended on the window's thread.
class SideContext {
  public:
    /// Throws Error(device) where there is no OpenGL 4.3.
    explicit SideContext(const Window& window);
    ~SideContext();
    SideContext(const SideContext&) = delete;
    SideContext& operator=(const SideContext&) = delete;

    /// Current on the calling thread, always the same one, until the last copy of what is returned is gone.
    std::shared_ptr<void> enter();

  private:
    GLFWwindow* window_ = nullptr;
    bool listens_ = false;
    std::weak_ptr<void> entered_;
};

} // namespace glint::viewer
