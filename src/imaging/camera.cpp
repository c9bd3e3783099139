// Setting up the pinhole camera.

#include "imaging/camera.h"

#include "math/trig.h"

namespace glint::imaging {

PinholeCamera pinhole_camera(const dvec3& eye, const dvec3& direction, const dvec3& up, double fov_degrees,
                             FovAxis axis, int width, int height) {
    const dvec3 forward = glm::normalize(direction);
    const dvec3 right = glm::normalize(glm::cross(forward, up));
    const dvec3 upward = glm::cross(right, forward);

    // Pixels are square, so the other tangent follows from the aspect ratio.
    const double tangent = tan_degrees(fov_degrees / 2);
    const double side = fov_side(axis, width, height);

    PinholeCamera camera;
    camera.eye = vec3(eye);
    camera.forward = vec3(forward);
    camera.right = vec3(right * (tangent * (width / side)));
    camera.up = vec3(upward * (tangent * (height / side)));
    camera.width = static_cast<float>(width);
    camera.height = static_cast<float>(height);
    return camera;
}

} // namespace glint::imaging
