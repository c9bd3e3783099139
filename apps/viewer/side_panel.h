#pragma once
// The panel at the right with its three tabs.

#include "actions.h"
#include "ui_map.h"
#include "view_state.h"
#include "widgets.h"

#include <string>
#include <vector>

namespace glint::viewer {

class PixelInspector;
class SceneEditor;

enum class Tab { scene, picture, pixel };

class SidePanel {
  public:
    SidePanel(SceneEditor& editor, ViewState& state, PixelInspector& inspector)
        : editor_(editor), state_(state), inspector_(inspector) {}

    /// Draws the panel if it is open. Changes of values are made; the actions of pressed buttons are
    /// returned. `why_cpu`: see BackendSwitch.
    std::vector<Action> draw(Ui& ui, const Area& area, const std::string& why_cpu);

    bool is_open() const { return open_; }
    void toggle() { open_ = !open_; }
    /// Opens the panel at a tab.
    void show(Tab tab);

    void report(UiMap& map) const;

  private:
    bool begin_tab(Ui& ui, Tab tab);
    void draw_content(Ui& ui, Tab tab, const std::string& why_cpu, std::vector<Action>& actions);
    void apply_edits();

    SceneEditor& editor_;
    ViewState& state_;
    PixelInspector& inspector_;
    bool open_ = true;
    Tab tab_ = Tab::scene;
    bool select_tab_ = false; ///< `tab_` was set by show() and Dear ImGui has to follow
    std::vector<Edit> edits_; ///< of this frame
    bool editing_ = false;    ///< the mouse button that is down has changed a value
};

} // namespace glint::viewer
