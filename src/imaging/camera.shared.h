#ifndef GLINT_IMAGING_CAMERA_SHARED_H
#define GLINT_IMAGING_CAMERA_SHARED_H
#include "math/shared.h"

// The pinhole camera: from film positions to ray directions.

GLINT_SHARED_BEGIN

/// A pinhole camera. `forward` has unit length; `right` and `up` are unit vectors times the tangent of half
/// the field of view along that side, so the film is one unit ahead and spans −1 … 1 in these.
struct PinholeCamera {
    vec3 eye;
    vec3 forward;
    vec3 right;
    vec3 up;
    float width;  ///< of the picture, pixels
    float height; ///< of the picture, pixels
};

/// Unit direction of the ray through the film at (dx, dy) pixels from the centre of pixel (px, py); pixel (0,
/// 0) is top left, dy grows downward. The distance from the centre of the film is computed from integers and
/// the offset (2 px + 1 − W + 2 dx), never from a rounded position, so mirrored positions give exactly
/// mirrored values.
GLINT_FN vec3 pinhole_direction(PinholeCamera camera, int px, int py, float dx, float dy) {
    float x = ((2.0f * float(px) + 1.0f - camera.width) + 2.0f * dx) / camera.width;
    float y = ((camera.height - 1.0f - 2.0f * float(py)) - 2.0f * dy) / camera.height;
    return normalize((camera.forward + camera.right * x) + camera.up * y);
}

GLINT_SHARED_END

#endif
