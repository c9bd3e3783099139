#include "glint/progressive.h"

#include "imaging/film.h"
#include "parallel/task_pool.h"
#include "render/aspect.h"
#include "render/camera_sampler.h"
#include "render/upsample.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>

namespace glint {
namespace {

using Clock = std::chrono::steady_clock;
using Part = PixelSum<Terms>::Part;

/// Side of a tile, in places of a pass.
constexpr int tile_side = 16;

/// One way over the picture: every step-th pixel by its centre, or `count` samples more of each pixel.
struct Pass {
    int step = 1;
    bool is_first = false; ///< no coarser pass has been there before
    int first = 0;         ///< samples before, none or a power of two
    int count = 0;         ///< 0: centres
};

/// The passes of a picture. Samples double, so that what is kept of a pixel is one sum, and the sums are
/// those of PixelSum. What is left over comes last.
std::vector<Pass> passes_of(const RenderSettings& settings, const ProgressiveOptions& options) {
    std::vector<Pass> passes;
    for (int step = options.coarsest; step >= 1; step /= 2)
        passes.push_back({step, step == options.coarsest, 0, 0});
    if (settings.spp == 1 || !is_light(options.show)) return passes;
    for (int done = 0; done < settings.spp;) {
        const int count = std::min(std::max(done, 1), settings.spp - done);
        passes.push_back({1, false, done, count});
        done += count;
    }
    return passes;
}

/// What a thread works with.
struct Worker {
    Probe probe;
    std::vector<Pixel> pixels;
    std::vector<CameraSample> samples = std::vector<CameraSample>(batch_samples);
    std::vector<Channels> channels = std::vector<Channels>(batch_samples);
    std::vector<vec3> values = std::vector<vec3>(batch_samples); ///< by pixel of the tile
    std::vector<Part> parts = std::vector<Part>(batch_samples);
    std::uint64_t rays_told = 0;
    bool may_stop = false; ///< it has done something since work began
};

} // namespace

struct Progressive::State {
    explicit State(int threads) : pool(threads) {}

    TaskPool pool;
    std::vector<Worker> workers;
    ProgressiveOptions options;
    RenderSettings settings;
    std::unique_ptr<const CameraSampler> sampler;
    std::vector<Pass> passes;
    std::size_t pass = 0;               ///< the one under way; passes.size(): finished
    std::vector<std::uint8_t> done;     ///< by tile of the pass
    std::atomic<std::uint64_t> left{0}; ///< tiles of the pass that are not done
    std::vector<Part> parts;            ///< by pixel
    Image known;                        ///< centres, at the places that were looked at
    Image shown;
    Refinement reached;
    double done_work = 0; ///< of the passes before, in samples

    const Pass& now() const { return passes[pass]; }
    bool cancelled() const {
        return options.cancel != nullptr && options.cancel->load(std::memory_order_relaxed);
    }
    int places_across() const { return (settings.width + now().step - 1) / now().step; }
    int places_down() const { return (settings.height + now().step - 1) / now().step; }
    int columns() const { return (places_across() + tile_side - 1) / tile_side; }
    int rows() const { return (places_down() + tile_side - 1) / tile_side; }
    std::size_t index(const Pixel& p) const {
        return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(settings.width) +
               static_cast<std::size_t>(p.x);
    }

