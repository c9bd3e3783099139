// Debug messages, counts of objects, and the context for rendering.
#include "opengl.h"

#include "window.h"

#include "glint/error.h"

#include <epoxy/gl.h>

#include <GLFW/glfw3.h>

#include <atomic>
#include <iostream>
#include <string>

namespace glint::viewer {
namespace {

std::atomic<int> message_count{0};

void GLAPIENTRY print_message(GLenum, GLenum, GLuint, GLenum severity, GLsizei, const GLchar* message,
                              const void*) {
    if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
    ++message_count;
    std::cerr << "OpenGL: " + std::string(message) + "\n";
}

} // namespace

void print_opengl_messages() {
    if (epoxy_gl_version() < 43 && !epoxy_has_gl_extension("GL_KHR_debug")) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(print_message, nullptr);
}

int opengl_message_count() { return message_count; }

OpenGlObjects opengl_objects() {
    // Drivers use small names.
    constexpr unsigned max_name = 4096;
    OpenGlObjects found;
    for (unsigned name = 1; name < max_name; ++name) {
        found.textures += glIsTexture(name) == GL_TRUE;
        found.buffers += glIsBuffer(name) == GL_TRUE;
    }
    return found;
}

SideContext::SideContext(const Window& window) : debug_(window.is_debugging_opengl()) {
    // GLFW keeps the window's hints: contexts that share must have the same robustness.
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    window_ = glfwCreateWindow(16, 16, "", nullptr, window.handle());
    if (window_ == nullptr)
        throw Error(ErrorKind::device, "the window's OpenGL has no 4.3, which compute shaders need",
                    "the CPU needs none of it");
}

SideContext::~SideContext() { glfwDestroyWindow(window_); }

std::shared_ptr<void> SideContext::enter() {
    std::shared_ptr<void> held = entered_.lock();
    if (held != nullptr) return held;
    glfwMakeContextCurrent(window_);
    if (debug_) print_opengl_messages();
    held = std::shared_ptr<void>(window_, [](void*) { glfwMakeContextCurrent(nullptr); });
    entered_ = held;
    return held;
}

} // namespace glint::viewer
