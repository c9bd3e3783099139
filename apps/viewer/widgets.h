#pragma once
// The rows that panels are made of: a label, a widget, and what the user did with it as an edit of the scene.

#include "theme.h"
#include "ui_map.h"

#include "glint/scene.h"

#include <string>
#include <vector>

namespace glint::viewer {

/// What every part of the window draws with.
struct Ui {
    Theme theme;
    UiMap map;
    std::vector<std::string> animated; ///< key paths whose values come from the frame that is shown
};

/// One value to set, as -D has it: "material.glass.index", "1.33".
struct Edit {
    std::string path;
    std::string value;
};

/// How far a slider goes, and how it shows numbers. Typing (Ctrl and a click) may go beyond `most`.
struct Range {
    double least = 0;
    double most = 1;
    const char* format = "%.3g";
    bool logarithmic = false;
};

/// Rows about one table of the scene. Each row is named in the map by its key path; what the user changes is
/// added to `edits`. Rows of what is animated cannot be changed, and say so.
class Rows {
  public:
    Rows(Ui& ui, std::vector<Edit>& edits, std::string table)
        : ui_(ui), edits_(edits), table_(std::move(table)) {}

    /// A slider.
    void number(const char* key, const char* label, double value, const Range& range, const char* help);
    void whole(const char* key, const char* label, int value, int least, int most, const char* help);
    /// A swatch that opens a colour picker. The value is linear; the picker shows it as screens do.
    void color(const char* key, const char* label, const Vec3& value, const char* help);
    /// Three numbers to drag; `step` is what a pixel of movement adds.
    void place(const std::string& key, const char* label, const Vec3& value, double step, const char* help);
    /// The same for one that is no value of its own in the file: true where it was changed.
    bool drag(const std::string& key, const char* label, Vec3& value, double step, const char* help);
    /// One number without bounds to drag.
    void length(const std::string& key, const char* label, double value, double step, const char* help);
    void check(const char* key, const char* label, bool value, const char* help);
    /// One word of several.
    void choice(const char* key, const char* label, const std::string& value,
                const std::vector<std::string>& words, const char* help);

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

/// A row of a panel's own: its label, and the space after it for the widget that comes next.
void label_row(Ui& ui, const char* label, const char* help = "");
/// A line in bold letters.
void heading(const Ui& ui, const char* text);
/// Text that matters less, wrapped.
void quiet_text(const Ui& ui, const std::string& text);
/// A button that the map names "button:NAME".
bool button(Ui& ui, const char* name, const char* label, const char* help = "", bool lit = false);
/// A heading that opens and closes; the map names it "section:NAME". `swatch`: a colour shown in it, linear.
bool section(Ui& ui, const std::string& name, const std::string& label, bool open_at_first,
             const Vec3* swatch = nullptr);
/// What a message says before its details.
std::string first_line(const std::string& text);
/// Shows `help` while the mouse rests on the widget just made.
void tooltip(const char* help);

/// One channel of linear light as screens show it, and back.
float to_screen(double linear);
double to_linear(float screen);

} // namespace glint::viewer
