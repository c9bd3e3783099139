#pragma once
// The rows of one object: its shape, and where its transform puts it.

#include "file_keys.h"
#include "widgets.h"

#include <string>

namespace glint::viewer {

/// `table` is how -D names the object; `step` is what a pixel of dragging moves.
void object_rows(Ui& ui, const SceneDescription& scene, const Object& object, const std::string& table,
                 double step, const FileKeys& keys, std::vector<Edit>& edits);

} // namespace glint::viewer
