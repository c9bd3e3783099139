#pragma once
// Makes a mesh from the rows of a PLY file.

#include "formats/load_watch.h"
#include "formats/ply/rows.h"
#include "glint/mesh_files.h"

namespace glint::formats::ply {

/// Triangulates polygons, drops faces without area and unused vertices that are not finite, and adds warnings
/// about these. Throws Error(input) if a face uses a vertex that is not finite or beyond the largest
/// coordinate, for concave faces with too many corners, and if no vertex is left. Reports to `watch` before
/// each pass.
LoadedMesh assemble(const Source& source, const Header& header, const MeshLayout& layout, Rows rows,
                    const LoadWatch& watch);

} // namespace glint::formats::ply
