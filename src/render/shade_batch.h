#pragma once
// The steps of shading/whitted.shared.h for many paths at once, compiled for each SIMD target.

#include "render/estimators/path_states.h"
#include "trace/simd/kernel_table.h"

#include <array>
#include <cstddef>

namespace glint::rendering {

/// Numbers of branches.
struct Branches {
    std::size_t followed = 0;
    std::size_t left_out = 0; ///< below min_weight
};

struct ShadeKernels {
    /// After World::surfaces(): turns normals toward the viewer, copies what shading needs of the materials.
    void (*set_up)(Wave wave, PathStates& states);
    /// Sets the terms without lights.
    void (*start_terms)(const vec3& ambient_light, Wave wave, PathStates& states);
    /// Sets what arrives from a light, and the shadow rays. Returns how many are sent; the others can meet
    /// nothing.
    std::size_t (*spawn_shadow_rays)(const WhittedModes& modes, const LightRecord& light, Wave wave,
                                     PathStates& states);
    /// Adds the light; the share that passes blockers is in PathStates already.
    void (*add_light)(const WhittedModes& modes, Wave wave, PathStates& states);
    /// Limits the local terms where the model clamps.
    void (*limit_terms)(const WhittedModes& modes, Wave wave, PathStates& states);
    /// Weighs the local terms of opaque mirrors and writes those of their reflected rays that are worth
    /// following from `next` on; returns how many.
    Branches (*spawn_reflected)(const WhittedModes& modes, float min_weight, Wave wave, std::size_t next,
                                PathStates& states);
    /// Sets the sums of the terms.
    void (*sum_terms)(Wave wave, PathStates& states);
    /// Sets the terms of the parents that the wave's sums are.
    void (*add_to_parents)(Wave wave, PathStates& states);
};
extern const std::array<ShadeKernels, trace::kernel_targets> shade_kernels;

} // namespace glint::rendering
