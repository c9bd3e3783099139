#pragma once
// Whole pictures on a graphics card.

#include "glint/gpu.h"
#include "model.h"

#include <string>
#include <vector>

namespace glint::bench {

struct FrameResult {
    std::string scene;
    std::uint64_t triangles = 0;
    std::uint64_t rays = 0;
    double device_seconds = 0; ///< medians of the rounds
    double whole_seconds = 0;  ///< with sending work and reading the picture back
    double far = 0;            ///< share of the pixels beyond 1/255 of the CPU's
    std::string fault;         ///< why there are no figures
};

struct FrameSize {
    int width = 1920;
    int height = 1080;
};

/// One ray a pixel, of scenes whose meshes are there.
FrameResult measure_frame_of(GpuRenderer& renderer, const std::string& name, SceneDescription scene,
                             const FrameSize& size, int rounds);

/// All scene files of a folder, in the order of their names.
std::vector<FrameResult> measure_folder(GpuRenderer& renderer, const std::string& folder,
                                        const FrameSize& size, int rounds);

/// The mesh again and again in a square field, until there are about so many triangles; one mesh in memory.
SceneDescription field_of(const Model& model, double triangles);

} // namespace glint::bench
