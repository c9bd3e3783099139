#pragma once
// What pictures show beside the light: numbers of first hits, and single terms.

#include "glint/render.h"
#include "render/whitted.h"

#include <functional>
#include <optional>
#include <span>

namespace glint {

/// Is it the light or a part of it, with as many samples as the scene asks for? Else one ray a pixel tells.
bool is_light(Aspect aspect);
/// The term that an aspect is; the light as a whole is none.
std::optional<Term> term_of(Aspect aspect);

/// Measures an aspect along camera rays. Holds scratch memory: one for each thread.
class Probe {
  public:
    Probe(const Scene& scene, Aspect aspect, const CancelFlag* cancel, const KernelChoice& kernel);

    /// Measures the light.
    void estimate(std::span<const CameraSample> samples, std::span<Channels> out) {
        tracer_.estimate(samples, out);
    }
    /// The part of a sample's light that is asked for.
    vec3 part_of(const Terms& terms) const;
    /// The aspect along each sample's ray. `scratch` and `values` have an element for each.
    void measure(std::span<const CameraSample> samples, std::span<Channels> scratch, std::span<vec3> values);

    const RayCounts& counts() const { return tracer_.counts(); }

  private:
    vec3 measure_first_hit(const CameraSample& sample);

    const Scene scene_; ///< kept alive
    Aspect aspect_;
    std::optional<Term> term_;
    WhittedTracer tracer_;
    RayTree tree_;
};

/// The scene as an aspect needs it: where only first hits count, nothing bounces.
Scene scene_for(const Scene& scene, Aspect aspect);

/// A picture of the term that `options` asks for, by what renders the light with its terms apart.
Picture render_term(const RenderOptions& options,
                    const std::function<Picture(const RenderOptions&)>& render_light);

/// render() for all but Aspect::final.
Picture render_aspect(const Scene& scene, const RenderOptions& options);

} // namespace glint