    void start(const Scene& scene, const ProgressiveOptions& wanted);
    void begin_pass();
    void end_pass();
    void fit(Image& image) const;
    double work_of(const Pass& p) const;
    void measure_fraction();
    void work(Clock::time_point deadline);
    void render_tile(std::size_t tile, Worker& worker) const;
    void collect_pixels(std::size_t tile, Worker& worker) const;
    void look_at_centres(Worker& worker) const;
    void add_samples(Worker& worker) const;
    void add_many_samples(std::size_t pixel, Worker& worker) const;
    void trace(std::size_t from, std::size_t to, int first, int end, Worker& worker) const;
    PixelSum<Terms> begun(const Pixel& pixel) const;
    void keep(const PixelSum<Terms>& sum, std::size_t pixel, Worker& worker) const;
    void commit(const Worker& worker);
    void count_rays();
};

void Progressive::State::start(const Scene& scene, const ProgressiveOptions& wanted) {
    if (wanted.coarsest < 1 || wanted.coarsest > most_coarse ||
        (wanted.coarsest & (wanted.coarsest - 1)) != 0)
        throw std::invalid_argument("the coarsest step is no power of two from 1 to 64");
    options = wanted;
    settings = scene.render_settings();
    sampler = std::make_unique<const CameraSampler>(scene.description());
    workers.clear();
    for (int i = 0; i < pool.threads(); ++i)
        workers.push_back({Probe(scene, options.show, options.cancel, options.kernel), {}});
    passes = passes_of(settings, options);
    fit(known);
    reached = {};
    done_work = 0;
    pass = 0;
    begin_pass();
}

void Progressive::State::begin_pass() {
    if (pass == passes.size()) return;
    const auto tiles = static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows());
    done.assign(tiles, 0);
    left = tiles;
    if (now().step == 1) fit(shown);
    if (now().count > 0)
        parts.resize(static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height));
}

void Progressive::State::end_pass() {
    reached.step = now().step;
    reached.samples = now().first + now().count;
    if (now().step > 1) {
        fit(shown);
        upsample(known, now().step, is_light(options.show), shown, pool);
    }
    done_work += work_of(now());
    ++pass;
    reached.finished = pass == passes.size();
    begin_pass();
}

/// A picture of the size that is wanted, black where it is another yet.
void Progressive::State::fit(Image& image) const {
    if (image.width != settings.width || image.height != settings.height)
        image = Image(settings.width, settings.height);
}

/// In samples.
double Progressive::State::work_of(const Pass& p) const {
    const double places_of_all = double(settings.width) / p.step * (double(settings.height) / p.step);
    return p.count > 0 ? places_of_all * p.count : places_of_all * (p.is_first ? 1 : 0.75);
}

void Progressive::State::measure_fraction() {
    double all = 0;
    for (const Pass& p : passes) all += work_of(p);
    double work = done_work;
    if (pass < passes.size()) work += work_of(now()) * (1 - double(left.load()) / double(done.size()));
    reached.fraction = reached.finished ? 1 : work / all;
}

/// Hands out the tiles of the pass until the time is over, but one to each thread in any case.
void Progressive::State::work(Clock::time_point deadline) {
    for (Worker& worker : workers) worker.may_stop = false;
    const bool must_end = pass == 0;
    pool.run(done.size(), [&](std::size_t tile, int number) {
        Worker& worker = workers[static_cast<std::size_t>(number)];
        const bool is_late = !must_end && worker.may_stop && Clock::now() >= deadline;
        if (done[tile] != 0 || cancelled() || is_late) return;
        render_tile(tile, worker);
        if (cancelled()) return;
        commit(worker);
        worker.may_stop = true;
        done[tile] = 1;
        left.fetch_sub(1, std::memory_order_relaxed);
    });
    count_rays();
}

void Progressive::State::render_tile(std::size_t tile, Worker& worker) const {
    collect_pixels(tile, worker);
    if (now().count == 0)
        look_at_centres(worker);
    else
        add_samples(worker);
}

/// The pixels of a tile that its pass is to look at, neighbours together.
void Progressive::State::collect_pixels(std::size_t tile, Worker& worker) const {
    const int x = static_cast<int>(tile % static_cast<std::size_t>(columns())) * tile_side;
    const int y = static_cast<int>(tile / static_cast<std::size_t>(columns())) * tile_side;
    worker.pixels.clear();
    for (std::uint32_t i = 0; i < tile_side * tile_side; ++i) {
        const int across = x + morton_x(i);
        const int down = y + morton_y(i);
        if (across >= places_across() || down >= places_down()) continue;
        const bool was_seen = now().count == 0 && !now().is_first && across % 2 == 0 && down % 2 == 0;
        if (!was_seen) worker.pixels.push_back({across * now().step, down * now().step});
    }
}

void Progressive::State::look_at_centres(Worker& worker) const {
    const std::size_t count = worker.pixels.size();
    for (std::size_t i = 0; i < count; ++i) worker.samples[i] = sampler->centre(worker.pixels[i]);
    worker.probe.measure({worker.samples.data(), count}, {worker.channels.data(), count},
                         {worker.values.data(), count});
}

