#include "render/schedule_run.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace glint {
namespace {

std::size_t place_in(const Rect& tile, const Pixel& pixel) {
    return static_cast<std::size_t>(pixel.y - tile.y) * static_cast<std::size_t>(tile.width) +
           static_cast<std::size_t>(pixel.x - tile.x);
}

} // namespace

/// The samples of a pixel so far.
template <class T>
struct ScheduleRun::PixelSamples {
    PixelSum<T> sum;
    std::uint32_t covered = 0;

    PixelSamples(const Film& film, const Visit& visit, const Pixel& pixel) {
        if (!visit.continues) return;
        const auto state = film.state<T>(visit.tile, place_in(visit.rect, pixel));
        sum = PixelSum<T>(state.sum, static_cast<std::uint32_t>(visit.pass.first));
        covered = state.covered;
    }
    void add(const T& value, const CameraSample& sample, const Channels& channels) {
        sum.add(value, sample.weight);
        covered += channels.covered ? 1 : 0;
    }
};

ScheduleRun::ScheduleRun(const SceneData& scene, Schedule schedule, Film& film, TaskPool& pool,
                         RunOptions options)
    : schedule_(std::move(schedule)), film_(film), pool_(pool), options_(std::move(options)),
      sampler_(scene.description), cursor_(schedule_.passes) {
    for (std::uint32_t i = 0; i < batch_samples; ++i) block_.push_back({morton_x(i), morton_y(i)});
    for (int i = 0; i < pool.threads(); ++i)
        workers_.emplace_back(make_estimator(scene, options_.show, options_.cancel, options_.kernel));
    if (film_.has_samples()) {
        std::erase_if(schedule_.passes, [](const Pass& pass) { return pass.is_preview(); });
        cursor_ = ScheduleCursor(schedule_.passes);
    }
    for (const Pass& pass : schedule_.passes) progress_.tiles += task_count(pass);
    begin_pass();
}

void ScheduleRun::run(double deadline) {
    const double begin = wall_seconds();
    while (!is_finished() && !is_cancelled()) {
        run_pass(deadline);
        if (left_ == 0) end_pass();
        if (wall_seconds() >= deadline) break;
    }
    seconds_ += wall_seconds() - begin;
    measure_progress();
}

void ScheduleRun::add_stats(RenderStats& stats) const {
    for (const Worker& worker : workers_) {
        add_rays(ray_counts(worker.estimator), stats);
        if (worker.tiles > 0) ++stats.threads;
    }
}

// ── Passes and tiles ──

std::size_t ScheduleRun::task_count(const Pass& pass) const {
    const std::size_t tiles = schedule_.grid_of(pass).count();
    const auto index = static_cast<std::size_t>(schedule_.shard.index);
    const auto shards = static_cast<std::size_t>(schedule_.shard.count);
    return tiles > index ? (tiles - index + shards - 1) / shards : 0;
}

std::size_t ScheduleRun::tile_of(std::size_t task) const {
    return static_cast<std::size_t>(schedule_.shard.index) +
           task * static_cast<std::size_t>(schedule_.shard.count);
}

void ScheduleRun::begin_pass() {
    if (is_finished()) return;
    film_.begin_pass(pass());
    grid_ = schedule_.grid_of(pass());
    done_.assign(task_count(pass()), 0);
    left_ = done_.size();
    for (std::size_t task = 0; task < done_.size() && !pass().is_preview(); ++task)
        if (film_.missing(tile_of(task), pass()).count == 0) {
            done_[task] = 1;
            --left_;
            ++progress_.tiles_done;
        }
}

void ScheduleRun::end_pass() {
    if (pass().is_preview()) film_.show_preview(pass().step, is_light(options_.show), pool_);
    cursor_.next();
    begin_pass();
}

void ScheduleRun::run_pass(double deadline) {
    for (Worker& worker : workers_) worker.may_stop = false;
    const bool must_end = cursor_.is_first();
    pool_.run(done_.size(), [&](std::size_t task, int number) {
        Worker& worker = workers_[static_cast<std::size_t>(number)];
        const bool is_late = !must_end && worker.may_stop && wall_seconds() >= deadline;
        if (done_[task] != 0 || is_late || is_cancelled() || !run_tile(tile_of(task), worker)) return;
        worker.may_stop = true;
        done_[task] = 1;
        left_.fetch_sub(1, std::memory_order_relaxed);
        ++worker.tiles;
        if (options_.progress) report(worker);
    });
}

