#pragma once
// Rays without light, to test and measure traversal.

#include "gpu/context.h"
#include "gpu/program.h"
#include "gpu/scene_buffers.h"
#include "math/index.h"

#include <cstdint>
#include <span>
#include <vector>

namespace glint::gpu {

/// Input of shaders/rays.glsl.
struct GpuRay {
    vec3 origin{0.0f};
    vec3 direction{0.0f};
    float limit = 0; ///< hits have 0 < t ≤ limit
};

/// Its output, which overwrites the ray.
struct GpuHit {
    float t = 0;
    float u = 0; ///< u and v as in trace/world/world.h
    float v = 0;
    std::uint32_t object = invalid_index; ///< what was hit
    std::uint32_t prim = 0;
    std::uint32_t nodes = 0;  ///< if steps are counted: nodes whose children's boxes were tested
    std::uint32_t shapes = 0; ///< the same: shapes that were tested
};
static_assert(sizeof(GpuRay) == sizeof(GpuHit) && sizeof(GpuHit) == 7 * 4);

class GpuRays {
  public:
    /// Throws Error(device) as GpuRenderer does. The context must outlive it.
    GpuRays(const GpuContext& context, const scene::SceneData& scene, bool count_steps);
    ~GpuRays();

    /// The closest hit of each ray; with `any`, whichever was found first.
    std::vector<GpuHit> trace(std::span<const GpuRay> rays, bool any);

    /// Time that the device took for all rays so far.
    double seconds() const { return seconds_; }

  private:
    struct Parts {
        GpuSettings settings;
        SceneBuffers scene;
        GpuProgram program;
        GpuTimer timer;
    };

    const GpuContext& context_;
    std::unique_ptr<Parts> parts_;
    double seconds_ = 0;
};

} // namespace glint::gpu
