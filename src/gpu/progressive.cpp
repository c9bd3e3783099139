// The passes of render/progressive.cpp on the device, and pictures of what they have come to.

#include "glint/gpu.h"
#include "gpu/clock.h"
#include "gpu/picture.h"
#include "gpu/studio.h"
#include "gpu/tile_work.h"
#include "render/aspect.h"

#include <algorithm>
#include <epoxy/gl.h>
#include <stdexcept>

namespace glint {
namespace {

/// One way over the picture: the centres of every step-th pixel from (x, y) on, or `count` samples more of
/// each pixel.
struct Pass {
    int step = 1;
    int x = 0;
    int y = 0;
    int known = 0; ///< every so-many-th pixel is known after it; 0: as before
    int first = 0; ///< samples before
    int count = 0; ///< 0: centres
};

/// Between the pixels that are known, those at the middle of rows, of columns and of squares are looked at
/// one after the other: each is a grid of its own.
std::vector<Pass> passes_of(const RenderSettings& settings, int coarsest) {
    std::vector<Pass> passes{{coarsest, 0, 0, coarsest, 0, 0}};
    for (int step = coarsest; step > 1; step /= 2) {
        const int half = step / 2;
        passes.push_back({step, half, 0, 0, 0, 0});
        passes.push_back({step, 0, half, 0, 0, 0});
        passes.push_back({step, half, half, half, 0, 0});
    }
    if (settings.spp == 1) return passes;
    for (int done = 0; done < settings.spp;) {
        const int count = std::min(std::max(done, 1), settings.spp - done);
        passes.push_back({1, 0, 0, 1, done, count});
        done += count;
    }
    return passes;
}

} // namespace

struct GpuProgressive::State {
    explicit State(int device) : studio(device, {}) {}
    explicit State(GpuCurrentContext current) : studio(current) {}
    ~State() {
        const GpuEnding ending(studio.context());
        work.reset();
        scratch.reset();
        films.clear();
        known.reset();
        pool.reset();
        block.reset();
    }

    GpuStudio studio;
    std::size_t terms = 1; ///< that are told apart
    std::optional<TileWork> work{std::in_place, studio, terms};
    std::unique_ptr<GpuBuffer> scratch;            ///< the film of centres
    std::vector<std::unique_ptr<GpuBuffer>> films; ///< of samples, by tile of the picture
    std::unique_ptr<GpuBuffer> block;
    std::optional<GpuPicturePool> pool{std::in_place, studio.context()};
    std::shared_ptr<GpuPicture> known; ///< centres, at the places that were looked at

    ProgressiveOptions options;
    RenderSettings settings;
    bool first_hit = false; ///< numbers of first hits are shown
    std::vector<Pass> passes;
    std::size_t pass = 0;             ///< the one under way; passes.size(): finished
    std::vector<Rect> tiles;          ///< of the pass, in places of it
    std::size_t tile = 0;             ///< the next, or the one under way
    std::vector<Rect> picture_tiles;  ///< of the picture
    std::vector<std::uint32_t> means; ///< samples of each of them
    Refinement reached;
    double done_work = 0; ///< of the passes before, in samples
    std::uint64_t rays_before = 0;

    const Pass& now() const { return passes[pass]; }
    bool is_finished() const { return pass == passes.size(); }
    bool cancelled() const {
        return options.cancel != nullptr && options.cancel->load(std::memory_order_relaxed);
    }

