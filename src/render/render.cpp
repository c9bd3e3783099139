// Pictures by the CPU: how it measures the tiles of a schedule, and at the end render().

#include "render/cpu_executor.h"

#include "glint/error.h"
#include "glint/render.h"
#include "render/schedule_run.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <ctime>

namespace glint::rendering {
namespace {

std::size_t index_in(const Rect& tile, const Pixel& pixel) {
    return static_cast<std::size_t>(pixel.y - tile.y) * static_cast<std::size_t>(tile.width) +
           static_cast<std::size_t>(pixel.x - tile.x);
}

} // namespace

/// The samples of a pixel so far.
template <class T>
struct CpuExecutor::PixelSamples {
    imaging::PixelSum<T> sum;
    imaging::CoveredCounts covered;

    PixelSamples(const Film& film, const Visit& visit, const Pixel& pixel) {
        if (!visit.continues) return;
        const auto state = film.state<T>(visit.tile, index_in(visit.rect, pixel));
        sum = imaging::PixelSum<T>(state.sum, static_cast<std::uint32_t>(visit.pass.first));
        covered = state.covered;
    }
    void add(const T& value, const CameraSample& sample, const Channels& channels) {
        sum.add(value, sample.weight);
        covered.add(channels.covered, sample.weight);
    }
};

CpuExecutor::CpuExecutor(const scene::SceneData& scene, Film& film, parallel::TaskPool& pool,
                         const KernelChoice& kernel, const CancelFlag* cancel, const Shard& shard)
    : film_(film), pool_(pool), cancel_(cancel), shard_(shard), sampler_(scene.description) {
    for (std::uint32_t i = 0; i < batch_samples; ++i) block_.push_back({morton_x(i), morton_y(i)});
    for (int i = 0; i < pool.threads(); ++i)
        workers_.emplace_back(make_estimator(scene, film.layout().show, cancel, kernel));
}

RayCounts CpuExecutor::rays(int worker) const {
    return ray_counts(workers_[static_cast<std::size_t>(worker)].estimator);
}

// ── Passes and tiles ──

/// A preview would overwrite samples.
bool CpuExecutor::shows_preview() const { return pass_.is_preview() && !film_.has_samples(); }

std::vector<std::uint32_t> CpuExecutor::begin_pass(const Pass& pass) {
    pass_ = pass;
    if (pass.is_preview() && !shows_preview()) return {};
    if (pass.adaptive) begin_adaptive();
    film_.begin_pass(pass);
    const FilmLayout& layout = film_.layout();
    grid_ = TileGrid((layout.area.width + pass.step - 1) / pass.step,
                     (layout.area.height + pass.step - 1) / pass.step, layout.tile_size);
    const std::size_t tiles = grid_.count();
    const auto index = static_cast<std::size_t>(shard_.index);
    const auto shards = static_cast<std::size_t>(shard_.count);
    return std::vector<std::uint32_t>(tiles > index ? (tiles - index + shards - 1) / shards : 0, 1);
}

void CpuExecutor::begin_adaptive() {
    if (!film_.is_refined() && !film_.has_all_samples())
        throw Error(ErrorKind::usage, "adaptive samples need the whole picture",
                    "join the films of its parts before");
    film_.refine(pool_);
}

void CpuExecutor::end_pass() {
    if (shows_preview()) film_.show_preview(pass_, pool_);
}

std::uint32_t CpuExecutor::step(std::size_t task, int worker) {
    const std::size_t tile =
        static_cast<std::size_t>(shard_.index) + task * static_cast<std::size_t>(shard_.count);
    return measure_tile(tile, workers_[static_cast<std::size_t>(worker)]) ? 1 : 0;
}

/// False if it was cancelled.
bool CpuExecutor::measure_tile(std::size_t tile, Worker& worker) {
    if (pass_.is_preview()) {
        if (!measure(visit_of(pass_, tile), worker)) return false;
        film_.commit_preview(pass_, worker.values);
        return true;
    }
    for (;;) {
        const Pass part = film_.missing(tile, pass_);
        if (part.count == 0) return true;
        if (!measure(visit_of(part, tile), worker)) return false;
        film_.commit(tile, part, worker.values);
    }
}

// ── Visits ──

CpuExecutor::Visit CpuExecutor::visit_of(const Pass& pass, std::size_t tile) const {
    const FilmLayout& layout = film_.layout();
    Visit visit{pass, tile, grid_.tile(tile)};
    visit.centres = pass.is_preview() || film_.samples() == 1;
    visit.sums_terms = pass.is_preview() ? layout.terms : film_.sums_terms();
    if (!pass.is_preview()) {
        visit.continues = film_.continues(tile, pass);
        visit.keeps_states = film_.keeps_states(tile, pass);
    }
    // As many pixels as fit a batch, in a square or two.
    const auto pixels = static_cast<unsigned>(std::max(1, batch_samples / std::max(1, pass.count)));
    visit.pixels_at_once = pixels;
    const int levels = static_cast<int>(std::bit_width(pixels)) - 1;
    visit.block_width = 1 << (levels + 1) / 2;
    visit.block_height = 1 << levels / 2;
    return visit;
}

/// False if it was cancelled.
bool CpuExecutor::measure(const Visit& visit, Worker& worker) const {
    FilmTile& values = worker.values;
    collect_pixels(visit, values);
    // Those of pixels that are not measured are never read, but saved.
    if (visit.keeps_states) values.states.assign(film_.state_bytes(visit.tile), std::byte{});
    for (std::size_t from = 0; from < values.pixels.size(); from += visit.pixels_at_once) {
        const std::size_t end = std::min(from + visit.pixels_at_once, values.pixels.size());
        visit.sums_terms ? measure_samples<Terms>(visit, from, end, worker)
                         : measure_samples<vec3>(visit, from, end, worker);
        if (is_cancelled()) return false;
    }
    return true;
}

/// Sets the pixels that the visit measures, block by block: rays of neighbours go the same way.
void CpuExecutor::collect_pixels(const Visit& visit, FilmTile& values) const {
    const Rect& r = visit.rect;
    const auto count = static_cast<std::size_t>(visit.block_width * visit.block_height);
    values.pixels.clear();
    for (int y = r.y; y < r.y + r.height; y += visit.block_height)
        for (int x = r.x; x < r.x + r.width; x += visit.block_width)
            for (std::size_t i = 0; i < count; ++i) {
                const Pixel pixel{x + block_[i].x, y + block_[i].y};
                if (takes(visit, pixel))
                    values.pixels.push_back({pixel.x * visit.pass.step, pixel.y * visit.pass.step});
            }
    values.resize_to_pixels(film_.layout());
}

/// True if a pixel of the grid lies in the tile and the pass is to measure it.
bool CpuExecutor::takes(const Visit& visit, const Pixel& pixel) const {
    const Rect& r = visit.rect;
    if (pixel.x >= r.x + r.width || pixel.y >= r.y + r.height) return false;
    if (visit.pass.refines && pixel.x % 2 == 0 && pixel.y % 2 == 0) return false;
    return !visit.pass.adaptive || film_.takes(pixel);
}

/// Samples first … first + count − 1 of the pixels from number `from` to before `end`.
void CpuExecutor::estimate_samples(const Visit& visit, std::size_t from, std::size_t end, int first,
                                   int count, Worker& worker) const {
    std::size_t s = 0;
    for (std::size_t i = from; i < end; ++i) {
        const Pixel& of_area = worker.values.pixels[i];
        const Pixel pixel{film_.layout().area.x + of_area.x, film_.layout().area.y + of_area.y};
        for (int k = first; k < first + count; ++k, ++s)
            worker.samples[s] = visit.centres ? sampler_.centre(pixel) : sampler_.sample(pixel, k);
    }
    estimate(worker.estimator, {worker.samples.data(), s}, {worker.channels.data(), s},
             visit.sums_terms || film_.layout().term.has_value());
    // With coverage, pixels show what is hit alone.
    for (std::size_t i = 0; film_.layout().coverage && i < s; ++i)
        if (!worker.channels[i].covered) worker.channels[i] = {};
}

template <class T>
void CpuExecutor::measure_samples(const Visit& visit, std::size_t from, std::size_t end,
                                  Worker& worker) const {
    const int count = visit.pass.is_preview() ? 1 : visit.pass.count;
    if (count > batch_samples) return measure_pixel<T>(visit, from, worker);
    estimate_samples(visit, from, end, visit.pass.first, count, worker);
    const std::size_t pixels = end - from;
    if (visit.centres) {
        for (std::size_t i = 0; i < pixels; ++i)
            put(measured<T>(worker.channels[i]), worker.channels[i].covered ? 1.0f : 0.0f, from + i,
                worker.values);
        return;
    }
    for (std::size_t i = 0, s = 0; i < pixels; ++i) {
        PixelSamples<T> samples(film_, visit, worker.values.pixels[from + i]);
        for (int k = 0; k < count; ++k, ++s)
            samples.add(measured<T>(worker.channels[s]), worker.samples[s], worker.channels[s]);
        put_sums(samples, visit, from + i, worker.values);
    }
}

/// A pixel that alone has more samples than a batch.
template <class T>
void CpuExecutor::measure_pixel(const Visit& visit, std::size_t pixel, Worker& worker) const {
    PixelSamples<T> samples(film_, visit, worker.values.pixels[pixel]);
    const int end = visit.pass.first + visit.pass.count;
    for (int first = visit.pass.first; first < end && !is_cancelled(); first += batch_samples) {
        const int count = std::min(batch_samples, end - first);
        estimate_samples(visit, pixel, pixel + 1, first, count, worker);
        for (std::size_t s = 0; s < static_cast<std::size_t>(count); ++s)
            samples.add(measured<T>(worker.channels[s]), worker.samples[s], worker.channels[s]);
    }
    put_sums(samples, visit, pixel, worker.values);
}

template <class T>
const T& CpuExecutor::measured(const Channels& channels) const {
    if constexpr (std::is_same_v<T, Terms>) {
        return channels.terms;
    } else {
        const std::optional<int>& term = film_.layout().term;
        return term ? channels.terms.value[static_cast<std::size_t>(*term)] : channels.radiance;
    }
}

template <class T>
void CpuExecutor::put_sums(const PixelSamples<T>& samples, const Visit& visit, std::size_t pixel,
                           FilmTile& values) const {
    put(samples.sum.value(), samples.sum.coverage(samples.covered), pixel, values);
    if (!visit.keeps_states) return;
    const PixelState<T> state{samples.sum.part(), samples.covered};
    const std::size_t index = index_in(visit.rect, values.pixels[pixel]);
    std::memcpy(&values.states[index * sizeof state], &state, sizeof state);
}

template <class T>
void CpuExecutor::put(const T& value, float coverage, std::size_t pixel, FilmTile& values) const {
    const FilmLayout& layout = film_.layout();
    if constexpr (std::is_same_v<T, Terms>) {
        values.shown[pixel] = value.sum(layout.term);
        if (layout.terms) values.terms[pixel] = value;
    } else {
        values.shown[pixel] = value;
    }
    if (layout.coverage) values.coverage[pixel] = coverage;
}

} // namespace glint::rendering

namespace glint {
namespace {

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

} // namespace

double left_out_share(const RenderStats& stats, const Scene& scene) {
    if (stats.primary_rays == 0) return 0;
    return static_cast<double>(stats.left_out_rays) / static_cast<double>(stats.primary_rays) *
           scene.description().whitted.min_weight;
}

double clamped_share(const RenderStats& stats) {
    return stats.light > 0 ? stats.clamped_light / stats.light : 0;
}

Picture render(const Scene& scene, const RenderOptions& options) {
    const double wall = rendering::wall_seconds();
    const double cpu = cpu_seconds();
    rendering::Film film(rendering::film_layout(scene.render_settings(), options));
    parallel::TaskPool pool(options.threads);
    rendering::CpuExecutor executor(scene.data(), film, pool, options.kernel, options.cancel);
    Picture picture = rendering::render_film(
        executor, film, rendering::picture_passes(film.layout().samples, options), options, wall);
    picture.stats.cpu_seconds = cpu_seconds() - cpu;
    return picture;
}

} // namespace glint
