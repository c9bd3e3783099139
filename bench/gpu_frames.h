#pragma once
// Rendering whole pictures on a graphics card.

#include "glint/gpu.h"
#include "model.h"

#include <string>
#include <vector>

namespace glint::bench {

struct FrameResult {
    std::string scene;
    std::uint64_t triangles = 0;
    std::uint64_t rays = 0;
    double device_seconds = 0; ///< median over the rounds
    double whole_seconds = 0;  ///< including dispatches and reading back
    double far = 0;            ///< fraction of pixels that differ from the CPU's by more than 1/255
    std::string fault;         ///< reason if there are no figures
};

struct FrameSize {
    int width = 1920;
    int height = 1080;
};

/// Renders with one sample a pixel. The meshes of the scene must exist.
FrameResult measure_frame_of(GpuRenderer& renderer, const std::string& name, SceneDescription scene,
                             const FrameSize& size, int rounds);

/// Measures all scene files of a folder, sorted by name.
std::vector<FrameResult> measure_folder(GpuRenderer& renderer, const std::string& folder,
                                        const FrameSize& size, int rounds);

/// Instances of the mesh in a square grid with about `triangles` triangles in total.
SceneDescription field_of(const Model& model, double triangles);

} // namespace glint::bench
