#include "scene/wide_meshes.h"

#include "scene/bake_mesh.h"

#include <algorithm>
#include <limits>
#include <span>

namespace glint::scene {

using trace::WorldInput;
namespace {

/// Triangles are wide if they exceed something near the origin of coordinates by this. Rays that leave a
/// triangle start up to 2^-20 of its width above it: a thing that is not exceeded is 8192 times as large as
/// that, a fraction of a pixel in its pictures.
constexpr float wide_ratio = 128;
/// The same of things anywhere: larger, or long strips would be wide beside their own ends.
constexpr float far_wide_ratio = 512;
/// Things as far from the origin as this part of the triangles' width are not near it.
constexpr float near_ratio = 16;
/// Points at coordinate c are rounded to float by up to 2^-24 c. Triangles that are not wider than this part
/// of c are no worse.
constexpr float rounding_ratio = 1.0f / 16;
/// Wide meshes are traced slowly: they may have no more triangles than this that are not near the origin.
constexpr std::size_t max_wide_triangles = 1024;

float max_side(const Bounds& box) {
    const vec3 d = box.extent();
    return std::max({d.x, d.y, d.z});
}

/// Triangles are wide if they exceed this.
float allowed_beside(const Bounds& thing) {
    const float near = std::max(wide_ratio * max_side(thing), near_ratio * thing.max_coordinate());
    const float far = std::max(far_wide_ratio * max_side(thing), rounding_ratio * thing.max_coordinate());
    return std::min(near, far);
}

/// How large triangles may be beside the other objects.
class AllowedWidth {
  public:
    explicit AllowedWidth(const std::vector<ObjectData>& objects) {
        for (std::uint32_t id = 0; id < objects.size(); ++id) {
            if (objects[id].bounds.empty()) continue;
            const float allowed = allowed_beside(objects[id].bounds);
            if (allowed < min_) {
                second_ = min_;
                min_ = allowed;
                object_ = id;
            } else {
                second_ = std::min(second_, allowed);
            }
        }
    }

    float for_object(std::uint32_t id) const { return id == object_ ? second_ : min_; }

  private:
    float min_ = std::numeric_limits<float>::infinity();
    float second_ = min_;
    std::uint32_t object_ = invalid_index;
};

/// `size` is that of the mesh; `allowed` is how wide its triangles may be beside other objects.
bool is_wide(std::span<const vec3> positions, std::span<const uvec3> triangles, float size, float allowed) {
    float widest = 0;
    std::size_t far_away = 0;
    for (const uvec3& corners : triangles) {
        Bounds box;
        for (int i = 0; i < 3; ++i) box.grow(positions[corners[i]]);
        if (near_ratio * box.max_coordinate() > size && ++far_away > max_wide_triangles) return false;
        widest = std::max(widest, max_side(box));
        allowed = std::min(allowed, allowed_beside(box));
    }
    return widest > allowed;
}

std::vector<vec3> in_world(const std::vector<vec3>& positions, const dmat4& m) {
    std::vector<vec3> moved;
    for (const vec3& p : positions) moved.push_back(vec3(transform_point(m, dvec3(p))));
    return moved;
}

} // namespace

void mark_wide_meshes(Baked& baked) {
    const AllowedWidth allowed(baked.objects);
    for (WorldInput::Triangles& mesh : baked.input.meshes)
        mesh.wide = is_wide(mesh.positions, mesh.triangles, max_side(baked.objects[mesh.object].bounds),
                            allowed.for_object(mesh.object));
    for (WorldInput::Instance& instance : baked.input.instances) {
        const WorldInput::SharedMesh& mesh = baked.input.shared_meshes[instance.mesh];
        const float size = max_side(baked.objects[instance.object].bounds);
        const float beside = allowed.for_object(instance.object);
        if (size <= beside || mesh.triangles->size() > max_wide_triangles) continue;
        instance.wide =
            is_wide(in_world(*mesh.positions, instance.world_from_mesh), *mesh.triangles, size, beside);
    }
}

} // namespace glint::scene
