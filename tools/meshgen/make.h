#pragma once
// Making the requested mesh.

#include "request.h"

namespace glint::meshgen {

/// The mesh of a request, with normals and colours if requested.
Mesh make_mesh(const Request& request);

} // namespace glint::meshgen
