#include "glint/render.h"

#include "imaging/film.h"
#include "parallel/large_pages.h"
#include "render/aspect.h"
#include "render/camera_sampler.h"
#include "render/whitted.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <mutex>

namespace glint {
namespace {

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A black image, in large pages.
Image black(int width, int height) {
    const std::size_t values = 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    Image image;
    image.width = width;
    image.height = height;
    reserve_large(image.pixels, values);
    image.pixels.resize(values);
    return image;
}

/// One rendering: tiles over threads, each tile's pixels written by one thread alone.
class Job {
  public:
    Job(const FrozenScene& scene, const RenderOptions& options)
        : scene_(scene), options_(options), settings_(scene.description.render), sampler_(scene.description),
          area_(picture_area(settings_, options.crop)) {
        tile_ = std::max(1, options.tile_size);
        while (4 * block_ * block_ * settings_.spp <= batch_samples) block_ *= 2;
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(block_ * block_); ++i)
            block_pixels_.push_back({morton_x(i), morton_y(i)});
        columns_ = (area_.width + tile_ - 1) / tile_;
        rows_ = (area_.height + tile_ - 1) / tile_;
        picture_.image = black(area_.width, area_.height);
        if (options.terms)
            for (Image& term : picture_.terms) term = black(area_.width, area_.height);
        if (options.coverage)
            picture_.coverage.resize(static_cast<std::size_t>(area_.width) *
                                     static_cast<std::size_t>(area_.height));
    }

    Picture run() {
        const double wall = wall_seconds();
        const double cpu = cpu_seconds();
        TaskPool pool(options_.threads);
        start_ = wall;
        for (int i = 0; i < pool.threads(); ++i)
            workers_.push_back(Worker{WhittedTracer(scene_, options_.cancel, options_.kernel), {}});
        pool.run(tile_count(), [this](std::size_t tile, int worker) {
            render_tile(tile, workers_[static_cast<std::size_t>(worker)]);
        });
        collect_stats();
        picture_.stats.wall_seconds = wall_seconds() - wall;
        picture_.stats.cpu_seconds = cpu_seconds() - cpu;
        return std::move(picture_);
    }

  private:
    struct Worker {
        WhittedTracer tracer;
        std::vector<Pixel> pixels;
        std::vector<CameraSample> samples = std::vector<CameraSample>(batch_samples);
        std::vector<Channels> channels = std::vector<Channels>(batch_samples);
        std::size_t count = 0; ///< of samples in the batch
        std::uint64_t tiles = 0;
        std::uint64_t rays_told = 0;
    };

    std::size_t tile_count() const {
        return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    }

    bool cancelled() const {
        return options_.cancel != nullptr && options_.cancel->load(std::memory_order_relaxed);
    }

    void render_tile(std::size_t tile, Worker& worker) {
        if (cancelled()) return;
        Rect r;
        r.x = static_cast<int>(tile % static_cast<std::size_t>(columns_)) * tile_;
        r.y = static_cast<int>(tile / static_cast<std::size_t>(columns_)) * tile_;
        r.width = std::min(tile_, area_.width - r.x);
        r.height = std::min(tile_, area_.height - r.y);
        for (int y = r.y; y < r.y + r.height; y += block_)
            for (int x = r.x; x < r.x + r.width; x += block_) {
                render_block(x, y, r, worker);
                if (cancelled()) return clear(r);
            }
        ++worker.tiles;
        report(worker);
    }

    /// The block of pixels at x, y, as far as it lies in the tile: all their samples together.
    void render_block(int x, int y, const Rect& tile, Worker& worker) {
        worker.pixels.clear();
        for (const Pixel& place : block_pixels_) {
            const Pixel pixel{x + place.x, y + place.y};
            if (pixel.x < tile.x + tile.width && pixel.y < tile.y + tile.height)
                worker.pixels.push_back(pixel);
        }
        const int count = std::min(settings_.spp, batch_samples);
        worker.count = 0;
        for (const Pixel& pixel : worker.pixels) add_samples(pixel, 0, count, worker);
        estimate(worker, settings_.spp > 1 || options_.terms || options_.coverage);
        for (std::size_t i = 0; i < worker.pixels.size(); ++i) {
            if (settings_.spp == 1)
                store_only(worker.pixels[i], worker.channels[i]);
            else
                store_sum(worker.pixels[i], i * static_cast<std::size_t>(count), worker);
        }
    }

    /// A pixel that has one sample.
    void store_only(const Pixel& pixel, const Channels& sample) {
        if (options_.terms || options_.coverage)
            return store(pixel, sample.terms, sample.covered ? 1.0f : 0.0f);
        write(picture_.image.at(pixel.x, pixel.y), sample.radiance);
    }