/// Was it not cancelled?
bool ScheduleRun::run_tile(std::size_t tile, Worker& worker) {
    if (pass().is_preview()) {
        if (!measure(visit_of(pass(), tile), worker)) return false;
        film_.commit_preview(pass(), worker.values);
        return true;
    }
    for (;;) {
        const Pass part = film_.missing(tile, pass());
        if (part.count == 0) return true;
        if (!measure(visit_of(part, tile), worker)) return false;
        film_.commit(tile, part, worker.values);
    }
}

void ScheduleRun::report(Worker& worker) {
    const std::uint64_t rays = ray_counts(worker.estimator).total();
    const std::lock_guard lock(mutex_);
    progress_.tiles_done += 1;
    progress_.rays += rays - worker.rays_reported;
    progress_.seconds = wall_seconds() - start_;
    worker.rays_reported = rays;
    options_.progress(progress_);
}

void ScheduleRun::measure_progress() {
    const double tiles = std::max<double>(1, static_cast<double>(done_.size()));
    reached_ = cursor_.reached(1 - static_cast<double>(left_.load()) / tiles);
    reached_.seconds = seconds_;
    for (const Worker& worker : workers_) reached_.rays += ray_counts(worker.estimator).total();
}

// ── Visits ──

ScheduleRun::Visit ScheduleRun::visit_of(const Pass& pass, std::size_t tile) const {
    Visit visit{pass, tile, grid_.tile(tile)};
    if (!pass.is_preview()) {
        visit.continues = film_.continues(tile, pass);
        visit.keeps_states = film_.keeps_states(tile, pass);
    }
    // As many pixels as fit a batch, in a square or two: rays of neighbours go the same way.
    const auto pixels = static_cast<unsigned>(std::max(1, batch_samples / std::max(1, pass.count)));
    const int levels = static_cast<int>(std::bit_width(pixels)) - 1;
    visit.block_width = 1 << (levels + 1) / 2;
    visit.block_height = 1 << levels / 2;
    return visit;
}

/// False if it was cancelled.
bool ScheduleRun::measure(const Visit& visit, Worker& worker) const {
    FilmTile& values = worker.values;
    values.pixels.clear();
    if (visit.keeps_states) values.states.resize(film_.state_bytes(visit.tile));
    const Rect& r = visit.rect;
    for (int y = r.y; y < r.y + r.height; y += visit.block_height)
        for (int x = r.x; x < r.x + r.width; x += visit.block_width) {
            const std::size_t from = values.pixels.size();
            collect_block(visit, x, y, values);
            if (visit.pass.is_preview())
                measure_centres(from, worker);
            else
                with_sum_type(film_.layout(),
                              [&]<class T>(const T&) { measure_samples<T>(visit, from, worker); });
            if (is_cancelled()) return false;
        }
    return true;
}

/// Adds the pixels of a block, as far as they lie in the tile and the pass is to measure them.
void ScheduleRun::collect_block(const Visit& visit, int x, int y, FilmTile& values) const {
    const Rect& r = visit.rect;
    const std::size_t from = values.pixels.size();
    const auto count = static_cast<std::size_t>(visit.block_width * visit.block_height);
    values.pixels.resize(from + count);
    Pixel* next = values.pixels.data() + from;
    for (std::size_t i = 0; i < count; ++i) {
        const Pixel& offset = block_[i];
        const Pixel pixel{x + offset.x, y + offset.y};
        if (pixel.x >= r.x + r.width || pixel.y >= r.y + r.height) continue;
        if (visit.pass.refines && pixel.x % 2 == 0 && pixel.y % 2 == 0) continue;
        *next++ = {pixel.x * visit.pass.step, pixel.y * visit.pass.step};
    }
    values.pixels.resize(static_cast<std::size_t>(next - values.pixels.data()));
    values.resize_to_pixels(film_.layout());
}

