// Cameras that show everything finite.

#include "glint/scene.h"
#include "math/trig.h"
#include "scene/framing.h"
#include "scene/keys/check.h"
#include "scene/support.h"

#include <algorithm>
#include <functional>

namespace glint::scene {
namespace {

constexpr double azimuth = 28;   // degrees, to the left
constexpr double elevation = 20; // degrees

// Radius of the ball that is framed if nothing has an extent.
constexpr double stand_in_radius = 1;

/// Support function: d ↦ max d · p over the points p to show.
using SupportFunction = std::function<double(const dvec3&)>;

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

std::optional<double> reach(const SceneDescription& description, const dvec3& d) {
    if (!description.framing.moments) return support(description, d);
    std::optional<double> most;
    for (const SceneDescription& moment : *description.framing.moments)
        if (const auto there = support(moment, d)) most = std::max(most.value_or(*there), *there);
    return most;
}

SupportFunction reach_of(const SceneDescription& description, const ViewAxes& view) {
    double size = 0;
    for (const dvec3& side : {view.right, -view.right, view.up, -view.up})
        size += reach(description, side).value_or(0);
    if (size > 0) return [&](const dvec3& d) { return reach(description, d).value_or(0); };
    return [&, stand_in = something_to_look_at(description)](const dvec3& d) {
        return reach(description, d).value_or(glm::dot(d, stand_in)) + stand_in_radius * glm::length(d);
    };
}

ViewAxes view_along(const dvec3& direction, const dvec3& up) {
    const dvec3 forward = glm::normalize(direction);
    const dvec3 right = glm::normalize(glm::cross(forward, up));
    return {right, glm::cross(right, forward), forward};
}

// The nearest eye from which everything is within the slopes k to the sides, k_across and k upward.
dvec3 fitted_eye(const ViewAxes& view, double k_across, double k, const SupportFunction& reach) {
    // A point p is inside the right edge of the picture if (right − k · forward) · (p − eye) ≤ 0, and
    // similarly for the other edges: the support points in four directions determine the eye.
    const double to_right = reach(view.right - k_across * view.forward);
    const double to_left = reach(-view.right - k_across * view.forward);
    const double to_top = reach(view.up - k * view.forward);
    const double to_bottom = reach(-view.up - k * view.forward);

    // The tighter of the two pairs determines the distance; in the other direction the eye is centred.
    const double along = -std::max((to_right + to_left) / (2 * k_across), (to_top + to_bottom) / (2 * k));
    return view.forward * along + view.right * ((to_right - to_left) / 2) +
           view.up * ((to_top - to_bottom) / 2);
}

} // namespace

dvec3 up_beside(const dvec3& direction, const dvec3& up) {
    CameraDescription camera;
    camera.direction = direction;
    camera.up = up;
    return view_fault(camera) ? dvec3(up.y, up.z, up.x) : up;
}

ViewAxes three_quarter_view() {
    const double across = cos_degrees(elevation);
    const dvec3 forward(sin_degrees(azimuth) * across, cos_degrees(azimuth) * across,
                        -sin_degrees(elevation));
    const dvec3 right(cos_degrees(azimuth), -sin_degrees(azimuth), 0);
    return {right, glm::cross(right, forward), forward};
}

void look_at_middle(CameraDescription& camera, const SceneDescription& description) {
    const SupportFunction all = reach_of(description, {});
    dvec3 middle(0);
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 d(0);
        d[axis] = 1;
        middle[axis] = (all(d) - all(-d)) / 2;
    }
    if (middle != camera.eye) camera.direction = middle - camera.eye;
    camera.up = up_beside(camera.direction, camera.up);
}

} // namespace glint::scene

namespace glint {

CameraDescription fit_camera(const SceneDescription& description) {
    const Framing& framing = description.framing;
    const double width = description.render.width, height = description.render.height;
    const dvec3 up = framing.direction ? scene::up_beside(*framing.direction, framing.up) : framing.up;
    const scene::ViewAxes view =
        framing.direction ? scene::view_along(*framing.direction, up) : scene::three_quarter_view();
    const double k = tan_degrees(framing.fov / 2) * framing.fill;
    const double side = fov_side(framing.fov_axis, width, height);
    CameraDescription camera;
    camera.eye =
        scene::fitted_eye(view, k * (width / side), k * (height / side), scene::reach_of(description, view));
    camera.direction = view.forward;
    camera.up = up;
    camera.fov = framing.fov;
    camera.fov_axis = framing.fov_axis;
    return camera;
}

} // namespace glint
