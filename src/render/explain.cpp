// Explanations of pixels: their samples and how these are combined.

#include "glint/explain.h"

#include "glint/scene.h"
#include "imaging/pixel_sum.h"
#include "parallel/task_pool.h"
#include "render/camera_sampler.h"
#include "render/contrast.h"
#include "render/estimators/whitted.h"
#include "render/explain_parts.h"

#include <optional>
#include <vector>

namespace glint {

using rendering::Terms;

struct Explainer::State {
    State(const Scene& whole, const CancelFlag* stop)
        : scene(whole), settings(whole.render_settings()), counts(sample_counts(settings)),
          sampler(whole.data().description), parts(whole.data()), cancel(stop),
          estimator(whole.data(), whole.data().description.whitted, stop) {
        if (settings.integrator != Integrator::whitted)
            throw Error(ErrorKind::usage, "only pictures of the integrator whitted can be explained");
    }

    /// The colour of a pixel before any is refined.
    vec3 unrefined(const rendering::Pixel& pixel) {
        if (counts.all == 1) return estimator.trace(sampler.centre(pixel), nullptr).terms.sum();
        imaging::PixelSum<Terms> sum;
        for (int i = 0; i < counts.all; ++i) {
            const rendering::CameraSample camera = sampler.sample(pixel, i);
            sum.add(estimator.trace(camera, nullptr).terms, camera.weight);
        }
        return sum.value().sum();
    }

    bool differs_from_neighbour(const rendering::Pixel& pixel) {
        const vec3 color = unrefined(pixel);
        for (const rendering::Neighbour& n : rendering::neighbours) {
            const rendering::Pixel other{pixel.x + n.dx, pixel.y + n.dy};
            const bool exists =
                other.x >= 0 && other.y >= 0 && other.x < settings.width && other.y < settings.height;
            if (exists && rendering::differ(color, unrefined(other))) return true;
        }
        return false;
    }

    /// Sample i of `samples`.
    ExplainedSample sample(int x, int y, int i, int samples, const ExplainLimits& limits) {
        const bool with_rays = i < limits.samples;
        const imaging::FilterSample film =
            samples == 1 ? imaging::FilterSample{} : sampler.film_sample({x, y}, i);
        const rendering::CameraSample camera = sampler.sample_at({x, y}, i, film);
        ExplainedSample out;
        out.dx = film.dx;
        out.dy = film.dy;
        out.weight = film.weight;
        const Terms terms = estimator.trace(camera, with_rays ? &tree : nullptr).terms;
        rendering::stop_if_cancelled(cancel);
        out.terms = terms.value;
        out.radiance = terms.sum();
        if (with_rays) out.rays = rendering::explain_tree(parts, tree, limits.weight, cancel);
        return out;
    }

    const Scene scene;
    const RenderSettings& settings;
    const SampleCounts counts;
    const rendering::CameraSampler sampler;
    const rendering::ExplainedScene parts;
    const CancelFlag* cancel;
    rendering::Whitted estimator;
    rendering::RayTree tree;
};

namespace {

std::string rule_of(const imaging::PixelSum<Terms>& sum, int positive, int negative) {
    const auto count = [](int n) { return std::to_string(n) + (n == 1 ? " sample" : " samples"); };
    if (positive + negative == 1) return "one ray through the pixel's centre";
    if (negative == 0 || positive == 0) return "the mean of " + count(positive + negative);
    if (sum.counts(-1))
        return "the sum of " + count(positive) + " minus the sum of " + std::to_string(negative) +
               " on the filter's negative lobe, divided by " + std::to_string(positive - negative);
    return "the mean of " + count(positive) + "; " + std::to_string(negative) +
           " on the filter's negative lobe count only where there are " +
           std::to_string(imaging::samples_for_lobes) + " or more, and not too many of them";
}

} // namespace

Explainer::Explainer(const Scene& scene, const CancelFlag* cancel)
    : state_(std::make_unique<State>(scene, cancel)) {}
Explainer::~Explainer() = default;
Explainer::Explainer(Explainer&&) noexcept = default;
Explainer& Explainer::operator=(Explainer&&) noexcept = default;

Explanation Explainer::pixel(int x, int y, const ExplainLimits& limits) {
    const RenderSettings& r = state_->settings;
    if (x < 0 || y < 0 || x >= r.width || y >= r.height)
        throw Error(ErrorKind::usage,
                    "pixel " + std::to_string(x) + "," + std::to_string(y) + " is not in the picture",
                    "the picture has " + std::to_string(r.width) + "×" + std::to_string(r.height) +
                        " pixels; 0,0 is top left");
    Explanation out;
    out.x = x;
    out.y = y;
    out.width = r.width;
    out.height = r.height;
    out.filter = name_of(r.filter);
    out.origin = state_->scene.data().origin;
    const SampleCounts& counts = state_->counts;
    const bool refined = counts.adaptive() && state_->differs_from_neighbour({x, y});
    const int samples = refined ? counts.differing : counts.all;
    imaging::PixelSum<Terms> sum;
    int negative = 0;
    for (int i = 0; i < samples; ++i) {
        out.samples.push_back(state_->sample(x, y, i, samples, limits));
        const ExplainedSample& sample = out.samples.back();
        sum.add(Terms{sample.terms}, sample.weight);
        negative += sample.weight > 0 ? 0 : 1;
    }
    for (ExplainedSample& sample : out.samples) sample.counts = sum.counts(sample.weight);
    out.rule = rule_of(sum, samples - negative, negative);
    if (counts.adaptive())
        out.rule += refined ? ", as it differs from a neighbour" : ", as it differs from no neighbour";
    // One sample is its pixel as it is, like in the picture: no division touches it.
    const Terms terms = samples == 1 ? Terms{out.samples.front().terms} : sum.value();
    out.terms = terms.value;
    out.color = terms.sum();
    return out;
}

std::vector<Explanation> explain_pixels(const Scene& scene, std::span<const PixelCoord> pixels,
                                        const ExplainLimits& limits, int threads, const CancelFlag* cancel) {
    std::vector<Explanation> out(pixels.size());
    parallel::TaskPool pool(threads);
    std::vector<std::optional<Explainer>> explainers(static_cast<std::size_t>(pool.threads()));
    pool.run(pixels.size(), [&](std::size_t i, int worker) {
        std::optional<Explainer>& own = explainers[static_cast<std::size_t>(worker)];
        if (!own) own.emplace(scene, cancel);
        out[i] = own->pixel(pixels[i].x, pixels[i].y, limits);
    });
    return out;
}

Explanation explain(const Scene& scene, int x, int y) { return Explainer(scene).pixel(x, y); }

} // namespace glint
