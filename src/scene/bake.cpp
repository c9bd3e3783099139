// Baking of all objects, and ranks of solids.

#include "scene/bake.h"

#include "glint/limits.h"
#include "scene/names.h"
#include "scene/shapes/shapes.h"
#include "scene/wide_meshes.h"

#include <algorithm>
#include <numeric>

namespace glint::scene {
namespace {

class Baker {
  public:
    Baker(const SceneDescription& description, bool need_closedness, const std::function<void()>& between)
        : scene_(description), names_(description), between_(between),
          meshes_(need_closedness, between, baked_) {
        baked_.objects.resize(description.objects.size());
    }

    Baked run() {
        rank_objects();
        for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
            between_();
            bake_object(static_cast<std::uint32_t>(i));
        }
        mark_wide_meshes(baked_);
        return std::move(baked_);
    }

  private:
    // Of overlapping solids the higher priority owns the space, of equal ones the later in the file.
    void rank_objects() {
        std::vector<std::uint32_t> order(scene_.objects.size());
        std::iota(order.begin(), order.end(), 0u);
        std::stable_sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) {
            return scene_.objects[a].priority < scene_.objects[b].priority;
        });
        for (std::uint32_t rank = 0; rank < order.size(); ++rank) baked_.objects[order[rank]].rank = rank;
    }

    void bake_object(std::uint32_t id) {
        const Object& object = scene_.objects[id];
        const Material* material = names_.material_of(object);
        baked_.objects[id].material = static_cast<std::uint32_t>(material - scene_.materials.data());
        if (!object.visible) return;
        ShapeBaker parts(names_, object, id, baked_, meshes_);
        std::visit(
            [&](const auto& shape) {
                baked_.objects[id].solid = has_inside(shape);
                glint::scene::bake(shape, parts);
            },
            object.shape);
        ObjectData& data = baked_.objects[id];
        if (data.core.empty()) data.core = data.bounds;
        check_bounds(object, data.bounds);
    }

    void check_bounds(const Object& object, const Bounds& bounds) const {
        if (bounds.empty()) return;
        const vec3 far = glm::max(glm::abs(bounds.lo), glm::abs(bounds.hi));
        if (far.x <= coordinate_limit && far.y <= coordinate_limit && far.z <= coordinate_limit) return;
        throw Error(ErrorKind::input, "the object reaches beyond coordinates of 1e12 after its transform",
                    "scale it down, or move it nearer to the origin", object.where);
    }

    const SceneDescription& scene_;
    NameIndex names_;
    const std::function<void()>& between_;
    Baked baked_;
    MeshBaker meshes_;
};

} // namespace

Baked bake(const SceneDescription& description, bool need_closedness, const std::function<void()>& between) {
    return Baker(description, need_closedness, between).run();
}

} // namespace glint::scene