void ScheduleRun::measure_centres(std::size_t from, Worker& worker) const {
    const std::size_t count = worker.values.pixels.size() - from;
    for (std::size_t i = 0; i < count; ++i) {
        const Pixel& pixel = worker.values.pixels[from + i];
        worker.samples[i] = sampler_.centre({schedule_.area.x + pixel.x, schedule_.area.y + pixel.y});
    }
    estimate(worker.estimator, {worker.samples.data(), count}, {worker.channels.data(), count},
             film_.layout().term.has_value());
    for (std::size_t i = 0; i < count; ++i)
        worker.values.shown[from + i] = measured<vec3>(worker.channels[i]);
}

/// Samples first … first + count − 1 of the pixels from number `from` on.
void ScheduleRun::estimate_samples(std::size_t from, int first, int count, Worker& worker) const {
    const bool centres = film_.layout().samples == 1;
    std::size_t s = 0;
    for (std::size_t i = from; i < worker.values.pixels.size(); ++i) {
        const Pixel& of_area = worker.values.pixels[i];
        const Pixel pixel{schedule_.area.x + of_area.x, schedule_.area.y + of_area.y};
        for (int k = first; k < first + count; ++k, ++s)
            worker.samples[s] = centres ? sampler_.centre(pixel) : sampler_.sample(pixel, k);
    }
    estimate(worker.estimator, {worker.samples.data(), s}, {worker.channels.data(), s},
             film_.layout().needs_terms());
}

template <class T>
void ScheduleRun::measure_samples(const Visit& visit, std::size_t from, Worker& worker) const {
    const int count = visit.pass.count;
    if (count > batch_samples) return measure_pixel<T>(visit, worker);
    estimate_samples(from, visit.pass.first, count, worker);
    const std::size_t pixels = worker.values.pixels.size() - from;
    if (film_.layout().samples == 1) {
        for (std::size_t i = 0; i < pixels; ++i)
            put(measured<T>(worker.channels[i]), worker.channels[i].covered ? 1 : 0, from + i, worker.values);
        return;
    }
    for (std::size_t i = 0, s = 0; i < pixels; ++i) {
        PixelSamples<T> samples(film_, visit, worker.values.pixels[from + i]);
        for (int k = 0; k < count; ++k, ++s)
            samples.add(measured<T>(worker.channels[s]), worker.samples[s], worker.channels[s]);
        put_sums(samples, visit, from + i, worker.values);
    }
}

/// The last of the worker's pixels, which alone has more samples than a batch.
template <class T>
void ScheduleRun::measure_pixel(const Visit& visit, Worker& worker) const {
    const std::size_t pixel = worker.values.pixels.size() - 1;
    PixelSamples<T> samples(film_, visit, worker.values.pixels[pixel]);
    const int end = visit.pass.first + visit.pass.count;
    for (int first = visit.pass.first; first < end && !is_cancelled(); first += batch_samples) {
        const int count = std::min(batch_samples, end - first);
        estimate_samples(pixel, first, count, worker);
        for (std::size_t s = 0; s < static_cast<std::size_t>(count); ++s)
            samples.add(measured<T>(worker.channels[s]), worker.samples[s], worker.channels[s]);
    }
    put_sums(samples, visit, pixel, worker.values);
}

template <class T>
const T& ScheduleRun::measured(const Channels& channels) const {
    if constexpr (std::is_same_v<T, Terms>) {
        return channels.terms;
    } else {
        const std::optional<Term>& term = film_.layout().term;
        return term ? channels.terms[*term] : channels.radiance;
    }
}

template <class T>
void ScheduleRun::put_sums(const PixelSamples<T>& samples, const Visit& visit, std::size_t pixel,
                           FilmTile& values) const {
    put(samples.sum.value(), samples.covered, pixel, values);
    if (!visit.keeps_states) return;
    const PixelState<T> state{samples.sum.part(), samples.covered};
    const std::size_t place = place_in(visit.rect, values.pixels[pixel]);
    std::memcpy(&values.states[place * sizeof state], &state, sizeof state);
}

template <class T>
void ScheduleRun::put(const T& value, std::uint32_t covered, std::size_t pixel, FilmTile& values) const {
    const FilmLayout& layout = film_.layout();
    if constexpr (std::is_same_v<T, Terms>) {
        values.shown[pixel] = layout.term ? value[*layout.term] : value.sum();
        if (layout.terms) values.terms[pixel] = value;
    } else {
        values.shown[pixel] = value;
    }
    if (layout.coverage) values.covered[pixel] = covered;
}

} // namespace glint
