// Collects emitting surfaces from what is traced.

#include "scene/light_set.h"

#include "scene/scene_data.h"
#include "trace/world/data.h"

#include <algorithm>
#include <cmath>

namespace glint::scene {
namespace {

Bounds box_of(const EmitterRecord& e) {
    Bounds box;
    const vec3 radius(e.radius);
    if (e.kind == emitter_sphere) return {e.base - radius, e.base + radius};
    const vec3 opposite = e.kind == emitter_triangle ? vec3(0.0f) : e.u + e.v;
    for (const vec3& corner : {vec3(0.0f), e.u, e.v, opposite}) box.grow(e.base + corner);
    if (e.kind == emitter_disk)
        for (const vec3& corner : {-e.u, -e.v, -opposite}) box.grow(e.base + corner);
    return box;
}

double mean(const vec3& color) { return (double(color.x) + double(color.y) + double(color.z)) / 3; }

EmitterRecord flat_emitter(int kind, const vec3& base, const vec3& u, const vec3& v) {
    EmitterRecord e{};
    e.kind = kind;
    e.base = base;
    e.u = u;
    e.v = v;
    const dvec3 normal = glm::cross(dvec3(u), dvec3(v));
    const double size = glm::length(normal);
    if (!(size > 0)) {
        e.kind = emitter_none;
        return e;
    }
    e.n = vec3(normal / size);
    e.area = static_cast<float>(kind == emitter_triangle ? size / 2 : size);
    return e;
}

EmitterRecord quadric_emitter(const trace::Quadric& quadric) {
    EmitterRecord e{};
    const QuadricShape& shape = quadric.shape;
    if (quadric.affine >= 0 || (shape.kind != quadric_sphere && shape.kind != quadric_disk)) return e;
    const double circle = 3.14159265358979324 * shape.radius * shape.radius;
    e.base = vec3(shape.base);
    e.n = vec3(shape.axis);
    e.radius = static_cast<float>(shape.radius);
    if (shape.kind == quadric_sphere) {
        e.kind = emitter_sphere;
        e.area = static_cast<float>(4 * circle);
        return e;
    }
    e.kind = emitter_disk;
    e.u = turned_to(e.n, vec3(1, 0, 0)) * e.radius;
    e.v = turned_to(e.n, vec3(0, 1, 0)) * e.radius;
    e.area = static_cast<float>(circle);
    return e;
}

class LightFinder {
  public:
    explicit LightFinder(const SceneData& scene) : scene_(scene), world_(scene.world.data()) {
        set_.first_emitter.assign(scene.objects.size(), invalid_index);
        set_.is_one.assign(scene.objects.size(), 0);
    }

    LightSet run() {
        for (std::size_t i = 0; i < world_.meshes.size(); ++i) add_mesh(world_.meshes[i]);
        for (const trace::InstanceData& instance : world_.instances) add_instance(instance);
        add_quadrics();
        choose();
        return std::move(set_);
    }

  private:
    const MaterialRecord& material(std::uint32_t object) const {
        return scene_.materials[scene_.objects[object].material];
    }
    /// What light shines through is found by the directions that materials sample, alone.
    bool emits(std::uint32_t object) const {
        const MaterialRecord& m = material(object);
        return m.emission != vec3(0.0f) && !(m.transparency > 0.0f);
    }

    void begin(std::uint32_t object, bool is_one) {
        set_.first_emitter[object] = static_cast<std::uint32_t>(set_.emitters.size());
        set_.is_one[object] = is_one ? 1 : 0;
    }
    void add(EmitterRecord emitter, std::uint32_t object) {
        emitter.object = object;
        set_.emitters.push_back(emitter);
    }

    void add_mesh(const trace::WorldInput::Triangles& mesh) {
        if (!emits(mesh.object)) return;
        const bool rectangle =
            std::holds_alternative<RectangleShape>(scene_.description.objects[mesh.object].shape);
        begin(mesh.object, rectangle);
        const vec3* p = mesh.positions.data();
        if (rectangle)
            return add(flat_emitter(emitter_rectangle, p[0], p[1] - p[0], p[3] - p[0]), mesh.object);
        for (const uvec3& t : mesh.triangles) add_triangle(p[t.x], p[t.y], p[t.z], mesh.flip, mesh.object);
    }