    /// One pixel's mean, from its samples in the batch; those that a batch cannot hold are traced now.
    void store_sum(const Pixel& pixel, std::size_t first, Worker& worker) {
        PixelSum<Terms> sum;
        int covered = 0;
        for (int done = 0; done < settings_.spp;) {
            const int count = std::min(settings_.spp - done, batch_samples);
            if (done > 0) {
                worker.count = 0;
                add_samples(pixel, done, count, worker);
                estimate(worker, true);
                first = 0;
            }
            for (std::size_t s = first; s < first + static_cast<std::size_t>(count); ++s) {
                sum.add(worker.channels[s].terms, worker.samples[s].weight);
                covered += worker.channels[s].covered ? 1 : 0;
            }
            done += count;
        }
        store(pixel, sum.value(), static_cast<float>(covered) / static_cast<float>(settings_.spp));
    }

    /// Samples first … first + count − 1 of a pixel, for the next batch.
    void add_samples(const Pixel& pixel, int first, int count, Worker& worker) const {
        for (int i = first; i < first + count; ++i)
            worker.samples[worker.count++] = sampler_.sample({area_.x + pixel.x, area_.y + pixel.y}, i);
    }

    static void estimate(Worker& worker, bool terms) {
        worker.tracer.estimate({worker.samples.data(), worker.count}, {worker.channels.data(), worker.count},
                               terms);
    }

    void store(const Pixel& pixel, const Terms& terms, float coverage) {
        const auto [x, y] = pixel;
        write(picture_.image.at(x, y), terms.sum());
        if (options_.terms)
            for (std::size_t i = 0; i < picture_.terms.size(); ++i)
                write(picture_.terms[i].at(x, y), terms.value[i]);
        if (options_.coverage) picture_.coverage[index(x, y)] = coverage;
    }

    static void write(float* pixel, const vec3& value) {
        pixel[0] = value.x;
        pixel[1] = value.y;
        pixel[2] = value.z;
    }

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(area_.width) +
               static_cast<std::size_t>(x);
    }

    void clear(const Rect& r) {
        for (int y = r.y; y < r.y + r.height; ++y)
            for (int x = r.x; x < r.x + r.width; ++x) store({x, y}, Terms{}, 0.0f);
    }

    void report(Worker& worker) {
        const std::uint64_t rays = worker.tracer.counts().total();
        const std::lock_guard lock(mutex_);
        progress_.tiles_done += 1;
        progress_.tiles = tile_count();
        progress_.rays += rays - worker.rays_told;
        worker.rays_told = rays;
        progress_.seconds = wall_seconds() - start_;
        if (options_.progress) options_.progress(progress_);
    }

    void collect_stats() {
        RenderStats& stats = picture_.stats;
        for (const Worker& worker : workers_) {
            const RayCounts& c = worker.tracer.counts();
            stats.primary_rays += c.primary;
            stats.reflected_rays += c.reflected;
            stats.refracted_rays += c.refracted;
            stats.shadow_rays += c.shadow;
            if (worker.tiles > 0) ++stats.threads;
        }
        picture_.complete = progress_.tiles_done == tile_count();
    }

    const FrozenScene& scene_;
    const RenderOptions& options_;
    const RenderSettings settings_;
    const CameraSampler sampler_;
    const Rect area_;
    int tile_ = 16;
    int block_ = 1;                   ///< side of the squares of pixels that are traced together
    std::vector<Pixel> block_pixels_; ///< of the first such square, in the order of their samples
    int columns_ = 0;
    int rows_ = 0;
    double start_ = 0;
    Picture picture_;
    std::vector<Worker> workers_;
    std::mutex mutex_;
    Progress progress_;
};

std::string size_text(const RenderSettings& r) {
    return std::to_string(r.width) + "x" + std::to_string(r.height);
}

} // namespace

Picture render(const Scene& scene, const RenderOptions& options) {
    if (options.show != Aspect::final) return render_aspect(scene, options);
    return Job(scene.frozen(), options).run();
}

std::vector<std::pair<std::string, std::string>> picture_settings(const Scene& scene) {
    static constexpr const char* filters[] = {"box", "tent", "gaussian", "mitchell"};
    const RenderSettings& r = scene.frozen().description.render;
    const WhittedSettings& w = scene.frozen().description.whitted;
    return {{"glint.version", version()},
            {"glint.size", size_text(r)},
            {"glint.spp", std::to_string(r.spp)},
            {"glint.seed", std::to_string(r.seed)},
            {"glint.integrator", r.integrator},
            {"glint.filter", filters[static_cast<std::size_t>(r.filter)]},
            {"glint.max_depth", std::to_string(w.max_depth)},
            {"glint.shadows", w.shadows == Shadows::opaque ? "opaque" : "transmissive"},
            {"glint.clamp", w.clamp ? "true" : "false"},
            {"glint.energy", w.energy == Energy::balanced ? "balanced" : "report"},
            {"glint.highlight_model", w.highlight_model == HighlightModel::phong ? "phong" : "blinn"}};
}

const char* version() { return GLINT_VERSION; }

} // namespace glint
