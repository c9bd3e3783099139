#pragma once
// The steps of shading for many flights at once, as compiled for each SIMD target: the steps of
// shading/whitted_steps.shared.h on vectors of flights. WhittedTracer has the same steps for one ray.

#include "render/flights.h"
#include "trace/kernel_table.h"

#include <array>
#include <cstddef>

namespace glint {

struct ShadeKernels {
    /// From World::surfaces(): turns normals to the viewer, notes what shading needs of the materials.
    void (*set_up)(const FrozenScene& scene, Level level, Flights& flights);
    /// The terms without lights.
    void (*start_terms)(const FrozenScene& scene, Level level, Flights& flights);
    /// What arrives from a light, and the shadow rays; how many may meet something.
    std::size_t (*aim)(const LightRecord& light, Level level, Flights& flights);
    /// Adds the light that passes.
    void (*add_light)(const WhittedModes& modes, Level level, Flights& flights);
    /// Limits the terms where the scene says so.
    void (*limit_terms)(const WhittedModes& modes, Level level, Flights& flights);
    /// Mirror rays of opaque surfaces: weighs the local terms, writes the rays from `next` on; how many.
    std::size_t (*reflect)(const WhittedModes& modes, Level level, std::size_t next, Flights& flights);
    /// Adds the terms up.
    void (*sum_terms)(Level level, Flights& flights);
    /// Hands each flight's sum to its parent.
    void (*bring)(Level level, Flights& flights);
};
extern const std::array<ShadeKernels, kernel_targets> shade_kernels;

} // namespace glint
