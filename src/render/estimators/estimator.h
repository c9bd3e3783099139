#pragma once
// The closed set of estimators: each measures what camera rays see.

#include "render/aov.h"
#include "render/camera_sample.h"
#include "render/estimators/aov.h"
#include "render/estimators/whitted.h"
#include "render/estimators/whitted_wavefront.h"

#include <span>
#include <variant>

namespace glint {

/// Measures camera samples. Holds scratch memory: one for each thread.
using Estimator = std::variant<Whitted, WhittedWavefront, AovEstimator>;

/// The estimator of what a picture shows; of light, by the scene's integrator, one ray after another with
/// Kernel::scalar. It refers to the scene.
Estimator make_estimator(const SceneData& scene, Aov show, const CancelFlag* cancel,
                         const KernelChoice& kernel);

/// Measures each sample into its element of `out`; `terms` says whether light is to be told apart by term.
/// Values are of no use once the estimator's flag was set.
void estimate(Estimator& estimator, std::span<const CameraSample> samples, std::span<Channels> out,
              bool terms);

/// Rays since the estimator was made.
RayCounts ray_counts(const Estimator& estimator);

} // namespace glint
