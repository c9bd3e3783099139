#pragma once
// The sets of rays on a graphics card.

#include "gpu/context.h"
#include "jobs.h"

#include <cstdint>
#include <string>
#include <vector>

namespace glint::bench {

/// What a set took, and what each of its rays needed.
struct GpuSetResult {
    std::string set;
    std::uint64_t rays = 0;
    double seconds = 0; ///< that the device worked, median of the rounds
    double nodes = 0;   ///< a ray; 0 for `frame`, which is not counted
    double triangles = 0;
    std::uint64_t differences = 0; ///< answers unlike the CPU's; pixels beyond 1/255 for `frame`
};

/// primary, shadow, ao and bounce as they are for the CPU; `frame` as a picture of the renderer with a
/// shadow ray and a mirror ray for each hit. options.batch does not count.
std::vector<GpuSetResult> measure_gpu_rays(const GpuContext& context, GpuRenderer& renderer,
                                           const Model& model, const JobOptions& options, int rounds);

/// The model as a scene: the mesh, partly a mirror, and its light.
SceneDescription scene_of(const Model& model, int size);

} // namespace glint::bench
