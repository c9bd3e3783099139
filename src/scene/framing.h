#pragma once
// How scenes without a camera are seen.

#include "glint/scene.h"
#include "math/vec.h"

namespace glint::scene {

/// Orthonormal axes of a camera.
struct ViewAxes {
    dvec3 right{1, 0, 0};
    dvec3 up{0, 0, 1};
    dvec3 forward{0, 1, 0};
};

/// View from the front (−y), a little from the left, looking down by 20 degrees; z is up.
ViewAxes three_quarter_view();

/// `up`, or another axis if the view is along that.
dvec3 up_beside(const dvec3& direction, const dvec3& up);

/// Changes a camera that was fitted to a scene to look at the middle of what is finite there from its present
/// eye.
void look_at_middle(CameraDescription& camera, const SceneDescription& description);

} // namespace glint::scene
