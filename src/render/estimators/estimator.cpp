#include "render/estimators/estimator.h"

#include "trace/simd/kernel_table.h"

namespace glint {

Estimator make_estimator(const SceneData& scene, Aov show, const CancelFlag* cancel,
                         const KernelChoice& kernel) {
    trace::row_of(kernel.target); // throws where the machine lacks it
    if (!is_light(show)) return AovEstimator(scene, show, cancel, kernel);
    const WhittedSettings& settings = scene.description.whitted;
    if (kernel.kernel == Kernel::scalar) return Whitted(scene, settings, cancel, kernel);
    return WhittedWavefront(scene, settings, cancel, kernel);
}

void estimate(Estimator& estimator, std::span<const CameraSample> samples, std::span<Channels> out,
              bool terms) {
    std::visit([&](auto& e) { e.estimate(samples, out, terms); }, estimator);
}

RayCounts ray_counts(const Estimator& estimator) {
    return std::visit([](const auto& e) -> RayCounts { return e.counts(); }, estimator);
}

} // namespace glint
