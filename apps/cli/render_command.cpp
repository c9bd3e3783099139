// glint render: a picture, or the frames of an animation.
#include "backend.h"
#include "commands.h"
#include "frames.h"
#include "interrupt.h"
#include "json_output.h"
#include "outputs.h"
#include "progress.h"
#include "render_request.h"
#include "scene_input.h"
#include "text.h"

#include <fmt/format.h>

#include <chrono>
#include <optional>
#include <set>

namespace glint::cli {
namespace {

/// Seconds of a monotonic clock.
double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

PictureOptions picture_options(const RenderRequest& request, const Scene& scene, Picture& picture,
                               const RenderRecord& record) {
    PictureOptions options;
    options.view = request.view;
    options.bits = request.bits;
    options.alpha = std::move(picture.coverage);
    if (request.render.terms)
        for (int i = 0; i < term_count; ++i)
            options.layers.push_back(
                {term_name(static_cast<Term>(i)), std::move(picture.terms[std::size_t(i)])});
    options.metadata = picture_settings(scene);
    if (request.render.show != Aov::final)
        options.metadata.emplace_back("glint.show", aov_name(request.render.show));
    if (const auto& crop = request.render.crop)
        options.metadata.emplace_back(
            "glint.crop", fmt::format("{},{},{},{}", crop->x, crop->y, crop->width, crop->height));
    // The last bits depend on the rounding of the graphics card.
    if (!record.device.empty()) options.metadata.emplace_back("glint.device", record.device);
    options.metadata.emplace_back("glint.hash", record.hash);
    return options;
}

/// "4 spp", or "1..16 spp, 2.7 on average".
std::string samples_text(const RenderSettings& settings, const Picture& picture) {
    if (settings.max_spp <= settings.spp) return fmt::format("{} spp", settings.spp);
    return fmt::format("{}..{} spp, {:.1f} on average", settings.spp, settings.max_spp,
                       samples_per_pixel(picture));
}

/// "scene.png: 640×480, 4 spp, 871,306 triangles, 1.23 s, 3.41 Mrays/s, hash …"
std::string closing_line(const RenderRecord& record, const Scene& scene, const Picture& picture) {
    const SceneStats stats = scene.stats();
    const std::string size =
        stats.triangles > 0 ? counted(stats.triangles, "triangle") : counted(stats.objects, "object");
    const std::string partial =
        picture.complete ? "" : fmt::format("stopped early with {:.0f} % done, ", record.fraction * 100);
    const std::string device = record.device.empty() ? "" : "on " + record.device + ", ";
    return fmt::format("{}: {}{}×{}, {}, {}, {}{}, {}, hash {}", shown_name(record.output), partial,
                       picture.image.width, picture.image.height,
                       samples_text(scene.render_settings(), picture), size, device,
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

/// Renders pictures of one scene, one after the other.
class Renderer {
  public:
    Renderer(const Arguments& arguments, const RenderRequest& request, Console& console)
        : arguments_(arguments), request_(request), console_(console), backend_(arguments, console) {}

    /// Reads the scene and reports its notes and warnings.
    LoadedScene read() {
        const double loading_start = now();
        LoadedScene loaded = read_scene(request_.scene, request_.load);
        load_seconds_ = now() - loading_start;
        apply_flags(arguments_, loaded.description);
        require_possible(request_, loaded.description.render);
        report(loaded, console_);
        return loaded;
    }

    /// Renders and writes a picture; false if a signal stopped it. `task`: text for the progress.
    bool picture(const SceneDescription& description, RenderRecord record, const std::string& task) {
        record.load_seconds = load_seconds_;
        console_.status("building the tree");
        const double building_start = now();
        BuildSceneOptions how;
        how.threads = request_.render.threads;
        const Scene scene = last_ ? update_scene(*last_, description, how) : build_scene(description, how);
        last_ = scene;
        record.build_seconds = now() - building_start;
        warn(scene);

        Picture picture = render_with_progress(scene, record, task);
        if (cancel_flag() && !request_.keep_partial) {
            stopped_at_ = record.fraction;
            return false;
        }
        record.hash = picture_hash(picture.image);
        // PNG shows AOVs as colours; the other formats hold their values.
        if (output_format(record.output) == PictureFormat::png)
            picture.image = visible(picture.image, request_.render.show, scene);
        const double writing_start = now();
        const PictureOptions options = picture_options(request_, scene, picture, record);
        write_output({"-o", record.output}, [&] { write_picture(record.output, picture.image, options); });
        record.write_seconds = now() - writing_start;
        if (request_.stats) stats_.push_back(stats_json(record, scene, picture));
        print_details(console_, scene, record, picture.stats);
        console_.line(closing_line(record, scene, picture));
        return picture.complete;
    }

    /// Writes --stats: an object, or with --frames a list of objects.
    void write_stats() const {
        if (!request_.stats || (stats_.empty() && !request_.frames)) return;
        if (waits_for_reader(*request_.stats)) stop_at_once();
        write_text({"--stats", *request_.stats}, request_.frames ? stats_list_json(stats_) : stats_.front());
    }

    /// Fraction of the last picture that was done when a signal came.
    double stopped_at() const { return stopped_at_; }

  private:
    /// Each warning once for all frames.
    void warn(const Scene& scene) {
        for (const Diagnostic& diagnostic : warnings(scene))
            if (warned_.insert(to_string(diagnostic)).second) console_.warning(diagnostic);
    }

    Picture render_with_progress(const Scene& scene, RenderRecord& record, const std::string& task) {
        stop_gently();
        ProgressMeter meter(console_, progress_style(arguments_.text("progress").value_or("auto")), task);
        RenderOptions options = request_.render;
        options.progress = [&](const Progress& progress) { meter.update(progress); };
        options.cancel = &cancel_flag();
        RenderedPicture rendered = backend_.render(scene, options);
        if (waits_for_reader(record.output)) stop_at_once();
        meter.finish();
        record.device = rendered.device;
        record.fraction = rendered.picture.complete ? 1 : meter.fraction();
        return std::move(rendered.picture);
    }

    const Arguments& arguments_;
    const RenderRequest& request_;
    Console& console_;
    Backend backend_;
    std::optional<Scene> last_; ///< the next picture may share its trees
    double load_seconds_ = 0;
    double stopped_at_ = 0;
    std::vector<std::string> stats_;
    std::set<std::string> warned_;
};

RenderRecord make_record(const RenderRequest& request) {
    RenderRecord record;
    record.scene = request.scene;
    record.output = request.output;
    return record;
}

int render_still(const RenderRequest& request, Renderer& renderer, Console& console) {
    const LoadedScene loaded = renderer.read();
    require_outputs(loaded.files, outputs(request, {}));
    if (!loaded.animation.keys.empty())
        console.note("the scene moves, and this is how it stands; --frames all renders its frames");
    const bool done = renderer.picture(loaded.description, make_record(request), {});
    renderer.write_stats();
    if (done) return exit_code::done;
    if (!request.keep_partial)
        console.error(fmt::format("stopped with {:.0f} % done, nothing written", renderer.stopped_at() * 100),
                      "--keep-partial would write what there is");
    return stopped_by();
}

int render_frames(const Arguments& arguments, const RenderRequest& request, Renderer& renderer,
                  Console& console) {
    const LoadedScene loaded = renderer.read();
    if (loaded.animation.keys.empty()) console.note("nothing in the scene moves: it has no [[animate]]");
    const std::vector<int> frames = request.frames->of(loaded.animation);
    require_outputs(loaded.files, outputs(request, frames));
    // Errors of late frames are reported before the first one is rendered.
    for (const int frame : frames) scene_at(loaded, frame);

    const double rendering_start = now();
    std::size_t done = 0;
    for (const int frame : frames) {
        SceneDescription description = scene_at(loaded, frame);
        apply_flags(arguments, description);
        require_possible(request, description.render);
        RenderRecord record = make_record(request);
        record.output = frame_name(request.output, frame);
        record.frame = frame;
        const std::string task = fmt::format("frame {} ({} of {})", frame, done + 1, frames.size());
        if (!renderer.picture(description, record, task)) break;
        ++done;
    }
    renderer.write_stats();
    if (done == frames.size()) {
        console.line(fmt::format("{} in {}", counted(done, "frame"), duration(now() - rendering_start)));
        return exit_code::done;
    }
    console.error(fmt::format("stopped in frame {}; {}", frames[done],
                              done == 0 ? "no frame is done"
                                        : fmt::format("{} of {} frames are done, {} to {}", done,
                                                      frames.size(), frames[0], frames[done - 1])),
                  fmt::format("go on with --frames {}..{}", frames[done], frames.back()) +
                      (request.frames->step > 1 ? fmt::format(":{}", request.frames->step) : ""));
    return stopped_by();
}

} // namespace

int render_command(const Arguments& arguments, Console& console) {
    const RenderRequest request = read_render_request(arguments);
    watch_signals();
    console.status("reading " + request.scene);
    Renderer renderer(arguments, request, console);
    return request.frames ? render_frames(arguments, request, renderer, console)
                          : render_still(request, renderer, console);
}

} // namespace glint::cli
