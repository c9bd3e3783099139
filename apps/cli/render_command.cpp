#include "commands.h"
#include "interrupt.h"
#include "json_output.h"
#include "outputs.h"
#include "progress.h"
#include "render_request.h"
#include "scene_input.h"
#include "text.h"

#include <fmt/format.h>

#include <chrono>

namespace glint::cli {
namespace {

class Stopwatch {
  public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

PictureOptions picture_options(const RenderRequest& request, const Scene& scene, Picture& picture,
                               const std::string& hash) {
    PictureOptions options;
    options.view = request.view;
    options.bits = request.bits;
    options.alpha = std::move(picture.coverage);
    if (request.render.terms)
        for (int i = 0; i < term_count; ++i)
            options.layers.push_back(
                {term_name(static_cast<Term>(i)), std::move(picture.terms[std::size_t(i)])});
    options.metadata = picture_settings(scene);
    if (const auto& crop = request.render.crop)
        options.metadata.emplace_back(
            "glint.crop", fmt::format("{},{},{},{}", crop->x, crop->y, crop->width, crop->height));
    options.metadata.emplace_back("glint.hash", hash);
    return options;
}

/// "scene.png: 640×480, 4 spp, 871,306 triangles, 1.23 s, 3.41 Mrays/s, hash …"
std::string closing_line(const RenderRecord& record, const Scene& scene, const Picture& picture) {
    const SceneStats stats = scene.stats();
    const std::string size =
        stats.triangles > 0 ? counted(stats.triangles, "triangle") : counted(stats.objects, "object");
    const std::string partial =
        picture.complete ? "" : fmt::format("stopped early with {:.0f} % done, ", record.fraction * 100);
    return fmt::format("{}: {}{}×{}, {} spp, {}, {}, {}, hash {}", shown_name(record.output), partial,
                       picture.image.width, picture.image.height, scene.render_settings().spp, size,
                       duration(picture.stats.wall_seconds),
                       ray_rate(picture.stats.rays(), picture.stats.wall_seconds), record.hash);
}

void print_details(Console& console, const Scene& scene, const RenderRecord& record,
                   const RenderStats& stats) {
    const SceneStats sizes = scene.stats();
    const std::string quality = sizes.tree_quality.empty() ? "" : sizes.tree_quality + " ";
    console.detail(fmt::format("read in {}, {}tree of {} with depth {} built in {}, {} held",
                               duration(record.load_seconds), quality, counted(sizes.tree_nodes, "node"),
                               sizes.tree_depth, duration(record.build_seconds),
                               bytes(static_cast<double>(sizes.bytes))));
    console.detail(fmt::format("rays: {} primary, {} reflected, {} refracted, {} shadow; {}",
                               with_commas(stats.primary_rays), with_commas(stats.reflected_rays),
                               with_commas(stats.refracted_rays), with_commas(stats.shadow_rays),
                               counted(static_cast<std::uint64_t>(stats.threads), "thread")));
}

/// Reads the scene, applies the flags and reports what is odd about it.
SceneDescription read_scene(const Arguments& arguments, const RenderRequest& request, Console& console) {
    LoadedScene loaded = load_scene(request.scene, request.load);
    apply_flags(arguments, loaded.description);
    require_possible(request, loaded.description.render);
    report(loaded, console);
    return std::move(loaded.description);
}

Picture render_with_progress(const Arguments& arguments, const RenderRequest& request, const Scene& scene,
                             Console& console, RenderRecord& record) {
    ProgressMeter meter(console, progress_style(arguments.text("progress").value_or("auto")));
    RenderOptions options = request.render;
    options.progress = [&](const Progress& progress) { meter.update(progress); };
    options.cancel = &cancel_flag();
    stop_gently();
    Picture picture = render(scene, options);
    meter.finish();
    record.fraction = picture.complete ? 1 : meter.fraction();
    return picture;
}

} // namespace

int render_command(const Arguments& arguments, Console& console) {
    const RenderRequest request = read_render_request(arguments);
    RenderRecord record{request.scene, request.output, {}, 1, 0, 0, 0};
    watch_signals();

    console.status("reading " + request.scene);
    const Stopwatch loading;
    const SceneDescription description = read_scene(arguments, request, console);
    record.load_seconds = loading.seconds();

    console.status("building the tree");
    const Stopwatch building;
    const Scene scene = freeze(description, {request.render.threads});
    record.build_seconds = building.seconds();
    console.warnings(warnings(scene));

    Picture picture = render_with_progress(arguments, request, scene, console, record);
    if (!picture.complete && !request.keep_partial) {
        console.error(fmt::format("stopped with {:.0f} % done, nothing written", record.fraction * 100),
                      "--keep-partial would write what there is");
        return stopped_by();
    }

    record.hash = picture_hash(picture.image);
    const Stopwatch writing;
    write_picture(request.output, picture.image, picture_options(request, scene, picture, record.hash));
    record.write_seconds = writing.seconds();
    if (request.stats) write_text(*request.stats, stats_json(record, scene, picture));
    print_details(console, scene, record, picture.stats);
    console.line(closing_line(record, scene, picture));
    return picture.complete ? exit_code::done : stopped_by();
}

} // namespace glint::cli
