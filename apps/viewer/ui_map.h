#pragma once
// Writes the areas of widgets and the state of the window to a file, for scripts that drive it (--ui-map).
// docs/viewer.md describes the format.

#include <map>
#include <string>
#include <utility>
#include <variant>

namespace glint::viewer {

/// In screen units, from the top left of the window's content.
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
    using Value = std::variant<bool, double, std::string>;

    /// An empty name writes nothing; then all calls are cheap.
    explicit UiMap(std::string file) : file_(std::move(file)) {}

    bool is_enabled() const { return !file_.empty(); }
    /// Begins a frame: forgets the last one.
    void begin();
    /// Adds the last widget, if it is visible.
    void item(const std::string& name);
    void area(const std::string& name, const Area& area);
    void state(const std::string& name, Value value);
    /// Ends the frame: writes the file if its content changes. Throws Error(output).
    void end();

  private:
    std::string file_;
    std::map<std::string, Area> areas_;
    std::map<std::string, Value> states_;
    std::string written_;
};

} // namespace glint::viewer
