#include "glint/render.h"

#include "render/cpu_executor.h"
#include "render/schedule_run.h"

#include <ctime>

namespace glint {
namespace {

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

} // namespace

Picture render(const Scene& scene, const RenderOptions& options) {
    const double wall = rendering::wall_seconds();
    const double cpu = cpu_seconds();
    rendering::Film film(rendering::film_layout(scene.render_settings(), options));
    parallel::TaskPool pool(options.threads);
    rendering::CpuExecutor executor(scene.data(), film, pool, options.kernel, options.cancel);
    rendering::ScheduleRun run(executor, rendering::one_pass(film.layout().samples), options.cancel,
                               options.progress);
    run.run(rendering::no_deadline);
    Picture picture;
    film.move_to(picture);
    picture.complete = run.is_finished();
    run.add_stats(picture.stats);
    picture.stats.wall_seconds = rendering::wall_seconds() - wall;
    picture.stats.cpu_seconds = cpu_seconds() - cpu;
    return picture;
}

} // namespace glint
