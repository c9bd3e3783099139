#ifndef GLINT_SHADING_INTERACTION_SHARED_H
#define GLINT_SHADING_INTERACTION_SHARED_H
#include "geometry/surface.shared.h"
#include "math/shared.h"
#include "shading/records.shared.h"

// From the point of a hit to the surface that is shaded, for single rays.

GLINT_SHARED_BEGIN

/// Does a ray come from the outer side of a surface? `n` is its normal as the object has it.
GLINT_FN bool enters(vec3 n, vec3 direction) { return dot(n, direction) < 0.0f; }

/// The surface with the normal of its geometry and the colour of its material, seen along `direction` (unit).
GLINT_FN SurfaceRecord surface_record(GLINT_IN(SurfacePoint) point, vec3 direction, vec3 color,
                                      bool lit_as_stored, bool turned) {
    bool entering = enters(point.n, direction);
    SurfaceRecord s;
    s.p = point.p;
    s.p_error = point.p_error;
    s.v = -direction;
    s.n_g = entering ? point.n : -point.n;
    s.n = s.n_g;
    s.color = color;
    s.lit_side = lit_as_stored && entering == turned ? -1.0f : 1.0f;
    return s;
}

GLINT_SHARED_END
#endif
