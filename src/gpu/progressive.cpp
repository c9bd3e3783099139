// Progressive pictures on the device, as textures.

#include "glint/gpu.h"
#include "gpu/device_executor.h"
#include "gpu/device_state.h"
#include "gpu/picture.h"
#include "render/aov.h"
#include "render/contrast.h"
#include "render/schedule_run.h"

#include <epoxy/gl.h>

namespace glint {

using gpu::GpuBuffer;
using gpu::GpuScope;
using gpu::GpuTile;

struct GpuProgressive::State {
    explicit State(int device) : device_state(device, {}) {}
    explicit State(GpuCurrentContext current) : device_state(current) {}
    ~State() {
        const GpuScope scope(device_state.context(), std::nothrow);
        executor.reset();
        known.reset();
        pool.reset();
    }

    gpu::GpuDeviceState device_state;
    std::optional<gpu::DeviceExecutor> executor{std::in_place, device_state};
    std::optional<rendering::ScheduleRun<gpu::DeviceExecutor>> run;
    std::optional<gpu::GpuPicturePool> pool{std::in_place, device_state.context()};
    /// Centres of pixels, where they were measured; in adaptive passes, the picture before them, with alpha 0
    /// where it is finished.
    std::shared_ptr<GpuPicture> known;
    std::vector<std::uint8_t> refined; ///< by pixel: differs from a neighbour in that picture

    void start(const Scene& scene, const ProgressiveOptions& options);
    bool advance(double seconds);
    const Refinement& reached() const;
    void show(const GpuSettings& how, const GpuBuffer& film, const GpuPicture& shown, const Rect& rect);
    void show_centres_of(const GpuTile& tile, const GpuBuffer& film);
    void begin_adaptive();
    std::shared_ptr<const GpuPicture> picture(int known_step);
};

void GpuProgressive::State::start(const Scene& scene, const ProgressiveOptions& options) {
    RenderOptions render;
    render.show = options.show;
    const rendering::FilmLayout layout = rendering::film_layout(scene.render_settings(), render);
    std::vector<rendering::Pass> passes = rendering::refining_passes(options.coarsest, layout.samples);
    run.reset();
    device_state.prepare(scene);
    const Rect& area = layout.area;
    if (known == nullptr || known->width() != area.width || known->height() != area.height) {
        known.reset();
        known = pool->take(area.width, area.height);
    }
    executor->start(
        layout,
        [this](const GpuTile& tile, const GpuBuffer& film) {
            if (executor->pass().is_preview()) show_centres_of(tile, film);
        },
        [this](const rendering::Pass& pass) {
            const SampleCounts& samples = executor->layout().samples;
            if (samples.adaptive() && !pass.adaptive && pass.first + pass.count == samples.all)
                begin_adaptive();
        });
    executor->measure_only([this](const rendering::Pixel& pixel) {
        return refined[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(known->width()) +
                       static_cast<std::size_t>(pixel.x)] != 0;
    });
    run.emplace(*executor, std::move(passes), options.cancel);
}

bool GpuProgressive::State::advance(double seconds) {
    if (!run) return false;
    try {
        run->run(rendering::wall_seconds() + seconds);
    } catch (...) {
        run.reset();
        throw;
    }
    return !run->is_finished();
}

const Refinement& GpuProgressive::State::reached() const {
    static const Refinement nothing;
    return run ? run->reached() : nothing;
}

void GpuProgressive::State::show_centres_of(const GpuTile& tile, const GpuBuffer& film) {
    GpuSettings how = executor->settings_of(tile, executor->pass());
    how.show_mode = show_centres;
    show(how, film, *known, tile.rect);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

/// Runs show.glsl over a tile.
void GpuProgressive::State::show(const GpuSettings& how, const GpuBuffer& from, const GpuPicture& shown,
                                 const Rect& rect) {
    const rendering::FilmLayout& layout = executor->layout();
    GpuSettings s = how;
    s.film_terms = static_cast<std::uint32_t>(executor->terms());
    s.shown_term = layout.term ? static_cast<std::uint32_t>(*layout.term) : 0u;
    s.slot_count = gpu::slots_of(rect);
    s.smooth_steps = rendering::is_light(layout.show) ? 1u : 0u;
    executor->work().buffer().bind_storage(6);
    from.bind_storage(7);
    glBindImageTexture(0, known->texture(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    glBindImageTexture(1, shown.texture(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    device_state.show_program().dispatch(s, s.slot_count);
}

/// Marks the pixels that get more samples.
void GpuProgressive::State::begin_adaptive() {
    const Image image = picture(1)->read();
    const Rect whole{0, 0, image.width, image.height};
    refined = rendering::pixels_that_differ(image, {}, whole, executor->pool());
    std::vector<float> marked;
    for (std::size_t i = 0; i < refined.size(); ++i) {
        marked.insert(marked.end(), &image.pixels[3 * i], &image.pixels[3 * i] + 3);
        marked.push_back(refined[i] != 0 ? 1.0f : 0.0f);
    }
    glBindTexture(GL_TEXTURE_2D, known->texture());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.width, image.height, GL_RGBA, GL_FLOAT, marked.data());
    glBindTexture(GL_TEXTURE_2D, 0);
    device_state.context().check("marking pixels");
}

/// The picture so far. Of pixels without samples the centres of every `known_step`-th are known; 0: none.
std::shared_ptr<const GpuPicture> GpuProgressive::State::picture(int known_step) {
    if (known_step == 0) return nullptr;
    const Rect& area = executor->layout().area;
    const std::shared_ptr<GpuPicture> shown = pool->take(area.width, area.height);
    const std::vector<GpuTile> tiles = executor->picture_tiles();
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        GpuSettings how = executor->settings_of(tiles[i], rendering::Pass{});
        how.show_mode = executor->is_under_way(i) ? show_started : show_means;
        how.known_step = static_cast<std::uint32_t>(known_step);
        how.known_samples = executor->samples_in_film(i);
        show(how, executor->film_of(i), *shown, tiles[i].rect);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
    // Another context may read it at once.
    glFinish();
    device_state.context().check("showing the picture");
    return shown;
}

GpuProgressive::GpuProgressive(int device) : state_(std::make_unique<State>(device)) {}
GpuProgressive::GpuProgressive(GpuCurrentContext context) : state_(std::make_unique<State>(context)) {}
GpuProgressive::~GpuProgressive() = default;

const GpuDevice& GpuProgressive::device() const { return state_->device_state.context().device(); }

void GpuProgressive::start(const Scene& scene, const ProgressiveOptions& options) {
    const GpuScope scope(state_->device_state.context());
    state_->start(scene, options);
}

bool GpuProgressive::advance(double seconds) {
    const GpuScope scope(state_->device_state.context());
    return state_->advance(seconds);
}

const Refinement& GpuProgressive::reached() const { return state_->reached(); }

std::shared_ptr<const GpuPicture> GpuProgressive::picture() const {
    const GpuScope scope(state_->device_state.context());
    return state_->picture(reached().step);
}

Image GpuProgressive::image() const {
    const GpuScope scope(state_->device_state.context());
    const std::shared_ptr<const GpuPicture> shown = state_->picture(reached().step);
    return shown ? shown->read() : Image();
}

int GpuProgressive::upload_count() const { return state_->device_state.upload_count(); }

} // namespace glint
