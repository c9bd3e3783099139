#include "render/aspect.h"

#include "parallel/task_pool.h"
#include "render/aspect.shared.h"
#include "render/camera_sampler.h"

#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <mutex>

namespace glint {

static_assert(shown_shadows == static_cast<int>(Aspect::shadows) &&
              shown_normal == static_cast<int>(Aspect::normal) &&
              shown_depth == static_cast<int>(Aspect::depth) && shown_cost == static_cast<int>(Aspect::cost));

bool is_light(Aspect aspect) { return aspect == Aspect::final || term_of(aspect); }

std::optional<Term> term_of(Aspect aspect) {
    const int number = static_cast<int>(aspect) - static_cast<int>(Aspect::ambient);
    if (number < 0 || number >= term_count) return std::nullopt;
    return static_cast<Term>(number);
}

const char* aspect_name(Aspect aspect) {
    if (const auto term = term_of(aspect)) return term_name(*term);
    switch (aspect) {
    case Aspect::shadows:
        return "shadows";
    case Aspect::normal:
        return "normal";
    case Aspect::depth:
        return "depth";
    case Aspect::cost:
        return "cost";
    default:
        return "final";
    }
}

Scene scene_for(const Scene& scene, Aspect aspect) {
    if (is_light(aspect)) return scene;
    auto shallow = std::make_shared<FrozenScene>(scene.frozen());
    shallow->description.whitted.max_depth = 0;
    shallow->all_but_view = std::make_shared<int>();
    return Scene(std::move(shallow));
}

Probe::Probe(const Scene& scene, Aspect aspect, const CancelFlag* cancel, const KernelChoice& kernel)
    : scene_(scene_for(scene, aspect)), aspect_(aspect), term_(term_of(aspect)),
      tracer_(scene_.frozen(), cancel, kernel) {}

vec3 Probe::part_of(const Terms& terms) const { return term_ ? terms[*term_] : terms.sum(); }

void Probe::measure(std::span<const CameraSample> samples, std::span<Channels> scratch,
                    std::span<vec3> values) {
    if (is_light(aspect_)) {
        estimate(samples, scratch);
        for (std::size_t i = 0; i < samples.size(); ++i) values[i] = part_of(scratch[i].terms);
        return;
    }
    for (std::size_t i = 0; i < samples.size(); ++i) values[i] = measure_first_hit(samples[i]);
}

vec3 Probe::measure_first_hit(const CameraSample& sample) {
    if (aspect_ == Aspect::cost) {
        Ray ray;
        ray.origin = sample.origin;
        ray.direction = sample.direction;
        const TraceCost cost = scene_.frozen().world.cost(ray);
        return cost_number(cost.nodes, cost.shapes);
    }
    tracer_.trace(sample.origin, sample.direction, &tree_);
    if (tree_.nodes.empty()) return vec3(0.0f); // cancelled
    const RayNode& node = tree_.nodes.front();
    float hidden = 0;
    for (const LightNode& light : node.lights) hidden = hidden_with(hidden, light.shadow);
    return first_hit_number(static_cast<int>(aspect_), static_cast<bool>(node.hit), node.hit.t,
                            node.shading_normal, hidden);
}

namespace {

/// A picture of numbers: rows over threads, one ray a pixel.
class AspectJob {
  public:
    AspectJob(const Scene& scene, const RenderOptions& options)
        : options_(options), sampler_(scene.description()),
          area_(picture_area(scene.render_settings(), options.crop)) {
        picture_.image = Image(area_.width, area_.height);
        TaskPool pool(options.threads);
        for (int i = 0; i < pool.threads(); ++i)
            probes_.emplace_back(scene, options.show, options.cancel, options.kernel);
        start_ = Clock::now();
        pool.run(static_cast<std::size_t>(area_.height),
                 [this](std::size_t row, int worker) { measure_row(static_cast<int>(row), worker); });
    }

    Picture result() {
        for (const Probe& probe : probes_) {
            picture_.stats.primary_rays += probe.counts().primary;
            picture_.stats.shadow_rays += probe.counts().shadow;
        }
        picture_.stats.threads = static_cast<int>(probes_.size());
        picture_.stats.wall_seconds = seconds();
        picture_.complete = progress_.tiles_done == progress_.tiles;
        return std::move(picture_);
    }

  private:
    using Clock = std::chrono::steady_clock;

    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    bool cancelled() const { return options_.cancel != nullptr && options_.cancel->load(); }

    void measure_row(int row, int worker) {
        if (cancelled()) return;
        std::vector<CameraSample> samples(static_cast<std::size_t>(area_.width));
        std::vector<Channels> channels(samples.size());
        std::vector<vec3> values(samples.size());
        for (std::size_t i = 0; i < samples.size(); ++i)
            samples[i] = sampler_.centre({area_.x + static_cast<int>(i), area_.y + row});
        probes_[static_cast<std::size_t>(worker)].measure(samples, channels, values);
        if (cancelled()) return;
        float* pixel = picture_.image.at(0, row);
        for (const vec3& value : values)
            for (int channel = 0; channel < 3; ++channel) *pixel++ = value[channel];
        report();
    }

    void report() {
        const std::lock_guard lock(mutex_);
        progress_.tiles = static_cast<std::uint64_t>(area_.height);
        progress_.tiles_done += 1;
        progress_.rays += static_cast<std::uint64_t>(area_.width);
        progress_.seconds = seconds();
        if (options_.progress) options_.progress(progress_);
    }

    const RenderOptions& options_;
    const CameraSampler sampler_;
    const Rect area_;
    Picture picture_;
    std::vector<Probe> probes_;
    Clock::time_point start_;
    std::mutex mutex_;
    Progress progress_;
};

} // namespace

Picture render_term(const RenderOptions& options,
                    const std::function<Picture(const RenderOptions&)>& render_light) {
    RenderOptions all = options;
    all.show = Aspect::final;
    all.terms = true;
    Picture picture = render_light(all);
    picture.image = picture.terms[static_cast<std::size_t>(*term_of(options.show))];
    if (!options.terms) picture.terms = {};
    return picture;
}

Picture render_aspect(const Scene& scene, const RenderOptions& options) {
    if (!term_of(options.show)) return AspectJob(scene, options).result();
    return render_term(options, [&](const RenderOptions& all) { return render(scene, all); });
}

} // namespace glint
