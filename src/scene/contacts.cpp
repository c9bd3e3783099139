// Contact zones: pairs of objects whose boxes touch, then their faces.

#include "scene/contacts.h"

#include "scene/box_tree.h"
#include "scene/flat_faces.h"
#include "trace/world/data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <span>
#include <utility>

namespace glint::scene {

using trace::Quadric;
using trace::WorldData;
using trace::WorldInput;
namespace {

/// Objects of more triangles and quadrics are compared only with planes.
constexpr std::size_t max_parts = 1024;
/// Of coordinates: what zones grow by, above all rounding of hits and shifts of start points.
constexpr float zone_margin = 0x1p-16f;

/// What an object's surface is made of.
struct Parts {
    std::vector<FlatFace> flat;
    std::vector<const Quadric*> round;
};

Bounds grown(Bounds box, float margin) {
    box.lo -= margin;
    box.hi += margin;
    return box;
}

class ContactFinder {
  public:
    explicit ContactFinder(SceneData& scene) : scene_(scene), world_(scene.world.data()) {}

    void run(parallel::TaskPool& pool) {
        for (ObjectData& object : scene_.objects) object.contact = {};
        std::vector<std::uint32_t> bounded, planes, small;
        for (std::uint32_t id = 0; id < scene_.objects.size(); ++id) {
            if (!scene_.description.objects[id].visible) continue;
            if (is_plane(id)) planes.push_back(id);
            if (bounds(id).empty()) continue;
            bounded.push_back(id);
            if (part_count(id) <= max_parts) small.push_back(id);
        }
        mark_equal_boxes(bounded);
        const BoxTree tree(
            small, [&](std::uint32_t id) { return grown_box(id); }, pool);
        tree.visit_pairs([&](std::uint32_t a, std::uint32_t b) { compare(a, b); });
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const FlatFace face = parts(planes[i], {}).flat.front();
            for (const std::uint32_t id : bounded) compare_with_plane(id, planes[i], face);
            for (std::size_t k = 0; k < i; ++k) compare(planes[i], planes[k]);
        }
        scene_.any_contact = !places_.empty();
        build_places(pool);
    }

  private:
    const Bounds& bounds(std::uint32_t id) const { return scene_.objects[id].bounds; }
    Bounds grown_box(std::uint32_t id) const {
        return grown(bounds(id), bounds(id).max_coordinate() * zone_margin);
    }
    bool is_plane(std::uint32_t id) const {
        return std::holds_alternative<PlaneShape>(scene_.description.objects[id].shape);
    }
    bool glass(std::uint32_t id) const {
        return scene_.materials[scene_.objects[id].material].transparency > 0;
    }

    // --- Parts of objects ---

    std::span<const trace::QuadricRef> surfaces(std::uint32_t id) const {
        const auto by_object = [](const trace::QuadricRef& s, std::uint32_t object) {
            return s.object < object;
        };
        const auto from = std::lower_bound(world_.surfaces.begin(), world_.surfaces.end(), id, by_object);
        return {from, std::lower_bound(from, world_.surfaces.end(), id + 1, by_object)};
    }
    const WorldInput::Triangles* mesh(std::uint32_t id) const {
        const auto at = std::lower_bound(
            world_.meshes.begin(), world_.meshes.end(), id,
            [](const WorldInput::Triangles& m, std::uint32_t object) { return m.object < object; });
        return at != world_.meshes.end() && at->object == id ? &*at : nullptr;
    }
    const WorldInput::SharedMesh* shared_mesh(std::uint32_t instance) const {
        return &world_.shared_meshes[world_.instances[instance].mesh].source;
    }

    std::size_t part_count(std::uint32_t id) const {
        if (const WorldInput::Triangles* m = mesh(id)) return m->triangles.size();
        const std::uint32_t instance = instance_of(world_, id);
        if (instance != invalid_index) return shared_mesh(instance)->triangles->size();
        return surfaces(id).size();
    }

