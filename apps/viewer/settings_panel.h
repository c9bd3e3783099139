#pragma once
// How the picture is made and looked at: quantity, light model, samples, comparison, camera, saving.

#include "shortcuts.h"
#include "view_state.h"
#include "widgets.h"

namespace glint::viewer {

/// What the panel asks for.
struct SettingsWishes {
    std::vector<Edit>& edits;
    std::vector<Action>& actions;
    std::optional<CameraDescription> camera; ///< changed by hand
};

/// `camera` is the one looked through. `kept`: there are settings to compare with. `saved`: nothing was
/// changed since the scene was saved. `why_cpu`: why the graphics card does not draw though it is to.
void settings_panel(Ui& ui, const SceneDescription& scene, const CameraDescription& camera, bool kept,
                    bool saved, const std::string& why_cpu, ViewState& state, SettingsWishes& wishes);

} // namespace glint::viewer
