#pragma once

#include "request.h"

namespace glint::meshgen {

/// The mesh that a request for one describes, with normals and colours as asked for.
Mesh make_mesh(const Request& request);

} // namespace glint::meshgen
