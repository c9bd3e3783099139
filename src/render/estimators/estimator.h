#pragma once
// The closed set of estimators: each measures what camera rays see. A new one needs no other file.

#include "render/aov.h"
#include "render/estimators/ambient_occlusion.h"
#include "render/estimators/aov.h"
#include "render/estimators/path.h"
#include "render/estimators/path_simple.h"
#include "render/estimators/whitted.h"
#include "render/estimators/whitted_wavefront.h"
#include "trace/simd/kernel_table.h"

#include <span>
#include <variant>

namespace glint::rendering {

/// Measures camera samples. Holds scratch memory: one for each thread.
using Estimator =
    std::variant<Whitted, WhittedWavefront, PathTracer, PathSimple, AmbientOcclusion, AovEstimator>;

/// The estimator for what a picture shows: for light the scene's integrator, which traces one ray after
/// another if the kernel is Kernel::scalar. It refers to the scene.
inline Estimator make_estimator(const scene::SceneData& scene, Aov show, const CancelFlag* cancel,
                                const KernelChoice& kernel) {
    trace::row_of(kernel.target); // throws where the machine lacks it
    if (!is_light(show)) return AovEstimator(scene, show, cancel, kernel);
    const Integrator integrator = scene.description.render.integrator;
    if (integrator == Integrator::path_simple) return PathSimple(scene, cancel, kernel);
    if (traces_paths(integrator)) return PathTracer(scene, cancel, kernel);
    if (integrator == Integrator::ambient_occlusion) return AmbientOcclusion(scene, cancel, kernel);
    const WhittedSettings& settings = scene.description.whitted;
    if (kernel.kernel == Kernel::scalar) return Whitted(scene, settings, cancel, kernel);
    return WhittedWavefront(scene, settings, cancel, kernel);
}

/// Measures each sample into its element of `out`; `terms` requests the terms of light too.
/// Values are useless once the estimator's cancel flag was set.
inline void estimate(Estimator& estimator, std::span<const CameraSample> samples, std::span<Channels> out,
                     bool terms) {
    std::visit([&](auto& e) { e.estimate(samples, out, terms); }, estimator);
}

/// Rays since the estimator was made.
inline RayCounts ray_counts(const Estimator& estimator) {
    return std::visit([](const auto& e) -> RayCounts { return e.counts(); }, estimator);
}

} // namespace glint::rendering
