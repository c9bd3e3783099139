#pragma once
// The rows of panels: a label, a widget, and the edit of the scene that the user makes with it.

#include "theme.h"
#include "ui_map.h"

#include "glint/scene.h"

#include <string>
#include <vector>

namespace glint::viewer {

/// Shared by all that draws with Dear ImGui.
struct Ui {
    Theme theme;
    UiMap map;
    std::vector<std::string> animated; ///< key paths that the frame shown sets: they cannot be edited
};

/// A value to set, as with -D: "material.glass.index", "1.33".
struct Edit {
    std::string path;
    std::string value;
};

/// The range of a slider and its number format. A number typed after Ctrl + click may be larger than `max`.
struct Range {
    double min = 0;
    double max = 1;
    const char* format = "%.3g";
    bool logarithmic = false;
};

/// Rows for the keys of one table of the scene. The map names each row by its key path; changes are added to
/// `edits`. Rows of animated keys are disabled, with a tooltip that says so.
class Rows {
  public:
    Rows(Ui& ui, std::vector<Edit>& edits, std::string table)
        : ui_(ui), edits_(edits), table_(std::move(table)) {}

    /// A slider.
    void number(const char* key, const char* label, double value, const Range& range, const char* help);
    void whole(const char* key, const char* label, int value, int min, int max, const char* help);
    /// A swatch that opens a colour picker. The value is linear, the picker shows colours of the screen.
    void color(const char* key, const char* label, const Vec3& value, const char* help);
    /// Three numbers to drag; `step`: change per pixel of mouse movement.
    void place(const std::string& key, const char* label, const Vec3& value, double step, const char* help);
    /// The same for a value that is not a key of the file: true if it was changed.
    bool drag(const std::string& key, const char* label, Vec3& value, double step, const char* help);
    /// An unbounded number to drag.
    void length(const std::string& key, const char* label, double value, double step, const char* help);
    void check(const char* key, const char* label, bool value, const char* help);
    /// One of several values.
    void choice(const char* key, const char* label, const std::string& value,
                const std::vector<std::string>& choices, const char* help);

    void set(const std::string& key, std::string value) {
        edits_.push_back({table_ + "." + key, std::move(value)});
    }

  private:
    void begin(const std::string& key, const char* label, const char* help);
    void finish(const std::string& key);
    bool is_animated(const std::string& key) const;

    Ui& ui_;
    std::vector<Edit>& edits_;
    std::string table_;
};

/// Begins a Dear ImGui window that fills an area and cannot be moved.
void begin_fixed_window(const char* name, const Area& area, bool background = true);
/// The label of a row; the next widget takes the space after it.
void label_row(Ui& ui, const char* label, const char* help = "");
/// A line in bold.
void heading(const Ui& ui, const char* text);
/// Wrapped text in a weaker colour.
void quiet_text(const Ui& ui, const std::string& text);
/// A button that the map names "button:NAME".
bool button(Ui& ui, const char* name, const char* label, const char* help = "", bool lit = false);
/// A collapsible heading that the map names "section:NAME". `swatch`: a linear colour shown in it.
bool section(Ui& ui, const std::string& name, const std::string& label, bool open_at_first,
             const Vec3* swatch = nullptr);
/// Of a message, the line before its details.
std::string first_line(const std::string& text);
/// Shows `help` while the mouse is over the last widget.
void tooltip(const char* help);

/// One channel from linear light to sRGB, and back.
float to_screen(double linear);
double to_linear(float screen);

} // namespace glint::viewer
