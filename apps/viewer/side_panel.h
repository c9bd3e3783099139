#pragma once
// The panel at the right with its three tabs.

#include "shortcuts.h"
#include "ui_map.h"
#include "view_state.h"
#include "widgets.h"

#include "glint/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace glint::viewer {

class Activity;
class PixelInspector;
class Workbench;

enum class Tab { scene, picture, pixel };

class SidePanel {
  public:
    SidePanel(Workbench& bench, ViewState& state, Activity& activity, PixelInspector& inspector)
        : bench_(bench), state_(state), activity_(activity), inspector_(inspector) {}

    /// What the user asked for, beside edits of the scene and of the view state, which are done.
    struct Requests {
        std::vector<Action> actions;
        std::optional<CameraDescription> camera;
    };
    /// Draws the panel if it is open. `why_cpu`: see BackendSwitch.
    Requests draw(Ui& ui, const Area& area, const std::string& why_cpu);

    bool is_open() const { return open_; }
    void toggle() { open_ = !open_; }
    /// Opens the panel at a tab.
    void show(Tab tab);

    void report(UiMap& map) const;

  private:
    void draw_tab(Ui& ui, Tab tab, const char* label, const std::string& why_cpu, Requests& requests);
    void draw_content(Ui& ui, Tab tab, const std::string& why_cpu, Requests& requests);
    void apply_edits();

    Workbench& bench_;
    ViewState& state_;
    Activity& activity_;
    PixelInspector& inspector_;
    bool open_ = true;
    Tab tab_ = Tab::scene;
    bool select_tab_ = false; ///< `tab_` was set by show() and Dear ImGui has to follow
    std::vector<Edit> edits_; ///< of this frame
    bool editing_ = false;    ///< the mouse button that is down has changed a value
};

} // namespace glint::viewer
