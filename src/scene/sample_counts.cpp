#include "glint/scene.h"

namespace glint {

SampleCounts sample_counts(const RenderSettings& settings) {
    SampleCounts counts{settings.spp.value_or(traces_paths(settings.integrator) ? 64 : 4), settings.max_spp};
    if (!settings.spp && settings.integrator == Integrator::whitted)
        counts = {1, settings.max_spp > 0 ? settings.max_spp : 8};
    if (counts.differing <= counts.all) counts.differing = 0;
    return counts;
}

} // namespace glint
