// Pairs of transparent solids whose boxes touch, then sample rays.

#include "scene/hidden_solids.h"

#include "math/random.shared.h"
#include "scene/box_tree.h"

#include <algorithm>
#include <utility>

namespace glint::scene {

using trace::Hit;
namespace {

constexpr std::uint32_t probes = 64;
/// Of a distance along a ray; above the rounding of its hits.
constexpr float rounding = 0x1p-20f;

class HiddenSolidFinder {
  public:
    explicit HiddenSolidFinder(const SceneData& scene) : scene_(scene), known_(scene.objects.size()) {}

    std::vector<HiddenSolid> run() {
        for (const auto& [a, b] : touching_pairs()) {
            const bool a_is_higher = data(a).rank > data(b).rank;
            find_hidden(a_is_higher ? b : a, a_is_higher ? a : b);
        }
        std::sort(found_.begin(), found_.end(),
                  [](const HiddenSolid& a, const HiddenSolid& b) { return a.object < b.object; });
        return std::move(found_);
    }

  private:
    using Pair = std::pair<std::uint32_t, std::uint32_t>;

    const ObjectData& data(std::uint32_t id) const { return scene_.objects[id]; }
    const Object& object(std::uint32_t id) const { return scene_.description.objects[id]; }
    bool glass_solid(std::uint32_t id) const {
        return object(id).visible && data(id).solid && scene_.materials[data(id).material].transparency > 0;
    }
    bool unbounded(std::uint32_t id) const { return std::holds_alternative<PlaneShape>(object(id).shape); }

    /// Grown by more than the rounding of its sides.
    Bounds grown_box(std::uint32_t id) const {
        Bounds box = data(id).bounds;
        const vec3 margin(box.max_coordinate() * rounding);
        box.lo -= margin;
        box.hi += margin;
        return box;
    }

    std::vector<Pair> touching_pairs() const {
        std::vector<Pair> pairs;
        const auto add = [&](std::uint32_t a, std::uint32_t b) { pairs.emplace_back(std::minmax(a, b)); };
        std::vector<std::uint32_t> bounded, planes;
        for (std::uint32_t id = 0; id < scene_.objects.size(); ++id) {
            if (!glass_solid(id)) continue;
            if (unbounded(id))
                planes.push_back(id);
            else if (!data(id).bounds.empty())
                bounded.push_back(id);
        }
        for (std::size_t i = 0; i < planes.size(); ++i) {
            for (const std::uint32_t id : bounded) add(planes[i], id);
            for (std::size_t k = 0; k < i; ++k) add(planes[i], planes[k]);
        }
        parallel::TaskPool pool(1);
        BoxTree(
            bounded, [&](std::uint32_t id) { return grown_box(id); }, pool)
            .visit_pairs(add);
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }

    void find_hidden(std::uint32_t id, std::uint32_t owner) {
        if (known_[id]) return;
        const HiddenShare share = probe_inside(id, owner);
        if (!share.hidden || share.shown) return;
        known_[id] = true;
        found_.push_back({id, owner});
    }

    struct HiddenShare {
        bool hidden = false; ///< a part is inside
        bool shown = false;  ///< a part is outside
    };

    HiddenShare probe_inside(std::uint32_t id, std::uint32_t owner) {
        const Bounds mine = region(id), owners = region(owner);
        HiddenShare share;
        share.shown = !unbounded(owner) && (unbounded(id) || !contains(owners, mine));
        const Bounds common{glm::max(mine.lo, owners.lo), glm::min(mine.hi, owners.hi)};
        const float away = 1.5f * glm::length(owners.extent());
        for (std::uint32_t i = 0; i < probes && !(share.hidden && share.shown); ++i) {
            const Ray ray = line_through(common, hash_with(id, owner), i, away);
            trace_all(ray);
            add_share(id, owner, ray, share);
        }
        return share;
    }

    /// Of a plane the part that the scene's other objects and its camera are in.
    Bounds region(std::uint32_t id) const {
        if (!unbounded(id)) return grown_box(id);
        Bounds around = scene_.world.bounds();
        around.grow(vec3(scene_.description.camera->eye));
        const vec3 margin(0.5f * glm::length(around.extent()) + 1.0f);
        return {around.lo - margin, around.hi + margin};
    }

    static bool contains(const Bounds& outer, const Bounds& inner) {
        return glm::all(glm::lessThanEqual(outer.lo, inner.lo)) &&
               glm::all(glm::lessThanEqual(inner.hi, outer.hi));
    }

    /// A ray through a point of a box that starts a distance before it, not along the sides of a flat box.
    static Ray line_through(const Bounds& box, std::uint32_t key, std::uint32_t i, float away) {
        const vec2 xy = sample_pair(key, i, 0), zx = sample_pair(key, i, 1), yz = sample_pair(key, i, 2);
        const vec3 through = box.lo + box.extent() * vec3(xy.x, xy.y, zx.x);
        const vec3 wide = box.extent() + 0.125f * glm::length(box.extent());
        Ray ray;
        ray.direction = glm::normalize(wide * (vec3(zx.y, yz.x, yz.y) - 0.5f));
        ray.origin = through - ray.direction * away;
        ray.tmax = 2 * away;
        return ray;
    }

    /// Judges the hits of one object by the crossings of the other, whose outside the ray starts on unless it
    /// is a plane.
    void add_share(std::uint32_t id, std::uint32_t owner, const Ray& ray, HiddenShare& share) {
        crossings_.clear();
        for (const Hit& hit : hits_) {
            if (hit.object == owner) crossings_.push_back(hit.t);
            if (hit.on_edge && (hit.object == owner || hit.object == id)) return;
        }
        const bool starts_inside = unbounded(owner) && is_behind(owner, ray.origin);
        for (const Hit& hit : hits_) {
            if (hit.object != id) continue;
            const auto after = std::upper_bound(crossings_.begin(), crossings_.end(), hit.t);
            const float margin = hit.t * rounding;
            const bool near = (after != crossings_.end() && *after - hit.t <= margin) ||
                              (after != crossings_.begin() && hit.t - *(after - 1) <= margin);
            if (near) continue;
            const bool odd = (after - crossings_.begin()) % 2 != 0;
            (odd != starts_inside ? share.hidden : share.shown) = true;
        }
    }

    bool is_behind(std::uint32_t plane, const vec3& p) const {
        return std::any_of(scene_.half_spaces.begin(), scene_.half_spaces.end(), [&](const HalfSpace& half) {
            return half.object == plane && glm::dot(half.plane.normal, dvec3(p)) < half.plane.offset;
        });
    }

    void trace_all(const Ray& ray) {
        hits_.clear();
        scene_.world.all_hits(ray, hits_);
    }

    const SceneData& scene_;
    std::vector<bool> known_; ///< to be hidden
    std::vector<Hit> hits_;
    std::vector<float> crossings_;
    std::vector<HiddenSolid> found_;
};

} // namespace

std::vector<HiddenSolid> find_hidden_solids(const SceneData& scene) { return HiddenSolidFinder(scene).run(); }

} // namespace glint::scene
