#pragma once
// Widgets of panels.

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
/// A combo box that the map names `name`, its choices "NAME:CHOICE". Returns the index chosen now, or −1.
int choose(Ui& ui, const std::string& name, const std::string& current,
           const std::vector<std::string>& choices);
/// Of a message, the line before its details.
std::string first_line(const std::string& text);
/// Shows `help` while the mouse is over the last widget.
void tooltip(const char* help);

/// One channel from linear light to sRGB, and back.
float to_screen(double linear);
double to_linear(float screen);
/// Linear light as a colour of the screen.
ImVec4 screen_color(const Vec3& light);

} // namespace glint::viewer