    void start(const Scene& scene, const ProgressiveOptions& wanted);
    void tell_apart(std::size_t count);
    void give_up();
    void begin_pass();
    void end_pass();
    void begin_tile();
    void end_tile();
    void step();
    const GpuBuffer& film(std::size_t of_tile);
    GpuSettings settings_of(const Rect& rect, const Pass& p) const;
    double work_of(const Pass& p) const;
    void measure();
    std::uint64_t rays() const;
    void show(const GpuSettings& how, const GpuBuffer& film, const GpuPicture& shown, const Rect& rect);
    std::shared_ptr<const GpuPicture> picture();
};

void GpuProgressive::State::start(const Scene& scene, const ProgressiveOptions& wanted) {
    if (wanted.coarsest < 1 || wanted.coarsest > most_coarse ||
        (wanted.coarsest & (wanted.coarsest - 1)) != 0)
        throw std::invalid_argument("the coarsest step is no power of two from 1 to 64");
    give_up();
    studio.prepare(scene);
    options = wanted;
    settings = scene.render_settings();
    first_hit = !is_light(options.show);
    if (first_hit) settings.spp = 1;
    tell_apart(term_of(options.show) ? term_count : 1);
    picture_tiles = tiles_of(studio.context(), studio.settings(), terms, settings.width, settings.height);
    means.assign(picture_tiles.size(), 0);
    if (known == nullptr || known->width() != settings.width || known->height() != settings.height) {
        known.reset();
        known = pool->take(settings.width, settings.height);
    }
    done_work = 0;
    rays_before = rays();
    passes = passes_of(settings, options.coarsest);
    begin_pass();
}

/// Work and films have places for so many terms.
void GpuProgressive::State::tell_apart(std::size_t count) {
    if (terms == count) return;
    terms = count;
    work.emplace(studio, terms);
    scratch.reset();
    films.clear();
}

/// Leaves nothing to go on with, and nothing to show.
void GpuProgressive::State::give_up() {
    reached = {};
    passes.clear();
    pass = 0;
    work->give_up();
}

void GpuProgressive::State::begin_pass() {
    tile = 0;
    tiles.clear();
    if (is_finished()) return;
    const int across = (settings.width - now().x + now().step - 1) / now().step;
    const int down = (settings.height - now().y + now().step - 1) / now().step;
    if (across > 0 && down > 0) tiles = tiles_of(studio.context(), studio.settings(), terms, across, down);
}

void GpuProgressive::State::end_pass() {
    if (now().known > 0) reached.step = now().known;
    reached.samples = now().first + now().count;
    done_work += work_of(now());
    ++pass;
    reached.finished = is_finished();
    begin_pass();
}

/// The film of a tile, large enough and in a state to go on from.
const GpuBuffer& GpuProgressive::State::film(std::size_t of_tile) {
    const std::size_t bytes = 4 * film_fields(terms) * slots_of(tiles[of_tile]);
    if (now().count > 0 && films.size() <= of_tile) films.resize(of_tile + 1);
    std::unique_ptr<GpuBuffer>& held = now().count > 0 ? films[of_tile] : scratch;
    if (held == nullptr || held->bytes() < bytes) {
        held.reset();
        held = std::make_unique<GpuBuffer>(studio.context(), "the pixels", nullptr, bytes);
    }
    return *held;
}

GpuSettings GpuProgressive::State::settings_of(const Rect& rect, const Pass& p) const {
    GpuSettings s = studio.settings();
    s.tile_x = static_cast<std::uint32_t>(p.x + rect.x * p.step);
    s.tile_y = static_cast<std::uint32_t>(p.y + rect.y * p.step);
    s.tile_width = static_cast<std::uint32_t>(rect.width);
    s.samples = static_cast<std::uint32_t>(p.count > 0 ? settings.spp : 1);
    s.end_x = static_cast<std::uint32_t>(settings.width);
    s.end_y = static_cast<std::uint32_t>(settings.height);
    s.end_sample = static_cast<std::uint32_t>(p.count > 0 ? p.first + p.count : 1);
    s.pixel_step = static_cast<std::uint32_t>(p.step);
    s.first_sample = static_cast<std::uint32_t>(p.first);
    if (first_hit) {
        // Nothing bounces.
        s.aov = static_cast<std::uint32_t>(options.show);
        s.max_depth = 0;
    }
    return s;
}

void GpuProgressive::State::begin_tile() {
    const GpuBuffer& to = film(tile);
    if (now().first == 0) to.clear(4 * film_fields(terms) * slots_of(tiles[tile]));
    work->begin(settings_of(tiles[tile], now()), slots_of(tiles[tile]));
}

void GpuProgressive::State::end_tile() {
    const Rect& rect = tiles[tile];
    if (now().count > 0) {
        means[tile] = static_cast<std::uint32_t>(now().first + now().count);
    } else {
        GpuSettings how = settings_of(rect, now());
        how.show_mode = show_centres;
        show(how, *scratch, *known, rect);
        glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    }
    ++tile;
}

/// One dispatch, and what follows from it.
void GpuProgressive::State::step() {
    if (tile < tiles.size()) {
        if (!work->is_under_way()) begin_tile();
        work->step(studio.program(terms > 1, first_hit), film(tile));
        if (!work->is_under_way()) end_tile();
    }
    if (tile == tiles.size()) end_pass();
}

/// In samples.
double GpuProgressive::State::work_of(const Pass& p) const {
    return double(settings.width) / p.step * (double(settings.height) / p.step) * std::max(p.count, 1);
}

std::uint64_t GpuProgressive::State::rays() const {
    std::uint64_t sum = 0;
    for (const std::uint64_t of_kind : work->rays()) sum += of_kind;
    return sum;
}

void GpuProgressive::State::measure() {
    reached.rays = rays() - rays_before;
    double all = 0;
    for (const Pass& p : passes) all += work_of(p);
    double done = done_work;
    if (!is_finished() && !tiles.empty()) {
        double tiles_done = static_cast<double>(tile);
        if (work->is_under_way()) tiles_done += 1 - double(work->unfinished()) / work->slots();
        done += work_of(now()) * tiles_done / static_cast<double>(tiles.size());
    }
    reached.fraction = reached.finished ? 1 : done / all;
}

/// Runs show.glsl over a tile.
void GpuProgressive::State::show(const GpuSettings& how, const GpuBuffer& from, const GpuPicture& shown,
                                 const Rect& rect) {
    if (block == nullptr)
        block = std::make_unique<GpuBuffer>(studio.context(), "the settings", nullptr, sizeof(GpuSettings));
    const auto term = term_of(options.show);
    GpuSettings s = how;
    s.film_terms = static_cast<std::uint32_t>(terms);
    s.shown_term = term ? static_cast<std::uint32_t>(*term) : 0u;
    s.slot_count = slots_of(rect);
    s.smooth_steps = first_hit ? 0u : 1u;
    block->write(0, &s, sizeof s);
    studio.show_program().use();
    block->bind_uniform(0);
    work->buffer().bind_storage(6);
    from.bind_storage(7);
    glBindImageTexture(0, known->texture(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    glBindImageTexture(1, shown.texture(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    glDispatchCompute((s.slot_count + Pace::group_size - 1) / Pace::group_size, 1, 1);
}

std::shared_ptr<const GpuPicture> GpuProgressive::State::picture() {
    if (reached.step == 0) return nullptr;
    const std::shared_ptr<GpuPicture> shown = pool->take(settings.width, settings.height);
    const bool has_samples = !is_finished() ? now().count > 0 : settings.spp > 1;
    for (std::size_t i = 0; i < picture_tiles.size(); ++i) {
        const bool started = has_samples && i == tile && work->is_under_way();
        GpuSettings how = settings_of(picture_tiles[i], Pass{});
        how.show_mode = show_spread;
        how.known_step = static_cast<std::uint32_t>(reached.step);
        if (started) {
            how.show_mode = show_started;
            how.first_sample = static_cast<std::uint32_t>(now().first);
        } else if (has_samples && means[i] > 0) {
            how.show_mode = show_means;
            how.known_samples = means[i];
        }
        show(how, has_samples && i < films.size() && films[i] ? *films[i] : *scratch, *shown,
             picture_tiles[i]);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
    // Another context may look at it at once.
    glFinish();
    studio.context().check("showing the picture");
    return shown;
}

GpuProgressive::GpuProgressive(int device) : state_(std::make_unique<State>(device)) {}
GpuProgressive::GpuProgressive(GpuCurrentContext context) : state_(std::make_unique<State>(context)) {}
GpuProgressive::~GpuProgressive() = default;

const GpuDevice& GpuProgressive::device() const { return state_->studio.context().device(); }

void GpuProgressive::start(const Scene& scene, const ProgressiveOptions& options) {
    const GpuScope scope(state_->studio.context());
    state_->start(scene, options);
}

bool GpuProgressive::advance(double seconds) {
    State& s = *state_;
    if (s.passes.empty()) return false;
    const GpuScope scope(s.studio.context());
    const double begin = wall_seconds();
    try {
        while (!s.is_finished() && !s.cancelled()) {
            s.step();
            if (s.pass > 0 && wall_seconds() - begin >= seconds) break;
        }
    } catch (...) {
        s.give_up();
        throw;
    }
    s.measure();
    s.reached.seconds += wall_seconds() - begin;
    return !s.is_finished();
}

const Refinement& GpuProgressive::reached() const { return state_->reached; }

std::shared_ptr<const GpuPicture> GpuProgressive::picture() const {
    const GpuScope scope(state_->studio.context());
    return state_->picture();
}

Image GpuProgressive::image() const {
    const GpuScope scope(state_->studio.context());
    const std::shared_ptr<const GpuPicture> shown = state_->picture();
    return shown ? shown->read() : Image();
}

int GpuProgressive::layings() const { return state_->studio.layings(); }

} // namespace glint
