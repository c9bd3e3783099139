// glint render: a picture, or the frames of an animation.
#include "../common/interrupt.h"
#include "backend.h"
#include "commands.h"
#include "frames.h"
#include "json_output.h"
#include "outputs.h"
#include "progress.h"
#include "render_request.h"
#include "scene_input.h"
#include "text.h"

#include "glint/limits.h"

#include <fmt/format.h>

#include <algorithm>
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
        for (std::size_t i = 0; const std::string& name : term_names(scene.render_settings().integrator))
            options.layers.push_back({name, std::move(picture.terms[i++])});
    options.metadata = picture_settings(scene);
    if (request.render.show != Aov::final)
        options.metadata.emplace_back("glint.show", aov_name(request.render.show));
    if (const auto& crop = request.render.crop) {
        options.x = crop->x;
        options.y = crop->y;
        options.full_width = scene.render_settings().width;
        options.full_height = scene.render_settings().height;
        options.metadata.emplace_back(
            "glint.crop", fmt::format("{},{},{},{}", crop->x, crop->y, crop->width, crop->height));
    }
    if (picture.stats.clamped_light > 0)
        options.metadata.emplace_back("glint.clamped", fmt::format("{:.2g}", clamped_share(picture.stats)));
    // The last bits depend on the rounding of the graphics card.
    if (!record.device.empty()) options.metadata.emplace_back("glint.device", record.device);
    options.metadata.emplace_back("glint.hash", record.hash);
    return options;
}

/// "4 spp" or "1..16 spp".
std::string samples_text(const SampleCounts& samples) {
    return samples.adaptive() ? fmt::format("{}..{} spp", samples.all, samples.differing)
                              : fmt::format("{} spp", samples.all);
}

/// "4 spp", or "1..16 spp, 2.7 on average".
std::string samples_text(const Scene& scene, const Picture& picture) {
    const SampleCounts samples = sample_counts(scene.render_settings());
    if (!samples.adaptive()) return samples_text(samples);
    return fmt::format("{}, {:.1f} on average", samples_text(samples), samples_per_pixel(picture));
}

/// "scene.png: 640×480, 4 spp, 871,306 triangles, 1.23 s, 3.41 Mrays/s, hash …"
std::string closing_line(const RenderRecord& record, const Scene& scene, const Picture& picture) {
    const SceneStats stats = scene.stats();
    const std::string size =
        stats.triangles > 0 ? counted(stats.triangles, "triangle") : counted(stats.objects, "object");
    const std::string partial =
        picture.complete ? "" : fmt::format("stopped early with {:.0f} % done, ", record.fraction * 100);
    const std::string device = record.device.empty() ? "" : "on " + record.device + ", ";
    const std::string clamped =
        picture.stats.clamped_light > 0
            ? fmt::format("{:.2g} % of the light clamped, ", 100 * clamped_share(picture.stats))
            : "";
    return fmt::format("{}: {}{}×{}, {}, {}, {}{}{}, {}, hash {}", shown_name(record.output), partial,
                       picture.image.width, picture.image.height, samples_text(scene, picture), size, clamped,
                       device, duration(picture.stats.wall_seconds),
                       ray_rate(picture.stats.rays(), picture.stats.wall_seconds), record.hash);
}

void print_details(Console& console, const Scene& scene, const RenderRecord& record,
                   const RenderStats& stats) {
    const SceneStats sizes = scene.stats();
    const std::string quality = sizes.tree_quality.empty() ? "" : sizes.tree_quality + " ";
    console.detail(fmt::format("read in {}, {}tree of {} with depth {} built in {}, {} held",
                               duration(record.load_seconds), quality, counted(sizes.tree_nodes, "node"),
                               sizes.tree_depth, duration(record.build_seconds),
                               bytes_text(static_cast<double>(sizes.bytes))));
    console.detail(fmt::format("rays: {} primary, {} reflected, {} refracted, {} shadow; {}",
                               with_commas(stats.primary_rays), with_commas(stats.reflected_rays),
                               with_commas(stats.refracted_rays), with_commas(stats.shadow_rays),
                               counted(static_cast<std::uint64_t>(stats.threads), "thread")));
    if (stats.left_out_rays > 0)
        console.detail(fmt::format("left out: {} below min_weight, less than {:.2g} of the light",
                                   counted(stats.left_out_rays, "ray"), left_out_share(stats, scene)));
}

/// What --dry-run prints: what would be rendered, and the memory that it takes.
std::string needs_text(const RenderRequest& request, const SceneDescription& scene, std::size_t pictures) {
    const auto row = [](const char* label, double bytes) {
        return fmt::format("  {:<9}{}\n", label, bytes_text(bytes));
    };
    const MemoryNeeds needs = memory_needs(request, scene);
    std::string text = printable(shown_name(request.output));
    if (request.frames) text += fmt::format(": {}, each", counted(pictures, "frame"));
    const auto& crop = request.render.crop;
    text += fmt::format(": {}×{}, {}\n", crop ? crop->width : scene.render.width,
                        crop ? crop->height : scene.render.height, samples_text(sample_counts(scene.render)));
    text += row("scene", needs.scene) + row("picture", needs.picture) + row("writing", needs.writing);
    return text + fmt::format("  {:<9}{} of {} that are left\n", "memory", bytes_text(needs.total()),
                              bytes_text(available_memory()));
}

