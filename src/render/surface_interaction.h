#pragma once
// From a hit to a surface that can be shaded.

#include "math/ray.h"
#include "render/interior_list.h"
#include "scene/scene_data.h"
#include "shading/whitted_steps.shared.h"

#include <cstdint>

namespace glint {

struct SurfaceInteraction {
    SurfaceRecord surface;
    const MaterialRecord* material = nullptr;
    std::uint32_t object = 0;
    bool entering = true; ///< the ray comes from the object's outer side
};

/// The surface at a hit of a ray (unit direction): off the edge that it may lie on, with colour and shading
/// normal of the mesh's vertices.
SurfaceInteraction surface_interaction(const SceneData& scene, const Ray& ray, const trace::Hit& hit);

/// True if the ray comes from the outer side of the object that it hits.
bool enters(const SceneData& scene, const Ray& ray, const trace::Hit& hit);

/// How light goes on from a surface.
struct Bounce {
    Split split;
    const InteriorList* interior = nullptr; ///< behind the surface
    // At the surface of a transparent solid:
    Refraction refraction{};
    float index_before = 1;
    float index_after = 1;
};

} // namespace glint
