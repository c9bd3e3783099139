#pragma once

#include "glint/fov_axis.h"
#include "imaging/camera.shared.h"
#include "math/vec.h"

namespace glint {

/// Sets up a camera in double, rounded once to float. `direction` and `up` may have any length but not 0, and
/// must not be parallel; `fov_degrees` is the full angle, above 0 and below 180; pixels are square.
/// Right-handed: x to the right, y up, the view along −z of the camera's own frame.
PinholeCamera pinhole_camera(const dvec3& eye, const dvec3& direction, const dvec3& up, double fov_degrees,
                             FovAxis axis, int width, int height);

} // namespace glint
