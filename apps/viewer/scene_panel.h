#pragma once
// Materials, objects and lights of the scene with everything in them that can be set.

#include "widgets.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace glint::viewer {

class SceneEditor;

/// What the explained pixel shows of the scene.
struct Picked {
    std::string material;              ///< name; empty: nothing is picked
    std::optional<std::size_t> object; ///< index into SceneDescription::objects
    bool is_new = false;               ///< its sections are to be opened and scrolled to, once

    bool is(const Material& m) const { return !material.empty() && m.name == material; }
};

/// Draws the panel's content; what the user changes is added to `edits`. Sections of what is picked are
/// marked. Requires a scene.
void scene_panel(Ui& ui, const SceneEditor& editor, Picked& picked, std::vector<Edit>& edits);

} // namespace glint::viewer
