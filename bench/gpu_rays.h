#pragma once
// Tracing the sets of rays on a graphics card.

#include "gpu/context.h"
#include "jobs.h"

#include <cstdint>
#include <string>
#include <vector>

namespace glint::bench {

/// Time and traversal steps of a set.
struct GpuSetResult {
    std::string set;
    std::uint64_t rays = 0;
    double seconds = 0; ///< device time, median over the rounds
    double nodes = 0;   ///< nodes a ray; 0 for `frame`, where they are not counted
    double triangles = 0;
    std::uint64_t differences = 0; ///< results that differ from the CPU's; for `frame`, pixels beyond 1/255
};

/// Measures primary, shadow, ao and bounce with the rays of the CPU, and `frame` as a rendered picture with a
/// shadow ray and a mirror ray for each hit. options.batch is ignored.
std::vector<GpuSetResult> measure_gpu_rays(const gpu::GpuContext& context, GpuRenderer& renderer,
                                           const Model& model, const JobOptions& options, int rounds);

/// The model as a scene: the mesh, partly a mirror, and its light.
SceneDescription scene_of(const Model& model, int size);

} // namespace glint::bench
