#pragma once
// Set-up of the pinhole camera.

#include "glint/fov_axis.h"
#include "imaging/camera.shared.h"
#include "math/vec.h"

namespace glint::imaging {

/// Sets up a camera in double precision, rounded once to float. `direction` and `up` may have any non-zero
/// length but must not be parallel. `fov_degrees` is the full angle, in (0, 180). Pixels are square.
/// Right-handed: x to the right, y up, viewing along −z of the camera frame.
PinholeCamera pinhole_camera(const dvec3& eye, const dvec3& direction, const dvec3& up, double fov_degrees,
                             FovAxis axis, int width, int height);

} // namespace glint::imaging
