#pragma once
// OpenGL contexts beside the window's, and OpenGL's debug messages.

#include <memory>

struct GLFWwindow;

namespace glint::viewer {

class Window;

/// Prints the debug messages of the current context to standard error, from now on.
void print_opengl_messages();
/// Number of messages printed, of all contexts.
int opengl_message_count();

/// OpenGL objects in the current context and those that share with it.
struct OpenGlObjects {
    int textures = 0;
    int buffers = 0;
};
OpenGlObjects opengl_objects();

/// An invisible context that shares objects with the window's, for a thread that renders what the window
/// shows. Created and destroyed on the window's thread.
class SideContext {
  public:
    /// Throws Error(device) without OpenGL 4.3.
    explicit SideContext(const Window& window);
    ~SideContext();
    SideContext(const SideContext&) = delete;
    SideContext& operator=(const SideContext&) = delete;

    /// Makes the context current on the calling thread, always the same one, until the last copy of the
    /// returned pointer is gone.
    std::shared_ptr<void> enter();

  private:
    GLFWwindow* window_ = nullptr;
    bool debug_ = false;
    std::weak_ptr<void> entered_;
};

} // namespace glint::viewer
