#include "window.h"

#include "opengl.h"

#include "glint/error.h"
#include "glint/image.h"

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

/// GLFW tells its faults to a callback alone.
std::string& last_fault() {
    static std::string text;
    return text;
}

[[noreturn]] void refuse_display() {
    const bool named = std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
    throw Error(ErrorKind::device,
                named ? "no window can be opened (" + last_fault() + ")"
                      : "there is no display to open a window on",
                "render to a file instead: glint FILE -o picture.png");
}

} // namespace

Window::Window(int width, int height, const std::string& title, bool listen) : listens_(listen) {
    glfwSetErrorCallback([](int, const char* text) { last_fault() = text; });
    if (glfwInit() != GLFW_TRUE) refuse_display();
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    // Where texts are larger, so is the window that holds them.
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, listen ? GLFW_TRUE : GLFW_FALSE);
    // The later one can make pictures too; the older is enough to draw them. Best is one that tells of its
    // loss.
    for (const int major : {4, 3}) {
        for (const int loss : {GLFW_LOSE_CONTEXT_ON_RESET, GLFW_NO_ROBUSTNESS}) {
            if (window_ != nullptr) break;
            glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
            glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
            glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, loss);
            window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
        }
    }
    if (window_ == nullptr) {
        glfwTerminate();
        refuse_display();
    }
    glfwSetWindowSizeLimits(window_, 480, 320, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    if (listen) listen_to_opengl();
    take_events();

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

/// Called before Dear ImGui installs its own callbacks, which pass on to these. Its own account of keys would
/// miss one that is pressed and let go within a frame.
void Window::take_events() {
    glfwSetWindowUserPointer(window_, this);
    const auto self = [](GLFWwindow* window) {
        return static_cast<Window*>(glfwGetWindowUserPointer(window));
    };
    static const auto touch = self;
    glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
        touch(window)->dropped_.insert(touch(window)->dropped_.end(), paths, paths + count);
        touch(window)->touched_ = true;
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int mods) {
        touch(window)->touched_ = true;
        if (action == GLFW_RELEASE) return;
        touch(window)->keys_.push_back(
            {key, 0, (mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_SHIFT) != 0});
    });
    glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned int character) {
        touch(window)->touched_ = true;
        touch(window)->keys_.push_back({0, static_cast<char32_t>(character), false, false});
    });
    glfwSetMouseButtonCallback(window_,
                               [](GLFWwindow* window, int, int, int) { touch(window)->touched_ = true; });
    glfwSetScrollCallback(window_,
                          [](GLFWwindow* window, double, double) { touch(window)->touched_ = true; });
    glfwSetCursorPosCallback(window_,
                             [](GLFWwindow* window, double, double) { touch(window)->touched_ = true; });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { touch(window)->touched_ = true; });
    glfwSetFramebufferSizeCallback(window_,
                                   [](GLFWwindow* window, int, int) { touch(window)->touched_ = true; });
    glfwSetWindowContentScaleCallback(
        window_, [](GLFWwindow* window, float, float) { touch(window)->touched_ = true; });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int) { touch(window)->touched_ = true; });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* window, int) { touch(window)->touched_ = true; });
    glfwSetWindowCloseCallback(window_, [](GLFWwindow* window) { touch(window)->touched_ = true; });
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

void Window::position(int& x, int& y) const { glfwGetWindowPos(window_, &x, &y); }

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
    return std::exchange(touched_, false);
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
    const auto pixels = [ratio = now.pixels_a_unit()](float units) {
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
    // OpenGL's rows begin at the bottom. Half a step keeps each value when the writer rounds down.
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
