// Pairs of objects whose boxes touch, found by a sweep; then faces in double, and sample rays.

#include "scene/overlaps.h"

#include "math/random.shared.h"
#include "scene/flat_faces.h"

#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <tuple>
#include <utility>

namespace glint::scene {

using trace::Hit;
namespace {

constexpr std::uint32_t probes = 64;
/// Of a distance along a ray; above the rounding of its hits.
constexpr float rounding = 0x1p-20f;

class OverlapFinder {
  public:
    explicit OverlapFinder(const SceneData& scene) : scene_(scene), known_hidden_(scene.objects.size()) {}

    std::vector<Overlap> run() {
        for (std::uint32_t id = 0; id < scene_.objects.size(); ++id)
            if (glass_solid(id) && !unbounded(id)) probe_faces(id);
        for (const auto& [a, b] : touching_pairs()) compare(a, b);
        std::sort(found_.begin(), found_.end(), [](const Overlap& a, const Overlap& b) {
            return std::tie(a.object, a.other, a.kind) < std::tie(b.object, b.other, b.kind);
        });
        const auto equal = [](const Overlap& a, const Overlap& b) {
            return a.object == b.object && a.other == b.other && a.kind == b.kind;
        };
        found_.erase(std::unique(found_.begin(), found_.end(), equal), found_.end());
        return std::move(found_);
    }

  private:
    using Pair = std::pair<std::uint32_t, std::uint32_t>;

    const ObjectData& data(std::uint32_t id) const { return scene_.objects[id]; }
    const Object& object(std::uint32_t id) const { return scene_.description.objects[id]; }
    bool glass(std::uint32_t id) const { return scene_.materials[data(id).material].transparency > 0; }
    bool glass_solid(std::uint32_t id) const { return object(id).visible && data(id).solid && glass(id); }
    bool unbounded(std::uint32_t id) const { return std::holds_alternative<PlaneShape>(object(id).shape); }

    /// Grown by more than the rounding of its sides.
    Bounds grown_box(std::uint32_t id) const {
        Bounds box = data(id).bounds;
        const vec3 margin(box.max_coordinate() * rounding);
        box.lo -= margin;
        box.hi += margin;
        return box;
    }

    /// Pairs of a transparent solid and another object whose boxes touch.
    std::vector<Pair> touching_pairs() const {
        std::vector<Pair> pairs;
        const auto add = [&](std::uint32_t a, std::uint32_t b) {
            if (glass_solid(a) || glass_solid(b)) pairs.emplace_back(std::min(a, b), std::max(a, b));
        };
        std::vector<std::uint32_t> bounded, planes;
        for (std::uint32_t id = 0; id < scene_.objects.size(); ++id) {
            if (!object(id).visible) continue;
            if (unbounded(id))
                planes.push_back(id);
            else if (!data(id).bounds.empty())
                bounded.push_back(id);
        }
        for (std::size_t i = 0; i < planes.size(); ++i) {
            for (const std::uint32_t id : bounded) add(planes[i], id);
            for (std::size_t k = 0; k < i; ++k) add(planes[i], planes[k]);
        }
        sweep(bounded, add);
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }

    /// Calls add(a, b) for transparent solids and other objects whose boxes touch, along the longest axis.
    void sweep(std::vector<std::uint32_t>& ids,
               const std::function<void(std::uint32_t, std::uint32_t)>& add) const {
        Bounds all;
        std::vector<Bounds> boxes(scene_.objects.size());
        for (const std::uint32_t id : ids) all.grow(boxes[id] = grown_box(id));
        const vec3 size = all.extent();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        std::sort(ids.begin(), ids.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return boxes[a].lo[axis] < boxes[b].lo[axis]; });
        std::array<std::vector<std::uint32_t>, 2> open; // [1]: transparent solids
        const auto meet = [&](std::uint32_t id, std::vector<std::uint32_t>& others) {
            std::erase_if(others, [&](std::uint32_t o) { return boxes[o].hi[axis] < boxes[id].lo[axis]; });
            for (const std::uint32_t other : others)
                if (touch(boxes[id], boxes[other])) add(id, other);
        };
        for (const std::uint32_t id : ids) {
            meet(id, open[1]);
            if (glass_solid(id)) meet(id, open[0]);
            open[glass_solid(id) ? 1 : 0].push_back(id);
        }
    }

    static bool touch(const Bounds& a, const Bounds& b) {
        return glm::all(glm::lessThanEqual(a.lo, b.hi)) && glm::all(glm::lessThanEqual(b.lo, a.hi));
    }

    void compare(std::uint32_t a, std::uint32_t b) {
        if (have_coincident_faces(object(a), object(b))) found_.push_back({OverlapKind::coincident, a, b});
        const bool a_is_higher = data(a).rank > data(b).rank;
        find_hidden(a_is_higher ? b : a, a_is_higher ? a : b);
    }

    // --- What lies inside a transparent solid that owns the space ---

    void find_hidden(std::uint32_t id, std::uint32_t owner) {
        if (!glass_solid(owner) || known_hidden_[id]) return;
        const HiddenShare share = probe_inside(id, owner);
        const bool all = share.hidden && !share.shown;
        // Transparent objects may overlap, and show what is inside: that all of one vanishes is not meant.
        if (!share.hidden || (glass(id) && !(all && data(id).solid))) return;
        known_hidden_[id] = true;
        found_.push_back({all ? OverlapKind::hidden : OverlapKind::partly_hidden, id, owner});
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

    // --- Faces in one place, of any shape ---

    /// Rays through the box of a transparent solid: does another object's face coincide with one of its?
    void probe_faces(std::uint32_t id) {
        const Bounds box = grown_box(id);
        const float away = 8 * glm::length(box.extent());
        for (std::uint32_t i = 0; i < probes; ++i) {
            trace_all(line_through(box, id, i, away));
            for (std::size_t k = 0; k + 1 < hits_.size(); ++k) {
                const Hit &hit = hits_[k], &next = hits_[k + 1];
                if (hit.object == next.object || (hit.object != id && next.object != id)) continue;
                if (next.t - hit.t > hit.t * rounding) continue;
                const auto [a, b] = std::minmax(hit.object, next.object);
                found_.push_back({OverlapKind::coincident, a, b});
            }
        }
    }

    const SceneData& scene_;
    std::vector<bool> known_hidden_;
    std::vector<Hit> hits_;
    std::vector<float> crossings_;
    std::vector<Overlap> found_;
};

} // namespace

std::vector<Overlap> find_overlaps(const SceneData& scene) { return OverlapFinder(scene).run(); }

} // namespace glint::scene