/// As many pixels at a time as a batch holds.
void Progressive::State::add_samples(Worker& worker) const {
    const auto at_once = static_cast<std::size_t>(std::max(1, batch_samples / now().count));
    for (std::size_t from = 0; from < worker.pixels.size() && !cancelled(); from += at_once) {
        const std::size_t to = std::min(from + at_once, worker.pixels.size());
        if (now().count > batch_samples) {
            add_many_samples(from, worker);
            continue;
        }
        trace(from, to, now().first, now().first + now().count, worker);
        for (std::size_t i = from, s = 0; i < to; ++i) {
            PixelSum<Terms> sum = begun(worker.pixels[i]);
            for (int k = 0; k < now().count; ++k, ++s)
                sum.add(worker.channels[s].terms, worker.samples[s].weight);
            keep(sum, i, worker);
        }
    }
}

/// One pixel, in several batches.
void Progressive::State::add_many_samples(std::size_t pixel, Worker& worker) const {
    PixelSum<Terms> sum = begun(worker.pixels[pixel]);
    const int last = now().first + now().count;
    for (int first = now().first; first < last && !cancelled(); first += batch_samples) {
        const int end = std::min(first + batch_samples, last);
        trace(pixel, pixel + 1, first, end, worker);
        for (std::size_t s = 0; s < static_cast<std::size_t>(end - first); ++s)
            sum.add(worker.channels[s].terms, worker.samples[s].weight);
    }
    keep(sum, pixel, worker);
}

/// Samples first … end − 1 of some of the worker's pixels.
void Progressive::State::trace(std::size_t from, std::size_t to, int first, int end, Worker& worker) const {
    std::size_t count = 0;
    for (std::size_t i = from; i < to; ++i)
        for (int k = first; k < end; ++k, ++count)
            worker.samples[count] = sampler->sample(worker.pixels[i], k);
    worker.probe.estimate({worker.samples.data(), count}, {worker.channels.data(), count});
}

PixelSum<Terms> Progressive::State::begun(const Pixel& pixel) const {
    if (now().first == 0) return {};
    return {parts[index(pixel)], static_cast<std::uint32_t>(now().first)};
}

void Progressive::State::keep(const PixelSum<Terms>& sum, std::size_t pixel, Worker& worker) const {
    worker.values[pixel] = worker.probe.part_of(sum.value());
    worker.parts[pixel] = sum.part();
}

/// Whole tiles only: what was cancelled half-way leaves no trace.
void Progressive::State::commit(const Worker& worker) {
    const bool goes_on = now().count > 0 && pass + 1 < passes.size();
    Image& values = now().step > 1 ? known : shown;
    for (std::size_t i = 0; i < worker.pixels.size(); ++i) {
        const Pixel& pixel = worker.pixels[i];
        for (int channel = 0; channel < 3; ++channel)
            values.at(pixel.x, pixel.y)[channel] = worker.values[i][channel];
        if (goes_on) parts[index(pixel)] = worker.parts[i];
    }
}

void Progressive::State::count_rays() {
    for (Worker& worker : workers) {
        const std::uint64_t rays = worker.probe.counts().total();
        reached.rays += rays - worker.rays_told;
        worker.rays_told = rays;
    }
}

Progressive::Progressive(int threads) : state_(std::make_unique<State>(threads)) {}
Progressive::~Progressive() = default;

void Progressive::start(const Scene& scene, const ProgressiveOptions& options) {
    state_->start(scene, options);
}

bool Progressive::advance(double seconds) {
    State& s = *state_;
    const Clock::time_point begin = Clock::now();
    const auto deadline =
        begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    while (s.pass < s.passes.size() && !s.cancelled()) {
        s.work(deadline);
        if (s.left == 0) s.end_pass();
        if (Clock::now() >= deadline) break;
    }
    s.measure_fraction();
    s.reached.seconds += std::chrono::duration<double>(Clock::now() - begin).count();
    return s.pass < s.passes.size();
}

const Image& Progressive::image() const { return state_->shown; }
const Refinement& Progressive::reached() const { return state_->reached; }
int Progressive::threads() const { return state_->pool.threads(); }

} // namespace glint