    /// The parts that touch a box; of triangles those that may lie in the plane, if one is given.
    Parts parts(std::uint32_t id, const Bounds& within, const FlatFace* plane = nullptr) const {
        Parts found;
        if (const WorldInput::Triangles* m = mesh(id)) {
            const auto same = [](const vec3& p) { return dvec3(p); };
            add_triangles(m->positions, m->triangles, same, within, plane, found.flat);
        }
        const std::uint32_t instance = instance_of(world_, id);
        if (instance != invalid_index) {
            const dmat3& linear = world_.instances[instance].linear;
            const dvec3& translation = world_.instance_tree.translation(instance);
            const auto placed = [&](const vec3& p) { return linear * dvec3(p) + translation; };
            const WorldInput::SharedMesh* m = shared_mesh(instance);
            add_triangles(*m->positions, *m->triangles, placed, within, plane, found.flat);
        }
        for (const trace::QuadricRef& surface : surfaces(id)) {
            if (surface.kind == trace::PrimKind::plane)
                found.flat.push_back(face_of(world_.planes[surface.index]));
            else
                add_quadric(world_.quadrics[surface.index], found);
        }
        return found;
    }

    static FlatFace face_of(const trace::PlanePrim& plane) {
        const dvec3 point = plane.plane.normal * (plane.plane.offset / plane.squared);
        return {point, plane.unit, {}, glm::abs(point)};
    }

    template <class ToWorld>
    void add_triangles(std::span<const vec3> positions, std::span<const uvec3> triangles, ToWorld&& to_world,
                       const Bounds& within, const FlatFace* plane, std::vector<FlatFace>& out) const {
        const dvec3 reach = glm::max(glm::abs(dvec3(within.lo)), glm::abs(dvec3(within.hi)));
        const double rounding = plane != nullptr ? rounding_at(*plane, reach + glm::abs(plane->point)) : 0;
        for (const uvec3& t : triangles) {
            const dvec3 first = to_world(positions[t.x]);
            if (plane != nullptr && std::abs(glm::dot(plane->normal, first - plane->point)) > rounding)
                continue;
            const dvec3 second = to_world(positions[t.y]), third = to_world(positions[t.z]);
            Bounds box;
            for (const dvec3& corner : {first, second, third}) box.grow(vec3(corner));
            if (touch(box, within)) out.push_back(polygon_face({first, second, third}));
        }
    }

    void add_quadric(const Quadric& quadric, Parts& out) const {
        const QuadricShape& shape = quadric.shape;
        const trace::Affine affine = affine_of(quadric);
        if (geometry::has_round_side(shape)) out.round.push_back(&quadric);
        const dvec3 aside = std::abs(shape.axis.x) < 0.7 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
        const dvec3 x = shape.radius * glm::normalize(glm::cross(shape.axis, aside));
        const dvec3 across[2] = {affine.linear * x, affine.linear * glm::cross(shape.axis, x)};
        for (const double height : geometry::flat_heights(shape))
            out.flat.push_back(
                circle_face(affine.linear * (shape.base + shape.axis * height) + affine.translation, across));
    }

    trace::Affine affine_of(const Quadric& quadric) const {
        return quadric.affine < 0 ? trace::Affine{}
                                  : world_.affines[static_cast<std::size_t>(quadric.affine)];
    }

    // --- Pairs ---

    /// Objects that stand in a file twice have the same box.
    void mark_equal_boxes(const std::vector<std::uint32_t>& ids) {
        std::map<std::array<float, 6>, std::uint32_t> first;
        for (const std::uint32_t id : ids) {
            const auto& [lo, hi] = bounds(id);
            const auto [at, is_new] = first.try_emplace({lo.x, lo.y, lo.z, hi.x, hi.y, hi.z}, id);
            if (!is_new) mark(at->second, id, {bounds(id)});
        }
    }

    void compare_with_plane(std::uint32_t id, std::uint32_t plane, const FlatFace& face) {
        const Bounds box = grown_box(id);
        const dvec3 middle = (dvec3(box.lo) + dvec3(box.hi)) * 0.5;
        const double across = glm::dot(glm::abs(face.normal), dvec3(box.extent()) * 0.5);
        if (std::abs(glm::dot(face.normal, middle - face.point)) > across) return;
        if (part_count(id) > max_parts && mesh(id) == nullptr) return;
        compare(id, plane, parts(id, box, &face), {{face}, {}});
    }

