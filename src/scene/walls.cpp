// Walls between the camera or a light and what is to be seen.

#include "scene/walls.h"

#include "imaging/camera.h"

#include <algorithm>
#include <map>

namespace glint::scene {

namespace {

using trace::Hit;

constexpr int columns = 24;
constexpr int rows = 18;

/// What a ray of the camera meets first.
struct Seen {
    Ray ray;
    Hit hit;
    vec3 position{0.0f};
    vec3 normal{0.0f}; ///< toward the camera
};

/// The first hits on an even grid of pixels; rays that meet nothing are left out.
std::vector<Seen> seen_by_camera(const SceneData& scene) {
    const CameraDescription& c = *scene.description.camera;
    const RenderSettings& r = scene.description.render;
    const PinholeCamera camera =
        imaging::pinhole_camera(c.eye, c.direction, c.up, c.fov, c.fov_axis, r.width, r.height);
    std::vector<Seen> all;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            Seen seen;
            seen.ray.origin = camera.eye;
            seen.ray.direction = pinhole_direction(camera, (2 * column + 1) * r.width / (2 * columns),
                                                   (2 * row + 1) * r.height / (2 * rows), 0, 0);
            seen.hit = scene.world.closest(seen.ray);
            if (!seen.hit) continue;
            const SurfacePoint point = scene.world.surface(seen.ray, seen.hit);
            seen.position = point.p;
            seen.normal = dot(point.n, seen.ray.direction) > 0 ? -point.n : point.n;
            all.push_back(seen);
        }
    return all;
}

bool is_wall(const SceneData& scene, std::uint32_t id) {
    const Shape& shape = scene.description.objects[id].shape;
    const bool flat = std::holds_alternative<PlaneShape>(shape) || std::holds_alternative<DiskShape>(shape) ||
                      std::holds_alternative<TriangleShape>(shape) ||
                      std::holds_alternative<RectangleShape>(shape);
    return flat && scene.materials[scene.objects[id].material].transparency == 0;
}

bool something_behind(const SceneData& scene, const Seen& seen) {
    for (Hit hit = scene.world.next(seen.ray, seen.hit); hit; hit = scene.world.next(seen.ray, hit))
        if (hit.object != seen.hit.object) return true;
    return false;
}

/// Of how many points that the camera sees a light is kept by a wall, and by which.
class Shutter {
  public:
    Shutter(const SceneData& scene, const LightRecord& light) : scene_(scene), light_(light) {}

    /// False once the light reaches a point.
    bool add(const Seen& seen) {
        const vec3 to_light =
            light_.kind == light_directional ? -light_.direction : light_.position - seen.position;
        if (light_.kind == light_spot && dot(normalize(-to_light), light_.direction) < light_.cos_outer)
            return true;
        // The far side of a wall; that of a round object gets no light anyway.
        if (!(dot(seen.normal, to_light) > 0)) {
            if (is_wall(scene_, seen.hit.object)) ++kept_by_[seen.hit.object];
            return true;
        }
        const auto blocker = first_between(seen, to_light);
        if (!blocker || !is_wall(scene_, *blocker)) return false;
        ++kept_by_[*blocker];
        return true;
    }

    /// The wall that keeps the light from most points; none if those are few.
    std::optional<std::uint32_t> wall() const {
        constexpr int enough = 8;
        const auto most =
            std::ranges::max_element(kept_by_, {}, [](const auto& entry) { return entry.second; });
        if (most == kept_by_.end() || most->second < enough) return std::nullopt;
        return most->first;
    }

  private:
    /// The first object on the way to the light.
    std::optional<std::uint32_t> first_between(const Seen& seen, const vec3& to_light) const {
        constexpr float gap = 1e-3f; // of the distance: far more than rounding
        Ray ray;
        ray.origin = seen.position;
        ray.direction = to_light;
        ray.tmin = light_.kind == light_directional ? gap * length(seen.position - seen.ray.origin) : gap;
        if (light_.kind != light_directional) ray.tmax = 1;
        const Hit hit = scene_.world.closest(ray);
        return hit ? std::optional(hit.object) : std::nullopt;
    }

    const SceneData& scene_;
    const LightRecord& light_;
    std::map<std::uint32_t, int> kept_by_;
};

} // namespace

std::optional<std::uint32_t> wall_before_camera(const SceneData& scene) {
    const std::vector<Seen> seen = seen_by_camera(scene);
    if (seen.size() < static_cast<std::size_t>(columns * rows)) return std::nullopt;
    const std::uint32_t wall = seen.front().hit.object;
    const auto is_other = [&](const Seen& s) { return s.hit.object != wall; };
    if (!is_wall(scene, wall) || std::ranges::any_of(seen, is_other)) return std::nullopt;
    const auto hidden =
        std::ranges::count_if(seen, [&](const Seen& s) { return something_behind(scene, s); });
    return 100 * hidden > columns * rows ? std::optional(wall) : std::nullopt;
}

std::vector<ShutLight> lights_behind_walls(const SceneData& scene) {
    constexpr std::size_t max_lights = 64;
    const std::vector<Seen> seen = seen_by_camera(scene);
    std::vector<ShutLight> shut;
    for (std::uint32_t i = 0; i < std::min(scene.lights.size(), max_lights); ++i) {
        Shutter shutter(scene, scene.lights[i]);
        if (!std::ranges::all_of(seen, [&](const Seen& s) { return shutter.add(s); })) continue;
        if (const auto wall = shutter.wall()) shut.push_back({i, *wall});
    }
    return shut;
}

} // namespace glint::scene
