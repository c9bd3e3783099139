#pragma once
// From a place in the picture to the scene.

#include "glint/scene.h"

#include <cstddef>
#include <optional>

namespace glint {

/// What stands at a place of the picture.
struct Pick {
    std::size_t object = 0;   ///< index into SceneDescription::objects
    std::size_t material = 0; ///< index into SceneDescription::materials
    Vec3 position{0};
    Vec3 normal{0}; ///< geometric, unit, toward the viewer
    double distance = 0;
};

/// What the ray through a place of the scene's picture meets first; surfaces hidden in glass that owns their
/// space are passed over. In pixels from the top left: (0.5, 0.5) is the centre of pixel (0, 0).
std::optional<Pick> pick(const Scene& scene, double x, double y);

} // namespace glint
