// Coincident surfaces along a ray.

#include "render/contact.h"

#include "geometry/coincidence.shared.h"
#include "scene/box_tree.h"

#include <algorithm>
#include <cstdint>
#include <tuple>

namespace glint::rendering {

using scene::SceneData;
using trace::Hit;

bool may_coincide(const SceneData& scene, const Ray& ray, const Hit& hit) {
    const Bounds& zone = scene.objects[hit.object].contact.box;
    if (zone.empty()) return false;
    const vec3 across = ray.direction * hit.t;
    const vec3 p = ray.origin + across;
    const vec3 error = 0x1p-20f * (glm::abs(ray.origin) + glm::abs(across));
    const Bounds around{p - error, p + error};
    return touch(zone, around) && (scene.contact_places == nullptr || scene.contact_places->touches(around));
}

void find_coincident(const SceneData& scene, const Ray& ray, const Hit& first, Coincidence& met) {
    met.hits.assign(1, first);
    met.margin = 0;
    if (!may_coincide(scene, ray, first)) return;
    const scene::ContactZone& zone = scene.objects[first.object].contact;
    const SurfacePoint at = scene.world.surface(ray, first);
    Ray rest = ray;
    rest.tmax = std::min(ray.tmax, last_coincident_t(at.n, ray.direction, first.t, zone.reach));
    met.margin = margin_past(at, at);
    for (Hit hit = scene.world.next(rest, first); hit; hit = scene.world.next(rest, hit)) {
        const SurfacePoint other = scene.world.surface(ray, hit);
        if (!coincide(at, other, zone.apart)) return;
        met.hits.push_back(hit);
        met.margin = std::max(met.margin, margin_past(at, other));
    }
}

const Hit* seen_of(const std::vector<Hit>& hits, const InteriorList* interior, const SceneData& scene) {
    const auto order = [&](const Hit& hit) {
        const scene::ObjectData& object = scene.objects[hit.object];
        return std::tuple(!(scene.materials[object.material].transparency > 0.0f), object.rank);
    };
    const Hit* seen = nullptr;
    for (const Hit& hit : hits)
        if (!is_hidden(interior, hit.object, scene) && (seen == nullptr || order(*seen) < order(hit)))
            seen = &hit;
    return seen;
}

bool dims_light(const Hit& hit, const std::vector<Hit>& hits, const InteriorList* interior,
                const SceneData& scene) {
    if (is_hidden(interior, hit.object, scene)) return false;
    if (!is_dielectric(hit.object, scene)) return true;
    return std::all_of(hits.begin(), hits.end(), [&](const Hit& other) {
        if (&other == &hit || !is_dielectric(other.object, scene)) return true;
        const std::uint32_t rank = scene.objects[hit.object].rank, others = scene.objects[other.object].rank;
        return others < rank || (others == rank && &other > &hit);
    });
}

} // namespace glint::rendering
