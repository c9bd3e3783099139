#pragma once
// Steps of building a scene beside its trees. Private to this room.

#include "scene/scene_data.h"

namespace glint::scene {

/// Whether a visible object is transparent.
bool shows_glass(const SceneDescription& description);

/// Sets the description, as given and about the origin that the scene has, with its camera or one that is
/// chosen.
void set_description(SceneData& scene, const SceneDescription& description);

/// Sets materials, lights and everything else that does not depend on objects.
void build_values(SceneData& scene);

/// Finds what path tracers sample of the lights, once the world and all values are set.
void build_light_set(SceneData& scene);

/// Determines the transparent solids around the eye.
void find_camera_interiors(SceneData& scene);

} // namespace glint::scene
