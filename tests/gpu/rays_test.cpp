// Rays through the GPU's tree, hit by hit against the CPU's.

#include "gallery.h"
#include "gpu_kit.h"

#include "gpu/rays.h"
#include "math/random.shared.h"
#include "scene/scene_data.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glint::gpu {

using trace::Hit;
namespace {

/// From places in and about the scene, everywhere; some end early.
std::vector<GpuRay> rays_about(const Scene& scene, uint count) {
    const Bounds bounds = scene.data().world.bounds();
    const vec3 middle = bounds.empty() ? vec3(0.0f) : (bounds.lo + bounds.hi) * 0.5f;
    const float size = bounds.empty() ? 10.0f : glm::length(bounds.hi - bounds.lo);
    std::vector<GpuRay> rays;
    for (uint i = 0; i < count; ++i) {
        const vec2 a = sample_pair(pixel_key(7, 0, i, 0), 0, 0);
        const vec2 b = sample_pair(pixel_key(7, 0, i, 1), 0, 0);
        const vec2 c = sample_pair(pixel_key(7, 0, i, 2), 0, 0);
        GpuRay ray;
        ray.origin = middle + size * (vec3(a.x, a.y, b.x) - 0.5f);
        ray.direction = vec3(b.y, c.x, c.y) - 0.5f;
        ray.limit = i % 4 == 0 ? size : 3.4e38f;
        rays.push_back(ray);
    }
    return rays;
}

TEST(GpuRays, MeetWhatTheyMeetOnTheCpu) {
    GLINT_NEEDS_GPU();
    const GpuContext context(-1);
    for (const kit::Exhibit& exhibit : kit::gallery()) {
        const Scene scene = build_scene(exhibit.scene);
        const std::vector<GpuRay> rays = rays_about(scene, 3000);
        GpuRays gpu(context, scene.data(), true);
        const std::vector<GpuHit> closest = gpu.trace(rays, false);
        const std::vector<GpuHit> any = gpu.trace(rays, true);
        int differ = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            Ray ray;
            ray.origin = rays[i].origin;
            ray.direction = rays[i].direction;
            ray.tmax = rays[i].limit;
            const Hit hit = scene.data().world.closest(ray);
            const bool found = closest[i].object != invalid_index;
            const bool same = found == bool(hit) && found == (any[i].object != invalid_index) &&
                              (!found || (closest[i].object == hit.object && closest[i].prim == hit.prim &&
                                          std::abs(closest[i].t - hit.t) <= 1e-5f * hit.t));
            differ += same ? 0 : 1;
            EXPECT_LE(any[i].shapes, closest[i].shapes) << "the first that is found ends the search";
        }
        EXPECT_LE(differ, 3) << exhibit.name << ": rays along edges may meet either side";
        EXPECT_GT(gpu.seconds(), 0);
    }
}

} // namespace
} // namespace glint::gpu
