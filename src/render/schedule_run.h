#pragma once
// Runs a schedule over threads: tiles to workers, camera samples to estimators, what they measure to a film.

#include "glint/progressive.h"
#include "parallel/task_pool.h"
#include "render/camera_sampler.h"
#include "render/estimators/estimator.h"
#include "render/film.h"
#include "render/schedule.h"

#include <atomic>
#include <functional>
#include <limits>
#include <mutex>
#include <vector>

namespace glint {

inline constexpr double no_deadline = std::numeric_limits<double>::infinity();

struct RunOptions {
    Aov show = Aov::final;
    KernelChoice kernel;
    const CancelFlag* cancel = nullptr;
    std::function<void(const Progress&)> progress; ///< called from the threads, one at a time
};

/// A schedule under way. Refers to scene, film and pool. The picture depends neither on threads nor on how
/// often the run was interrupted or cancelled.
class ScheduleRun {
  public:
    ScheduleRun(const SceneData& scene, Schedule schedule, Film& film, TaskPool& pool, RunOptions options);

    /// Goes on until wall_seconds() is `deadline`, but to the end of the first pass in any case, and over one
    /// tile a thread at least. Once the flag is set it returns within milliseconds; the tiles that were whole
    /// are kept.
    void run(double deadline);

    bool is_finished() const { return cursor_.is_finished(); }
    bool is_cancelled() const { return glint::is_cancelled(options_.cancel); }
    const Refinement& reached() const { return reached_; }
    /// Rays and threads, so far.
    void add_stats(RenderStats& stats) const;

  private:
    struct Worker {
        explicit Worker(Estimator e) : estimator(std::move(e)) {}

        Estimator estimator;
        std::vector<CameraSample> samples = std::vector<CameraSample>(batch_samples);
        std::vector<Channels> channels = std::vector<Channels>(batch_samples);
        FilmTile values;
        std::uint64_t tiles = 0;
        std::uint64_t rays_reported = 0;
        bool may_stop = false; ///< it has done a tile since run() was called
    };
    /// One visit of a tile.
    struct Visit {
        Pass pass;
        std::size_t tile = 0;
        Rect rect;              ///< of the tile, in the grid of the pass
        bool continues = false; ///< adds to the sums of earlier visits
        bool keeps_states = false;
        int block_width = 1; ///< pixels of the grid that are measured together
        int block_height = 1;
    };

    const Pass& pass() const { return cursor_.pass(); }
    void begin_pass();
    void end_pass();
    std::size_t task_count(const Pass& pass) const;
    std::size_t tile_of(std::size_t task) const;
    void run_pass(double deadline);
    bool run_tile(std::size_t tile, Worker& worker);
    Visit visit_of(const Pass& pass, std::size_t tile) const;
    bool measure(const Visit& visit, Worker& worker) const;
    void collect_block(const Visit& visit, int x, int y, FilmTile& values) const;
    void measure_centres(std::size_t from, Worker& worker) const;
    template <class T>
    void measure_samples(const Visit& visit, std::size_t from, Worker& worker) const;
    template <class T>
    void measure_pixel(const Visit& visit, Worker& worker) const;
    void estimate_samples(std::size_t from, int first, int count, Worker& worker) const;
    template <class T>
    const T& measured(const Channels& channels) const;
    template <class T>
    void put(const T& value, std::uint32_t covered, std::size_t pixel, FilmTile& values) const;
    template <class T>
    struct PixelSamples;
    template <class T>
    void put_sums(const PixelSamples<T>& samples, const Visit& visit, std::size_t pixel,
                  FilmTile& values) const;
    void report(Worker& worker);
    void measure_progress();

    Schedule schedule_;
    Film& film_;
    TaskPool& pool_;
    RunOptions options_;
    CameraSampler sampler_;
    std::vector<Pixel> block_; ///< the first batch_samples points of the Morton curve
    std::vector<Worker> workers_;
    ScheduleCursor cursor_;
    TileGrid grid_;                    ///< of the pass
    std::vector<std::uint8_t> done_;   ///< by task of the pass: a tile of the shard
    std::atomic<std::size_t> left_{0}; ///< tasks of the pass that are not done
    double start_ = wall_seconds();
    double seconds_ = 0; ///< in run()
    std::mutex mutex_;
    Progress progress_;
    Refinement reached_;
};

} // namespace glint
