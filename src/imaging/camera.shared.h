#ifndef GLINT_IMAGING_CAMERA_SHARED_H
#define GLINT_IMAGING_CAMERA_SHARED_H
#include "math/shared.h"

// The pinhole camera: from a place on the film to a ray's direction.

GLINT_SHARED_BEGIN

/// A pinhole camera as its rays need it. `forward` has unit length; `right` and `up` are unit vectors times
/// the tangent of half the field of view that way, so that the film lies one unit ahead and spans −1 … 1 of
/// each.
struct PinholeCamera {
    vec3 eye;
    vec3 forward;
    vec3 right;
    vec3 up;
    float width;  ///< of the picture, pixels
    float height; ///< of the picture, pixels
};

/// Unit direction of the ray through the film at (dx, dy) pixels from the centre of pixel (px, py); (0, 0) is
/// top left, dy grows downward. The distance from the film's middle is formed from whole numbers and the
/// offset (2 px + 1 − W + 2 dx), never from a position that was rounded: mirrored places give exactly
/// mirrored values.
GLINT_FN vec3 pinhole_direction(PinholeCamera camera, int px, int py, float dx, float dy) {
    float x = ((2.0f * float(px) + 1.0f - camera.width) + 2.0f * dx) / camera.width;
    float y = ((camera.height - 1.0f - 2.0f * float(py)) - 2.0f * dy) / camera.height;
    return normalize((camera.forward + camera.right * x) + camera.up * y);
}

GLINT_SHARED_END

#endif
