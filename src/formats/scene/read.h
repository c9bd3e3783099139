#pragma once
// From the tree of a scene file to a SceneDescription.

#include "formats/scene/table.h"
#include "formats/scene/tree.h"
#include "glint/scene.h"

#include <string>
#include <vector>

namespace glint {

/// Where the parts of an object were written.
struct ObjectPositions {
    std::string table; ///< "sphere"
    SourcePos header;
    SourcePos name;
    SourcePos material;
    SourcePos
        shape; ///< what gives its extent: vertices, a mesh's file or an instance's mesh, else the header
    SourcePos transform; ///< the header where there is none
    bool good = true;    ///< nothing was wrong with its table
};

/// A description and the places in it; `objects` runs along description.objects.
struct ReadScene {
    SceneDescription description;
    std::vector<ObjectPositions> objects;
    std::vector<SourcePos> materials; ///< energies: where reflectivity stands, else the header
};

/// How colours by name are meant, as the top of the file says.
ColorValues color_values_of(const TreeValue& root);

/// Reads a scene, but not how it moves. Reports what is wrong with single tables; check_scene() does the
/// rest.
ReadScene read_scene(const TreeValue& root, Problems& problems);

/// Changes settings, camera and materials of a description that exists already, as the tree says.
void patch_scene(const TreeValue& root, SceneDescription& description, Problems& problems);

} // namespace glint
