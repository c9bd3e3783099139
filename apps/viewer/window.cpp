// GLFW, its callbacks, and the frame around Dear ImGui.
#include "window.h"

#include "opengl.h"

#include "glint/error.h"

#include <epoxy/gl.h>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace glint::viewer {
namespace {

constexpr const char* glsl_version = "#version 330 core";

/// GLFW reports errors to a callback only.
std::string& last_error() {
    static std::string text;
    return text;
}

[[noreturn]] void refuse_display() {
    const bool named = std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
    throw Error(ErrorKind::device,
                named ? "no window can be opened (" + last_error() + ")"
                      : "there is no display to open a window on",
                "render to a file instead: glint FILE -o picture.png");
}

} // namespace

Window::Window(std::pair<int, int> size, const std::string& title, bool debug) : debug_(debug) {
    glfwSetErrorCallback([](int, const char* text) { last_error() = text; });
    if (glfwInit() != GLFW_TRUE) refuse_display();
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    // Text scales with the monitor, so the window does too.
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, debug ? GLFW_TRUE : GLFW_FALSE);
    // OpenGL 4.3 can render too, 3.3 can only show pictures. A robust context, which reports when it is lost,
    // is preferred to any other.
    for (const int major : {4, 3}) {
        for (const int loss : {GLFW_LOSE_CONTEXT_ON_RESET, GLFW_NO_ROBUSTNESS}) {
            if (window_ != nullptr) break;
            glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
            glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
            glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, loss);
            window_ = glfwCreateWindow(size.first, size.second, title.c_str(), nullptr, nullptr);
        }
    }
    if (window_ == nullptr) {
        glfwTerminate();
        refuse_display();
    }
    glfwSetWindowSizeLimits(window_, 480, 320, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    if (debug) print_opengl_messages();
    install_callbacks();

    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui_ImplOpenGL3_Init(glsl_version);
}

Window::~Window() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

/// Called before Dear ImGui installs its callbacks, which call these. Dear ImGui's own key state would miss a
/// key that is pressed and released within a frame.
void Window::install_callbacks() {
    glfwSetWindowUserPointer(window_, this);
    static const auto input_of = [](GLFWwindow* window) {
        auto* const found = static_cast<Window*>(glfwGetWindowUserPointer(window));
        found->has_input_ = true;
        return found;
    };
    glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
        std::vector<std::string>& dropped = input_of(window)->dropped_;
        dropped.insert(dropped.end(), paths, paths + count);
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int mods) {
        Window* const w = input_of(window);
        if (action == GLFW_RELEASE) return;
        w->keys_.push_back({key, 0, (mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_SHIFT) != 0});
    });
    glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned int character) {
        input_of(window)->keys_.push_back({0, static_cast<char32_t>(character), false, false});
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int, int, int) { input_of(window); });
    glfwSetScrollCallback(window_, [](GLFWwindow* window, double, double) { input_of(window); });
    glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double, double) { input_of(window); });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { input_of(window); });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* window, int, int) { input_of(window); });
    glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* window, float, float) { input_of(window); });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int) { input_of(window); });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* window, int) { input_of(window); });
    glfwSetWindowCloseCallback(window_, [](GLFWwindow* window) { input_of(window); });
}

bool Window::is_closed() const { return glfwWindowShouldClose(window_) == GLFW_TRUE; }

void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }

void Window::hide() { glfwHideWindow(window_); }

void Window::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

WindowSize Window::size() const {
    WindowSize size;
    glfwGetWindowSize(window_, &size.width, &size.height);
    glfwGetFramebufferSize(window_, &size.pixel_width, &size.pixel_height);
    return size;
}

float Window::content_scale() const {
    float x = 1;
    float y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return x > 0 ? x : 1;
}

bool Window::wait(double seconds) {
    if (seconds > 0) {
        glfwWaitEventsTimeout(seconds);
    } else {
        glfwPollEvents();
    }
    return std::exchange(has_input_, false);
}

void Window::wake() { glfwPostEmptyEvent(); }

void Window::begin_frame() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void Window::clear(const Tint& tint) const {
    const WindowSize now = size();
    glViewport(0, 0, now.pixel_width, now.pixel_height);
    glClearColor(tint.red, tint.green, tint.blue, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

void Window::fill(const Area& area, const Tint& tint) const {
    const WindowSize now = size();
    const auto pixels = [ratio = now.pixels_per_unit()](float units) {
        return static_cast<GLint>(std::lround(units * ratio));
    };
    glEnable(GL_SCISSOR_TEST);
    glScissor(pixels(area.x), now.pixel_height - pixels(area.y + area.height), pixels(area.width),
              pixels(area.height));
    glClearColor(tint.red, tint.green, tint.blue, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

void Window::end_frame() {
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window_);
}

Image Window::screenshot() const {
    const WindowSize now = size();
    Image image(now.pixel_width, now.pixel_height);
    std::vector<std::uint8_t> bytes(image.pixels.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, now.pixel_width, now.pixel_height, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
    // OpenGL's rows begin at the bottom. Half a step keeps each value, since the writer rounds down.
    const std::size_t row = static_cast<std::size_t>(now.pixel_width) * 3;
    for (std::size_t y = 0; y < static_cast<std::size_t>(now.pixel_height); ++y)
        for (std::size_t i = 0; i < row; ++i)
            image.pixels[(static_cast<std::size_t>(now.pixel_height) - 1 - y) * row + i] =
                (static_cast<float>(bytes[y * row + i]) + 0.5f) / 255.0f;
    return image;
}

std::vector<std::string> Window::take_dropped() { return std::exchange(dropped_, {}); }

std::vector<KeyPress> Window::take_keys() { return std::exchange(keys_, {}); }

bool Window::is_held(int code) const { return glfwGetKey(window_, code) == GLFW_PRESS; }

} // namespace glint::viewer
