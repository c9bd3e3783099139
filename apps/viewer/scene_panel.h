#pragma once
// Materials, objects and lights of the scene with everything in them that can be set.

#include "file_keys.h"
#include "widgets.h"

#include <cstddef>
#include <optional>
#include <string>

namespace glint::viewer {

/// What the pixel under work shows of the scene.
struct Picked {
    std::string material;              ///< name; empty: nothing is picked
    std::optional<std::size_t> object; ///< index into SceneDescription::objects
    bool is_new = false;               ///< its sections are to be opened and scrolled to, once

    bool is(const Material& m) const { return !material.empty() && m.name == material; }
};

/// Draws the panel's content; what the user changes is added to `edits`.
/// `size` is about how large the scene is: what a pixel of dragging moves follows from it. `keys`: what the
/// file says, where that can be said in several ways. Sections of what is picked are marked.
void scene_panel(Ui& ui, const SceneDescription& scene, double size, const FileKeys& keys, Picked& picked,
                 std::vector<Edit>& edits);

} // namespace glint::viewer
