#include "glint/progressive.h"

#include "render/cpu_executor.h"
#include "render/schedule_run.h"

#include <optional>

namespace glint {

struct Progressive::State {
    explicit State(int threads) : pool(threads) {}

    parallel::TaskPool pool;
    rendering::Film film;
    std::optional<Scene> scene; ///< kept alive for the executor
    std::optional<rendering::CpuExecutor> executor;
    std::optional<rendering::ScheduleRun<rendering::CpuExecutor>> run;
};

Progressive::Progressive(int threads) : state_(std::make_unique<State>(threads)) {}
Progressive::~Progressive() = default;

void Progressive::start(const Scene& scene, const ProgressiveOptions& options) {
    State& s = *state_;
    RenderOptions wanted;
    wanted.show = options.show;
    const rendering::FilmLayout layout = rendering::film_layout(scene.render_settings(), wanted);
    std::vector<rendering::Pass> passes = rendering::refining_passes(options.coarsest, layout.samples);
    s.run.reset();
    s.scene = scene;
    s.film.start(layout);
    s.executor.emplace(scene.data(), s.film, s.pool, options.kernel, options.cancel);
    s.run.emplace(*s.executor, std::move(passes), options.cancel);
}

bool Progressive::advance(double seconds) {
    if (!state_->run) return false;
    state_->run->run(rendering::wall_seconds() + seconds);
    return !state_->run->is_finished();
}

const Image& Progressive::image() const { return state_->film.image(); }
const Refinement& Progressive::reached() const {
    static const Refinement nothing;
    return state_->run ? state_->run->reached() : nothing;
}
int Progressive::threads() const { return state_->pool.threads(); }

} // namespace glint
