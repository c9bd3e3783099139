// Cameras that show everything finite.

#include "glint/scene.h"
#include "math/trig.h"
#include "scene/framing.h"
#include "scene/support.h"

#include <algorithm>

namespace glint::scene {
namespace {

constexpr double framed_fov = 40; // degrees

// Radius of the ball that is framed if nothing is finite.
constexpr double stand_in_radius = 1;

// The point of the first plane nearest to the origin, or the origin.
dvec3 something_to_look_at(const SceneDescription& description) {
    for (const Object& object : description.objects) {
        const auto* plane = std::get_if<PlaneShape>(&object.shape);
        if (plane == nullptr || !object.visible) continue;
        const dvec3 p = plane->normal * (plane->offset / glm::dot(plane->normal, plane->normal));
        return dvec3(object.transform * dvec4(p, 1));
    }
    return dvec3(0);
}

} // namespace

ViewAxes three_quarter_view(double azimuth, double elevation) {
    const double across = cos_degrees(elevation);
    const dvec3 forward(sin_degrees(azimuth) * across, cos_degrees(azimuth) * across,
                        -sin_degrees(elevation));
    const dvec3 right(cos_degrees(azimuth), -sin_degrees(azimuth), 0);
    return {right, glm::cross(right, forward), forward};
}

CameraDescription fit_camera(const ViewAxes& view, const Lens& lens, const SupportFunction& reach) {
    // A point p is inside the right edge of the picture if (right − k · forward) · (p − eye) ≤ 0, and
    // similarly for the other edges: the support points in four directions determine the eye.
    const double k = tan_degrees(lens.fov / 2) * lens.fill;
    const double k_across = k * lens.aov;
    const double to_right = reach(view.right - k_across * view.forward);
    const double to_left = reach(-view.right - k_across * view.forward);
    const double to_top = reach(view.up - k * view.forward);
    const double to_bottom = reach(-view.up - k * view.forward);

    // The tighter of the two pairs determines the distance; in the other direction the eye is centred.
    const double along = -std::max((to_right + to_left) / (2 * k_across), (to_top + to_bottom) / (2 * k));
    CameraDescription camera;
    camera.eye =
        view.forward * along + view.right * ((to_right - to_left) / 2) + view.up * ((to_top - to_bottom) / 2);
    camera.direction = view.forward;
    camera.up = dvec3(0, 0, 1);
    camera.fov = lens.fov;
    return camera;
}

} // namespace glint::scene

namespace glint {

CameraDescription fit_camera(const SceneDescription& description) {
    scene::Lens lens;
    lens.fov = scene::framed_fov;
    lens.aov = static_cast<double>(description.render.width) / description.render.height;
    const scene::ViewAxes view = scene::three_quarter_view(scene::default_azimuth, scene::default_elevation);

    const dvec3 stand_in = scene::something_to_look_at(description);
    const double size = scene::support(description, view.right).value_or(0) +
                        scene::support(description, -view.right).value_or(0) +
                        scene::support(description, view.up).value_or(0) +
                        scene::support(description, -view.up).value_or(0);
    if (size > 0) {
        return fit_camera(view, lens,
                          [&](const dvec3& d) { return scene::support(description, d).value_or(0); });
    }
    return fit_camera(view, lens, [&](const dvec3& d) {
        const double ball = scene::stand_in_radius * glm::length(d);
        return scene::support(description, d).value_or(glm::dot(d, stand_in)) + ball;
    });
}

} // namespace glint
