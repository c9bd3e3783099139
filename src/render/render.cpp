#include "glint/render.h"

#include "glint/names.h"
#include "render/film.h"
#include "render/schedule_run.h"

#include <ctime>

namespace glint {
namespace {

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::string size_text(const RenderSettings& r) {
    return std::to_string(r.width) + "x" + std::to_string(r.height);
}

} // namespace

Picture render(const Scene& scene, const RenderOptions& options) {
    const double wall = wall_seconds();
    const double cpu = cpu_seconds();
    Film film(film_layout(scene.render_settings(), options));
    const FilmLayout& layout = film.layout();
    TaskPool pool(options.threads);
    ScheduleRun run(scene.frozen(), {layout.area, layout.tile_size, one_pass(layout.samples), {}}, film, pool,
                    {options.show, options.kernel, options.cancel, options.progress});
    run.run(no_deadline);
    Picture picture;
    film.move_to(picture);
    picture.complete = run.is_finished();
    run.add_stats(picture.stats);
    picture.stats.wall_seconds = wall_seconds() - wall;
    picture.stats.cpu_seconds = cpu_seconds() - cpu;
    return picture;
}

std::vector<std::pair<std::string, std::string>> picture_settings(const Scene& scene) {
    const RenderSettings& r = scene.frozen().description.render;
    const WhittedSettings& w = scene.frozen().description.whitted;
    return {{"glint.version", version()},
            {"glint.size", size_text(r)},
            {"glint.spp", std::to_string(r.spp)},
            {"glint.seed", std::to_string(r.seed)},
            {"glint.integrator", r.integrator},
            {"glint.filter", std::string(name_of(r.filter))},
            {"glint.max_depth", std::to_string(w.max_depth)},
            {"glint.shadows", std::string(name_of(w.shadows))},
            {"glint.clamp", w.clamp ? "true" : "false"},
            {"glint.energy", std::string(name_of(w.energy))},
            {"glint.highlight_model", std::string(name_of(w.highlight_model))}};
}

const char* version() { return GLINT_VERSION; }

} // namespace glint
