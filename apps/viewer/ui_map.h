#pragma once
// Where the widgets are and what the window shows, written to a file for scripts that drive it (--ui-map).
// See docs/viewer.md for the form.

#include <map>
#include <string>
#include <variant>

namespace glint::viewer {

/// In units of the screen, from the top left of the window's content.
struct Area {
    float x = 0;
    float y = 0;
    float width = 0;
    float height = 0;

    bool contains(float px, float py) const {
        return px >= x && py >= y && px < x + width && py < y + height;
    }
};

class UiMap {
  public:
    /// An empty name writes nothing and costs nothing.
    explicit UiMap(std::string file) : file_(std::move(file)) {}

    bool is_kept() const { return !file_.empty(); }
    /// Forgets the frame before.
    void begin();
    /// The widget just made, where it can be seen.
    void item(const std::string& name);
    void area(const std::string& name, const Area& area);
    void state(const std::string& name, const std::string& value);
    void state(const std::string& name, const char* value) { state(name, std::string(value)); }
    void state(const std::string& name, double value);
    void state(const std::string& name, bool value);
    /// Writes the file if anything differs from what it holds. A file that cannot be written throws
    /// Error(output).
    void end();

  private:
    using Value = std::variant<bool, double, std::string>;

    std::string file_;
    std::map<std::string, Area> areas_;
    std::map<std::string, Value> states_;
    std::string written_;
};

} // namespace glint::viewer
