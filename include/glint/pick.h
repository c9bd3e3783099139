#pragma once
// Picking: from a position in the picture to an object.

#include "glint/scene.h"

#include <cstddef>
#include <optional>

namespace glint {

/// The object visible at a position of the picture.
struct Pick {
    std::size_t object = 0;   ///< index into SceneDescription::objects
    std::size_t material = 0; ///< index into SceneDescription::materials
    Vec3 position{0};
    Vec3 normal{0}; ///< geometric, unit, toward the viewer
    double distance = 0;
    bool from_inside = false; ///< the surface is met from inside the object, or from behind
};

/// The first visible hit of the ray through a position, skipping surfaces hidden in glass that owns their
/// space. In pixels from the top left: (0.5, 0.5) is the centre of pixel (0, 0).
std::optional<Pick> pick(const Scene& scene, double x, double y);

} // namespace glint