    void compare(std::uint32_t a, std::uint32_t b) {
        const Bounds common = is_plane(a) ? Bounds{} : common_box(grown_box(a), grown_box(b));
        compare(a, b, parts(a, common), parts(b, common));
    }

    void compare(std::uint32_t a, std::uint32_t b, const Parts& of_a, const Parts& of_b) {
        CommonPart where;
        for (const FlatFace& one : of_a.flat)
            for (const FlatFace& other : of_b.flat) where.grow(common_part(one, other));
        for (const Quadric* one : of_a.round)
            for (const Quadric* other : of_b.round) add_common_side(*one, *other, where);
        if (glass(a) || glass(b)) {
            add_touching(of_a, of_b, where);
            add_touching(of_b, of_a, where);
        }
        if (!where.box.empty()) mark(a, b, where);
    }

    /// Grows `where` by a part that the round sides of both have.
    void add_common_side(const Quadric& one, const Quadric& other, CommonPart& where) const {
        const trace::Affine from = affine_of(one), to = affine_of(other);
        if (from.linear != to.linear || from.translation != to.translation) return;
        const double error = 0x1p-20 * std::max(size_of_quadric(one.shape), size_of_quadric(other.shape));
        if (geometry::same_side(one.shape, other.shape, error))
            where.grow({common_box(one.box, other.box), error});
    }

    /// Grows `where` by the places at which round parts of the one touch flat parts of the other.
    void add_touching(const Parts& one, const Parts& other, CommonPart& where) const {
        for (const Quadric* round : one.round)
            for (const FlatFace& face : other.flat) {
                const dvec3& n = face.normal;
                const trace::Affine affine = affine_of(*round);
                const geometry::Interval range =
                    geometry::extent(round->shape, glm::transpose(affine.linear) * n);
                const double plane = glm::dot(n, face.point - affine.translation);
                const dvec3 reach = glm::max(glm::abs(dvec3(round->box.lo)), glm::abs(dvec3(round->box.hi)));
                const double rounding = rounding_at(face, reach + glm::abs(face.point));
                const double apart = std::min(std::abs(range.low - plane), std::abs(range.high - plane));
                if (apart > rounding) continue;
                const Bounds common =
                    common_box(grown(round->box, static_cast<float>(rounding)), box_of(face));
                if (!common.empty()) where.grow({common, apart});
            }
    }

    void mark(std::uint32_t a, std::uint32_t b, const CommonPart& where) {
        float size = 0;
        for (const std::uint32_t id : {a, b})
            if (!bounds(id).empty()) size = std::max(size, bounds(id).max_coordinate());
        places_.push_back(grown(where.box, size * zone_margin));
        for (const std::uint32_t id : {a, b}) {
            ContactZone& contact = scene_.objects[id].contact;
            contact.box.grow(places_.back());
            contact.reach = std::max(contact.reach, size * zone_margin);
            contact.apart = std::max(contact.apart, static_cast<float>(where.apart));
        }
    }

    void build_places(parallel::TaskPool& pool) {
        const auto finite = [](const Bounds& box) { return std::isfinite(box.max_coordinate()); };
        if (places_.empty() || !std::all_of(places_.begin(), places_.end(), finite)) return;
        std::vector<std::uint32_t> ids(places_.size());
        std::iota(ids.begin(), ids.end(), 0u);
        scene_.contact_places = std::make_shared<const BoxTree>(
            ids, [&](std::uint32_t i) { return places_[i]; }, pool);
    }

    SceneData& scene_;
    const WorldData& world_;
    std::vector<Bounds> places_; ///< of pairs
};

} // namespace

void find_contacts(SceneData& scene, parallel::TaskPool& pool) {
    scene.contact_places = nullptr;
    ContactFinder(scene).run(pool);
}

} // namespace glint::scene
