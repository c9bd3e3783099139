#ifndef GLINT_GEOMETRY_COINCIDENCE_SHARED_H
#define GLINT_GEOMETRY_COINCIDENCE_SHARED_H
#include "geometry/surface.shared.h"
#include "math/shared.h"

// Surfaces of different objects that lie in one place, up to rounding: which of them a ray meets first is
// noise, so all of them are met at once (docs/light-model.md, "Surfaces in one place").

GLINT_SHARED_BEGIN

/// Do surfaces that a ray meets coincide: are they parallel, and no more than `apart` apart or so near that a
/// ray that starts on the one may start beyond the other? offset_ray_origin() raises it by at most 6 errors.
GLINT_FN bool coincide(GLINT_IN(SurfacePoint) a, GLINT_IN(SurfacePoint) b, float apart) {
    float error = dot(abs(a.n), max(a.p_error, b.p_error));
    return abs(dot(a.n, b.n)) > 0.999f && abs(dot(a.n, b.p - a.p)) <= apart + 8.0f * error;
}

/// Bound of t for surfaces that coincide with one met at t. Both t are rounded, by more where the ray grazes:
/// `reach` is the rounding along the normal, beside that of the distance.
GLINT_FN float last_coincident_t(vec3 n, vec3 direction, float t, float reach) {
    float speed = sqrt(dot(direction, direction));
    float slope = max(abs(dot(n, direction)), speed * (1.0f / 1024.0f));
    return t + (reach + t * speed * (1.0f / 262144.0f)) / slope;
}

/// How far off any surface rays must start to be before or beyond one of those that coincide with the first:
/// the largest is enough for all of them.
GLINT_FN float margin_past(GLINT_IN(SurfacePoint) first, GLINT_IN(SurfacePoint) other) {
    return 2.0f * (abs(dot(first.n, other.p - first.p)) + dot(abs(first.n), other.p_error));
}

GLINT_SHARED_END
#endif
