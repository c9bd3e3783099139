#pragma once
// The window of the system: GLFW makes it, OpenGL 3.3 or later draws in it, Dear ImGui lays out what stands
// in it. One a program.

#include "theme.h"
#include "ui_map.h"

#include <functional>
#include <string>
#include <vector>

struct GLFWwindow;

namespace glint {
struct Image;
}

namespace glint::viewer {

/// Sizes in two units: those of the screen, in which the mouse moves, and pixels. On some systems one unit is
/// two pixels.
struct WindowSize {
    int width = 0;
    int height = 0;
    int pixel_width = 0;
    int pixel_height = 0;

    float pixels_a_unit() const {
        return width > 0 ? static_cast<float>(pixel_width) / static_cast<float>(width) : 1.0f;
    }
};

/// A key pressed (or repeated), with what was held beside it. `code` is GLFW's (GLFW_KEY_S), or 0 for a
/// character, which is what the keyboard's layout makes of a key.
struct KeyPress {
    int code = 0;
    char32_t character = 0;
    bool control = false;
    bool shift = false;
};

class Window {
  public:
    /// Throws Error(device) where there is no display, or none that can draw.
    /// The size is multiplied by the screen's content_scale() where that is not in its units already.
    /// `listen`: tell standard error what OpenGL complains of.
    Window(int width, int height, const std::string& title, bool listen);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return window_; }
    bool listens_to_opengl() const { return listens_; }
    bool is_closed() const;
    void close();
    void hide();
    void set_title(const std::string& title);
    WindowSize size() const;
    /// Where the window's content begins on the screen.
    void position(int& x, int& y) const;
    /// How large texts shall be, 1 where a screen has about 96 dots an inch. Another screen may change it.
    float content_scale() const;

    /// Waits for input, for wake(), or for so many seconds; true if there was any of the first two.
    bool wait(double seconds);
    /// Ends wait(). The only call that other threads may make.
    static void wake();

    void begin_frame();
    /// Fills the window with a colour; what is drawn next lies over it.
    void clear(const Tint& tint) const;
    /// Fills a part of it. Far cheaper than a widget's ground where software draws.
    void fill(const Area& area, const Tint& tint) const;
    /// Draws the widgets and shows the frame.
    void end_frame();
    /// What the window shows, as it was last drawn.
    Image screenshot() const;

    /// Files dropped on the window since the last call.
    std::vector<std::string> take_dropped();
    /// Keys pressed since the last call, in order, however short.
    std::vector<KeyPress> take_keys();
    /// Is the key down now?
    bool is_held(int code) const;

  private:
    void take_events();

    GLFWwindow* window_ = nullptr;
    bool listens_ = false;
    std::vector<std::string> dropped_;
    std::vector<KeyPress> keys_;
    bool touched_ = false; ///< there was input since the last wait()
};

} // namespace glint::viewer