/// --progress.
ProgressStyle style_of(const Arguments& arguments) {
    return progress_style(arguments.text("progress").value_or("auto"));
}

/// Renders pictures of one scene, one after the other.
class Renderer {
  public:
    Renderer(const Arguments& arguments, const RenderRequest& request, Console& console)
        : arguments_(arguments), request_(request), console_(console), style_(style_of(arguments)),
          backend_(arguments, console) {}

    /// Reads the scene and reports its notes and warnings.
    LoadedScene read() {
        const double loading_start = now();
        LoadedScene loaded = read_scene(request_.scene, request_.load);
        load_seconds_ = now() - loading_start;
        apply_flags(arguments_, loaded.description);
        require_possible(loaded.description);
        report(loaded, console_);
        return loaded;
    }

    /// Throws Error(usage) where --crop leaves the picture, and Error(resource) where there is no memory for
    /// it, or for more than the pictures before took.
    void require_possible(const SceneDescription& scene) {
        require_crop_inside(scene.render, request_.render.crop);
        const MemoryNeeds needs = memory_needs(request_, scene);
        if (needs.total() <= granted_) return;
        require_memory(needs.total(),
                       fmt::format("rendering (scene {}, picture {}, writing {})", bytes_text(needs.scene),
                                   bytes_text(needs.picture), bytes_text(needs.writing)),
                       "render in parts with --crop, or less with --size");
        granted_ = needs.total();
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
        // What --keep-partial keeps may take long to encode, but must not wait for a reader.
        if (cancel_flag() && !waits_for_reader(record.output) &&
            !waits_for_reader(request_.stats.value_or("")))
            take_time();
        record.hash = picture_hash(picture.image);
        if (picture.complete && request_.render.show == Aov::final) warn_if_black(scene, picture.image);
        // PNG shows AOVs as colours; the other formats hold their values.
        if (output_format(record.output) == PictureFormat::png)
            picture.image = visible(picture.image, request_.render.show, scene);
        const double writing_start = now();
        const PictureOptions options = picture_options(request_, scene, picture, record);
        write_output({"-o", record.output}, [&] { write_picture(record.output, picture.image, options); });
        record.write_seconds = now() - writing_start;
        if (request_.stats) stats_.push_back(stats_json(record, scene, picture));
        print_details(console_, scene, record, picture.stats);
        // Explicitly asked for: -q does not hide it.
        if (style_ == ProgressStyle::json)
            console_.always(picture_event_json(record, picture));
        else
            console_.line(closing_line(record, scene, picture));
        return picture.complete;
    }

    /// Writes --stats: an object, or with --frames a list of objects.
    void write_stats() const {
        if (!request_.stats || (stats_.empty() && !request_.frames)) return;
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

    /// Light that is there but reaches nothing, or is far too weak.
    void warn_if_black(const Scene& scene, const Image& image) {
        constexpr float just_seen = 1.0f / 255;
        const float brightest = std::ranges::max(image.pixels);
        if (brightest >= just_seen || scene.description().lights.empty()) return;
        const Diagnostic black{
            Severity::warning,
            {},
            fmt::format("the picture is all but black: its brightest value is {:.2g}", brightest),
            "intensity counts at distance 1 and falls with its square; glint explain --pixel X,Y shows "
            "what reaches a pixel",
            {}};
        if (warned_.insert(to_string(black)).second) console_.warning(black);
    }

    Picture render_with_progress(const Scene& scene, RenderRecord& record, const std::string& task) {
        stop_gently();
        ProgressMeter meter(console_, style_, task);
        RenderOptions options = request_.render;
        options.progress = [&](const Progress& progress) { meter.update(progress); };
        options.cancel = &cancel_flag();
        RenderedPicture rendered = backend_.render(scene, options);
        meter.finish();
        record.device = rendered.device;
        record.fraction = rendered.picture.complete ? 1 : meter.fraction();
        return std::move(rendered.picture);
    }

    const Arguments& arguments_;
    const RenderRequest& request_;
    Console& console_;
    const ProgressStyle style_;
    Backend backend_;
    std::optional<Scene> last_; ///< the next picture may share its trees
    double load_seconds_ = 0;
    double granted_ = 0; ///< bytes of memory
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
    if (request.dry_run) {
        print_data(needs_text(request, loaded.description, 1));
        return exit_code::done;
    }
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
    if (request.dry_run) {
        print_data(needs_text(request, loaded.description, frames.size()));
        return exit_code::done;
    }

    const double rendering_start = now();
    std::size_t done = 0;
    for (const int frame : frames) {
        if (cancel_flag()) break; // while the last frame was written
        SceneDescription description = scene_at(loaded, frame);
        apply_flags(arguments, description);
        renderer.require_possible(description);
        RenderRecord record = make_record(request);
        record.output = frame_name(request.output, frame);
        record.frame = frame;
        const std::string task = fmt::format("frame {} ({} of {})", frame, done + 1, frames.size());
        if (!renderer.picture(description, record, task)) break;
        ++done;
    }
    renderer.write_stats();
    if (done == frames.size()) {
        // For JSON the last picture's line says it.
        if (style_of(arguments) != ProgressStyle::json)
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
    console.status("reading " + request.scene);
    Renderer renderer(arguments, request, console);
    return request.frames ? render_frames(arguments, request, renderer, console)
                          : render_still(request, renderer, console);
}

} // namespace glint::cli
