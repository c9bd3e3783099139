#pragma once
// Walls between the camera or a light and what is to be seen: flat opaque objects on the wrong side.

#include "scene/scene_data.h"

#include <optional>

namespace glint::scene {

/// The flat object that fills the picture while other objects lie behind it; none in a good scene. Both
/// functions judge by the first hits of a few hundred rays of the camera.
std::optional<std::uint32_t> wall_before_camera(const SceneData& scene);

/// A light that reaches nothing that the camera sees.
struct ShutLight {
    std::uint32_t light = 0; ///< index in SceneData::lights
    std::uint32_t wall = 0;  ///< the flat object in between
};
std::vector<ShutLight> lights_behind_walls(const SceneData& scene);

} // namespace glint::scene
