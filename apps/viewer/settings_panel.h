#pragma once
// How the picture is made and looked at: quantity, light model, samples, comparison, camera, saving.

#include "actions.h"
#include "view_state.h"
#include "widgets.h"

#include <string>
#include <vector>

namespace glint::viewer {

class SceneEditor;

/// Draws the panel's content. Changes of the camera and of `state` are made; edits of the scene and actions
/// of pressed buttons are added to the lists. `why_cpu`: see BackendSwitch. Requires a scene.
void settings_panel(Ui& ui, SceneEditor& editor, const std::string& why_cpu, ViewState& state,
                    std::vector<Edit>& edits, std::vector<Action>& actions);

} // namespace glint::viewer
