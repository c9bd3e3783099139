#pragma once
// Surfaces of several objects in one place, which a ray meets at once (docs/light-model.md, "Surfaces in one
// place").

#include "render/interior_list.h"
#include "scene/scene_data.h"
#include "trace/world/world.h"

#include <vector>

namespace glint::rendering {

/// What a ray meets where surfaces coincide, beside the one that is seen.
struct Contact {
    bool exists = false;                  ///< otherwise the surface is alone
    const InteriorList* beyond = nullptr; ///< the solids around the ray behind all surfaces
    float margin = 0;      ///< what start points are off the seen one to be before all or beyond all
    bool refracts = false; ///< one of them bounds a transparent solid
    float others = 1;      ///< the share of refracted light that the surfaces beside the seen one let through
    vec3 tint{1.0f};       ///< and their tint
};

/// Hits of a ray in one place.
struct Coincidence {
    std::vector<trace::Hit> hits;
    float margin = 0; ///< as in Contact
};

/// Whether a hit is near a place where objects touch; if not, nothing coincides with it.
bool may_coincide(const scene::SceneData& scene, const Ray& ray, const trace::Hit& hit);

/// Sets `met` to a hit of a ray and the hits right behind it that coincide with it.
void find_coincident(const scene::SceneData& scene, const Ray& ray, const trace::Hit& first,
                     Coincidence& met);

/// The one of coincident surfaces that is seen: an opaque one before transparent ones, then the one of the
/// highest rank; null if solids around the ray hide all.
const trace::Hit* seen_of(const std::vector<trace::Hit>& hits, const InteriorList* interior,
                          const scene::SceneData& scene);

/// Whether light that goes through coincident surfaces is multiplied by τ of this one: not if it is hidden,
/// and of the surfaces of transparent solids only the one of the highest rank.
bool dims_light(const trace::Hit& hit, const std::vector<trace::Hit>& hits, const InteriorList* interior,
                const scene::SceneData& scene);

} // namespace glint::rendering
