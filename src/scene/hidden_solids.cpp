// Sample rays through transparent solids: what they meet inside of others is hidden.

#include "scene/hidden_solids.h"

#include "math/random.shared.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace glint::scene {

using trace::Hit;
namespace {

constexpr std::uint32_t probes = 64;
/// Of a distance along a ray; above the rounding of its hits.
constexpr float rounding = 0x1p-20f;

class HiddenSolidFinder {
  public:
    explicit HiddenSolidFinder(const SceneData& scene) : scene_(scene), shown_(scene.objects.size()) {}

    std::vector<HiddenSolid> run() {
        for (std::uint32_t id = 0; id < scene_.objects.size() && found_.size() < max_hidden_solids; ++id)
            if (is_glass_solid(id)) probe(id);
        return std::move(found_);
    }

  private:
    const ObjectData& data(std::uint32_t id) const { return scene_.objects[id]; }
    bool is_glass_solid(std::uint32_t id) const {
        return scene_.description.objects[id].visible && data(id).solid &&
               scene_.materials[data(id).material].transparency > 0;
    }

    void probe(std::uint32_t id) {
        owner_.reset();
        const Bounds box = region(id);
        for (std::uint32_t i = 0; i < probes && !shown_[id]; ++i) walk(line_through(box, id, i), id);
        if (owner_ && !shown_[id]) found_.push_back({id, *owner_});
    }

    /// Of a plane the part that the scene's other objects and its camera are in.
    Bounds region(std::uint32_t id) const {
        Bounds box = data(id).bounds;
        if (!box.empty()) {
            const vec3 margin(box.max_coordinate() * rounding);
            return {box.lo - margin, box.hi + margin};
        }
        box = scene_.world.bounds();
        box.grow(vec3(scene_.description.camera->eye));
        const vec3 margin(0.5f * glm::length(box.extent()) + 1.0f);
        return {box.lo - margin, box.hi + margin};
    }

    /// A ray through a point of a box that starts and ends outside, not along the sides of a flat box.
    static Ray line_through(const Bounds& box, std::uint32_t key, std::uint32_t i) {
        const vec2 xy = sample_pair(key, i, 0), zx = sample_pair(key, i, 1), yz = sample_pair(key, i, 2);
        const vec3 through = box.lo + box.extent() * vec3(xy.x, xy.y, zx.x);
        const vec3 wide = box.extent() + 0.125f * glm::length(box.extent());
        const float away = 1.5f * glm::length(box.extent());
        Ray ray;
        ray.direction = glm::normalize(wide * (vec3(zx.y, yz.x, yz.y) - 0.5f));
        ray.origin = through - ray.direction * away;
        ray.tmax = 2 * away;
        return ray;
    }

    /// Follows a ray: of each surface on it, is it inside a solid that outranks it? One ray judges all solids
    /// on its way, so that nested ones are not compared pair by pair.
    void walk(const Ray& ray, std::uint32_t id) {
        scene_.world.all_hits(ray, hits_);
        std::erase_if(hits_, [&](const Hit& hit) { return !is_glass_solid(hit.object); });
        // Those may be missed, or met twice.
        if (std::any_of(hits_.begin(), hits_.end(), [](const Hit& hit) { return hit.on_edge; })) return;
        if (!says_anything()) return;

        std::map<std::uint32_t, std::uint32_t> around; // objects by rank
        for (const std::uint32_t object : objects_around(scene_, ray.origin))
            if (is_glass_solid(object)) around.emplace(data(object).rank, object);
        for (std::size_t k = 0; k < hits_.size(); ++k) {
            const std::uint32_t object = hits_[k].object, rank = data(object).rank;
            if (!coincides(k)) {
                if (around.empty() || around.rbegin()->first <= rank)
                    shown_[object] = true;
                else if (object == id)
                    owner_ = around.rbegin()->second;
            }
            if (around.erase(rank) == 0) around.emplace(rank, object);
        }
    }

    /// About a solid that is not known to be shown.
    bool says_anything() const {
        for (std::size_t k = 0; k < hits_.size(); ++k)
            if (!shown_[hits_[k].object] && !coincides(k)) return true;
        return false;
    }

    /// With a surface of another object; which of them comes first says nothing.
    bool coincides(std::size_t k) const {
        const auto near = [&](const Hit& other) {
            return other.object != hits_[k].object && std::abs(other.t - hits_[k].t) <= hits_[k].t * rounding;
        };
        return (k > 0 && near(hits_[k - 1])) || (k + 1 < hits_.size() && near(hits_[k + 1]));
    }

    const SceneData& scene_;
    std::vector<bool> shown_;            ///< a part of the surface is outside all solids that outrank it
    std::optional<std::uint32_t> owner_; ///< of the space around a part of the solid that is probed
    std::vector<Hit> hits_;
    std::vector<HiddenSolid> found_;
};

} // namespace

std::vector<HiddenSolid> find_hidden_solids(const SceneData& scene) { return HiddenSolidFinder(scene).run(); }

} // namespace glint::scene
