#pragma once
// Reading the tree of a scene file into a SceneDescription.

#include "formats/scene/table_reader.h"
#include "formats/scene/tree.h"
#include "glint/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace glint::formats {

/// Source positions of the parts of an object.
struct ObjectPositions {
    std::string table; ///< "sphere"
    SourcePos header;
    SourcePos name;
    SourcePos material;
    SourcePos shape;     ///< of what determines its extent: vertices, mesh file, or the mesh of an instance;
                         ///< otherwise the header
    SourcePos transform; ///< otherwise the header
    bool good = true;    ///< its table had no errors
};

/// A description with source positions; `objects` is parallel to description.objects.
struct ReadScene {
    SceneDescription description;
    std::vector<ObjectPositions> objects;
    std::vector<SourcePos> materials; ///< location for energy errors: `reflectivity`, or the header
    std::vector<SourcePos> lights;    ///< of their names, or the headers
};

/// The color_values setting of the file.
ColorValues color_values_of(const TreeValue& root);

/// Reads a scene without its animation. Reports errors in single tables; check_scene() does the rest.
ReadScene read_scene(const TreeValue& root, Problems& problems);

/// Reports duplicate names, unknown materials and meshes, degenerate triangles, coordinates out of range (for
/// meshes that are loaded) and materials invalid for the balanced model.
void check_scene(const ReadScene& scene, Problems& problems);

/// Reports meshes and instances whose vertices are out of range after scaling and transforming.
void check_mesh_extents(const ReadScene& scene, Problems& problems);

/// Applies a tree to an existing description. For types of objects, and for lights, the tree has no table or
/// as many as the description has of them, in order.
void patch_scene(const TreeValue& root, SceneDescription& description, Problems& problems);

/// Takes the camera table out of a tree; none if there is none.
std::optional<TreeValue> taken_camera(TreeValue& root);

/// Applies the values of a camera table to a scene that has no camera. An eye alone looks at the middle of
/// the scene; a direction, up or field of view without an eye change how the scene is framed.
void patch_framing(const TreeValue& camera, SceneDescription& description, Problems& problems);

} // namespace glint::formats
