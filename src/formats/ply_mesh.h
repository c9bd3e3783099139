#pragma once
// From what a PLY file stores to a mesh that can be drawn.

#include "formats/load_watch.h"
#include "formats/ply_body.h"
#include "glint/formats.h"

namespace glint::ply {

/// Splits polygons, drops faces without area and unused vertices that are not finite, and says so in
/// warnings. Throws Error(input) for a vertex that is not finite or beyond the greatest coordinate and that a
/// face uses, for concave faces too large to split, and where no vertex is left. `watch` is told before each
/// pass.
LoadedMesh assemble(const Source& source, const Header& header, const Layout& layout, Body body,
                    const LoadWatch& watch);

} // namespace glint::ply