    void add_instance(const trace::InstanceData& instance) {
        if (!emits(instance.object)) return;
        begin(instance.object, false);
        const std::uint32_t number = trace::instance_of(world_, instance.object);
        const dvec3& translation = world_.instance_tree.translation(number);
        const auto placed = [&](const vec3& p) { return vec3(instance.linear * dvec3(p) + translation); };
        const bool flip = instance.turned != (glm::determinant(instance.linear) < 0);
        const trace::WorldInput::SharedMesh& mesh = world_.shared_meshes[instance.mesh].source;
        for (const uvec3& t : *mesh.triangles)
            add_triangle(placed((*mesh.positions)[t.x]), placed((*mesh.positions)[t.y]),
                         placed((*mesh.positions)[t.z]), flip, instance.object);
    }

    void add_triangle(const vec3& a, const vec3& b, const vec3& c, bool flip, std::uint32_t object) {
        add(flip ? flat_emitter(emitter_triangle, a, c - a, b - a)
                 : flat_emitter(emitter_triangle, a, b - a, c - a),
            object);
    }

    /// In the order of (object, primitive), as World numbers their surfaces.
    void add_quadrics() {
        for (const trace::QuadricRef& ref : world_.surfaces) {
            if (ref.kind != trace::PrimKind::quadric || !emits(ref.object)) continue;
            if (set_.first_emitter[ref.object] == invalid_index) begin(ref.object, false);
            set_.emitters.resize(set_.first_emitter[ref.object] + ref.prim); // some are left out
            add(quadric_emitter(world_.quadrics[ref.index]), ref.object);
        }
    }

    void choose() {
        const LightSampling sampling = scene_.description.path.light_sampling;
        const bool alike = sampling == LightSampling::uniform;
        std::vector<double> weights;
        for (const LightRecord& light : scene_.lights) weights.push_back(alike ? 1 : power_of(light));
        set_.points = LightChoice(weights);
        if (sampling == LightSampling::tree) return grow_tree();
        weights.clear();
        for (const EmitterRecord& e : set_.emitters)
            weights.push_back(alike && e.kind != emitter_none ? 1 : power_of(e));
        set_.choice = LightChoice(weights);
    }

    void grow_tree() {
        std::vector<LightBounds> bounds;
        for (const EmitterRecord& e : set_.emitters) {
            const bool both_sides =
                e.kind == emitter_none || (material(e.object).flags & material_front) == 0;
            bounds.push_back({box_of(e), e.n, e.kind == emitter_sphere ? -1.0f : 1.0f, both_sides,
                              static_cast<float>(power_of(e))});
        }
        set_.tree = LightTree(bounds);
    }

    double power_of(const EmitterRecord& e) const {
        return e.kind == emitter_none ? 0 : double(e.area) * mean(material(e.object).emission);
    }

    /// In proportion to what arrives in the middle of the scene.
    double power_of(const LightRecord& light) const {
        const Bounds bounds = scene_.world.bounds();
        const double radius = bounds.empty() ? 1 : glm::length(dvec3(bounds.extent())) / 2;
        const double power = mean(light.strength);
        return light.kind == light_directional ? power * radius * radius : power;
    }

    const SceneData& scene_;
    const trace::WorldData& world_;
    LightSet set_;
};

} // namespace

LightChoice::LightChoice(std::span<const double> weights) {
    double sum = 0;
    for (const double weight : weights) sum += weight;
    if (!(sum > 0)) return;
    end_.assign(1, 0.0f);
    double part = 0;
    // Rounded to the steps of the random numbers, so that probabilities are exact.
    for (const double weight : weights)
        end_.push_back(static_cast<float>(std::floor((part += weight) / sum * 0x1p24) * 0x1p-24));
    end_.back() = 1;
}

ChosenLight LightChoice::choose(float u) const {
    if (empty()) return {};
    const auto end = std::upper_bound(end_.begin() + 1, end_.end(), u);
    const auto light = static_cast<std::uint32_t>(std::min(end, end_.end() - 1) - end_.begin() - 1);
    return {light, probability(light)};
}

std::uint32_t LightSet::emitter_of(std::uint32_t object, std::uint32_t prim) const {
    const std::uint32_t first = first_emitter[object];
    return first == invalid_index ? invalid_index : is_one[object] != 0 ? first : first + prim;
}

LightSet find_lights(const SceneData& scene) { return LightFinder(scene).run(); }

} // namespace glint::scene
