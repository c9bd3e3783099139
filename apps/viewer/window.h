#pragma once
// The window: created by GLFW, drawn by OpenGL 3.3 or later, with widgets by Dear ImGui. One per program.

#include "theme.h"
#include "ui_map.h"

#include "glint/image.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace glint::viewer {

/// In screen units, in which the mouse is reported, and in pixels. On some systems a unit is two pixels.
struct WindowSize {
    int width = 0;
    int height = 0;
    int pixel_width = 0;
    int pixel_height = 0;

    float pixels_per_unit() const {
        return width > 0 ? static_cast<float>(pixel_width) / static_cast<float>(width) : 1.0f;
    }
};

/// A key pressed or repeated, with its modifiers: either a key `code` of GLFW (GLFW_KEY_S), or the
/// `character` that the keyboard's layout produces, with code 0.
struct KeyPress {
    int code = 0;
    char32_t character = 0;
    bool control = false;
    bool shift = false;

    friend bool operator==(const KeyPress&, const KeyPress&) = default;
};

class Window {
  public:
    /// The size is multiplied by content_scale() unless the screen's units already are. `debug`: print
    /// OpenGL's debug messages. Throws Error(device) without a display, or without OpenGL 3.3.
    Window(std::pair<int, int> size, const std::string& title, bool debug);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return window_; }
    bool is_debugging_opengl() const { return debug_; }
    bool is_closed() const;
    void close();
    void hide();
    void set_title(const std::string& title);
    WindowSize size() const;
    /// Size of text relative to a screen of about 96 dpi. Changes when the window moves to another screen.
    float content_scale() const;

    /// Waits for input or wake(), at most `seconds`; true if there was input.
    bool wait(double seconds);
    /// Ends wait(). Thread-safe, unlike all other calls.
    static void wake();

    void begin_frame();
    /// Fills the window with a colour.
    void clear(const Tint& tint) const;
    /// Fills a part of it. Much cheaper than a widget's background where OpenGL is software.
    void fill(const Area& area, const Tint& tint) const;
    /// Draws the widgets and shows the frame.
    void end_frame();
    /// The window's content, as it was last drawn.
    Image screenshot() const;

    /// Files dropped on the window since the last call.
    std::vector<std::string> take_dropped();
    /// Keys pressed since the last call, in order, even if released again.
    std::vector<KeyPress> take_keys();
    /// Is the key down now?
    bool is_held(int code) const;

  private:
    void install_callbacks();

    GLFWwindow* window_ = nullptr;
    bool debug_ = false;
    std::vector<std::string> dropped_;
    std::vector<KeyPress> keys_;
    bool has_input_ = false; ///< since the last wait()
};

} // namespace glint::viewer
