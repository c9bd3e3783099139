// Progressive pictures on the device, and what they have come to as textures.

#include "glint/gpu.h"
#include "gpu/device_run.h"
#include "gpu/device_state.h"
#include "gpu/picture.h"
#include "render/aov.h"

#include <epoxy/gl.h>

namespace glint {
struct GpuProgressive::State {
    explicit State(int device) : device_state(device, {}) {}
    explicit State(GpuCurrentContext current) : device_state(current) {}
    ~State() {
        const GpuEnding ending(device_state.context());
        run.reset();
        known.reset();
        pool.reset();
        block.reset();
    }

    GpuDeviceState device_state;
    std::optional<DeviceRun> run{std::in_place, device_state};
    std::unique_ptr<GpuBuffer> block;
    std::optional<GpuPicturePool> pool{std::in_place, device_state.context()};
    std::shared_ptr<GpuPicture> known; ///< centres, at the pixels that were looked at
    ProgressiveOptions options;
    Refinement reached;

    void start(const Scene& scene, const ProgressiveOptions& wanted);
    bool advance(double seconds);
    void give_up();
    void show(const GpuSettings& how, const GpuBuffer& film, const GpuPicture& shown, const Rect& rect);
    void show_centres_of(const GpuTile& tile, const GpuBuffer& film);
    std::shared_ptr<const GpuPicture> picture();
};

void GpuProgressive::State::start(const Scene& scene, const ProgressiveOptions& wanted) {
    RenderOptions render;
    render.show = wanted.show;
    const FilmLayout layout = film_layout(scene.render_settings(), render);
    std::vector<Pass> passes = refining_passes(wanted.coarsest, layout.samples);
    give_up();
    device_state.prepare(scene);
    options = wanted;
    const Rect& area = layout.area;
    if (known == nullptr || known->width() != area.width || known->height() != area.height) {
        known.reset();
        known = pool->take(area.width, area.height);
    }
    run->start(layout, options.show, std::move(passes));
}

/// Leaves nothing to go on with, and nothing to show.
void GpuProgressive::State::give_up() {
    reached = {};
    run->give_up();
}

bool GpuProgressive::State::advance(double seconds) {
    if (run->cursor().is_finished()) return false;
    const double begin = wall_seconds();
    const double seconds_before = reached.seconds;
    const auto done = [this](const GpuTile& tile, const GpuBuffer& film) {
        if (run->pass().is_preview()) show_centres_of(tile, film);
    };
    try {
        while (!run->cursor().is_finished() && !is_cancelled(options.cancel)) {
            run->step(done);
            if (!run->cursor().is_first() && wall_seconds() - begin >= seconds) break;
        }
    } catch (...) {
        give_up();
        throw;
    }
    reached = run->reached();
    reached.seconds = seconds_before + (wall_seconds() - begin);
    return !reached.finished;
}

void GpuProgressive::State::show_centres_of(const GpuTile& tile, const GpuBuffer& film) {
    GpuSettings how = run->settings_of(tile, run->pass());
    how.show_mode = show_centres;
    show(how, film, *known, tile.rect);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

/// Runs show.glsl over a tile.
void GpuProgressive::State::show(const GpuSettings& how, const GpuBuffer& from, const GpuPicture& shown,
                                 const Rect& rect) {
    if (block == nullptr)
        block =
            std::make_unique<GpuBuffer>(device_state.context(), "the settings", nullptr, sizeof(GpuSettings));
    const auto term = term_of(options.show);
    GpuSettings s = how;
    s.film_terms = static_cast<std::uint32_t>(run->terms());
    s.shown_term = term ? static_cast<std::uint32_t>(*term) : 0u;
    s.slot_count = slots_of(rect);
    s.smooth_steps = run->first_hits() ? 0u : 1u;
    block->write(0, &s, sizeof s);
    device_state.show_program().use();
    block->bind_uniform(0);
    run->work().buffer().bind_storage(6);
    from.bind_storage(7);
    glBindImageTexture(0, known->texture(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    glBindImageTexture(1, shown.texture(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    glDispatchCompute((s.slot_count + DispatchBudget::group_size - 1) / DispatchBudget::group_size, 1, 1);
}

std::shared_ptr<const GpuPicture> GpuProgressive::State::picture() {
    if (reached.step == 0) return nullptr;
    const Rect& area = run->layout().area;
    const std::shared_ptr<GpuPicture> shown = pool->take(area.width, area.height);
    const std::vector<GpuTile> tiles = run->picture_tiles();
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        GpuSettings how = run->settings_of(tiles[i], Pass{});
        how.show_mode = show_spread;
        how.known_step = static_cast<std::uint32_t>(reached.step);
        const bool is_started = run->is_under_way(i);
        if (is_started) {
            how.show_mode = show_started;
            how.first_sample = static_cast<std::uint32_t>(run->pass().first);
        } else if (run->samples_of(i) > 0) {
            how.show_mode = show_means;
            how.known_samples = run->samples_of(i);
        }
        const bool has_samples = is_started || run->samples_of(i) > 0;
        show(how, has_samples ? *run->film_of(i) : *run->scratch(), *shown, tiles[i].rect);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
    // Another context may look at it at once.
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

const Refinement& GpuProgressive::reached() const { return state_->reached; }

std::shared_ptr<const GpuPicture> GpuProgressive::picture() const {
    const GpuScope scope(state_->device_state.context());
    return state_->picture();
}

Image GpuProgressive::image() const {
    const GpuScope scope(state_->device_state.context());
    const std::shared_ptr<const GpuPicture> shown = state_->picture();
    return shown ? shown->read() : Image();
}

int GpuProgressive::upload_count() const { return state_->device_state.upload_count(); }

} // namespace glint
