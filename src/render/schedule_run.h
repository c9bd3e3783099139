#pragma once
// The scheduler of the CPU and of graphics cards: passes and tiles in order, deadline, cancelling, progress.

#include "glint/progressive.h"
#include "parallel/task_pool.h"
#include "render/film.h"
#include "render/schedule.h"

#include <atomic>
#include <concepts>
#include <functional>
#include <limits>
#include <mutex>
#include <numeric>
#include <utility>
#include <vector>

namespace glint::rendering {

inline constexpr double no_deadline = std::numeric_limits<double>::infinity();

/// What measures the tiles of a schedule: CpuExecutor or, on a graphics card, DeviceExecutor. It has units of
/// work of its own. A step on the CPU is a whole tile, or nothing if it was cancelled; on a card it is one
/// dispatch, and the tile goes on in the next.
template <class E>
concept TileExecutor = requires(E& executor, const Pass& pass, std::size_t tile, int worker) {
    /// With a worker for each tile that is measured at a time.
    { executor.pool() } -> std::same_as<parallel::TaskPool&>;
    /// The tiles of a pass: the work in each.
    { executor.begin_pass(pass) } -> std::same_as<std::vector<std::uint32_t>>;
    /// The work that became whole.
    { executor.step(tile, worker) } -> std::same_as<std::uint32_t>;
    /// Every tile of the pass is whole.
    executor.end_pass();
    /// Of a worker, so far.
    { executor.rays(worker) } -> std::same_as<RayCounts>;
};

/// A schedule under way. Neither threads nor interruptions nor cancelling change the picture.
template <TileExecutor Executor>
class ScheduleRun {
  public:
    /// `progress` is called now and then from the threads, one at a time.
    ScheduleRun(Executor& executor, std::vector<Pass> passes, const CancelFlag* cancel = nullptr,
                std::function<void(const Progress&)> progress = {})
        : executor_(executor), cursor_(std::move(passes)), cancel_(cancel), report_(std::move(progress)),
          workers_(static_cast<std::size_t>(executor.pool().threads())) {
        begin_pass();
        if (report_) report_(progress_);
    }

    /// Goes on until wall_seconds() is `deadline`, but to the end of the first pass in any case, and over one
    /// step of each worker at least. Once the flag is set it returns within milliseconds; the tiles that were
    /// whole are kept.
    void run(double deadline) {
        const double begin = wall_seconds();
        cancelled_ = false;
        while (!is_finished() && !is_cancelled()) {
            run_pass(deadline);
            if (left_ == 0) end_pass();
            if (wall_seconds() >= deadline) break;
        }
        reached_ = reached_now();
        seconds_ += wall_seconds() - begin;
        reached_.seconds = seconds_;
        for (int worker = 0; worker < executor_.pool().threads(); ++worker)
            reached_.rays += executor_.rays(worker).total();
    }

    bool is_finished() const { return cursor_.is_finished(); }
    const Refinement& reached() const { return reached_; }
    /// Rays and threads, so far.
    void add_stats(RenderStats& stats) const {
        for (std::size_t i = 0; i < workers_.size(); ++i) {
            add_rays(executor_.rays(static_cast<int>(i)), stats);
            if (workers_[i].has_worked) ++stats.threads;
        }
    }

  private:
    struct Worker {
        std::uint64_t rays_reported = 0;
        bool has_worked = false;
        bool may_stop = false; ///< it has made a step since run() was called
    };

    Refinement reached_now() const {
        const auto left = static_cast<double>(left_.load());
        return cursor_.reached(work_of_pass_ > 0 ? 1 - left / static_cast<double>(work_of_pass_) : 0);
    }

    void begin_pass() {
        if (is_finished()) return;
        tiles_ = executor_.begin_pass(cursor_.pass());
        work_of_pass_ = std::accumulate(tiles_.begin(), tiles_.end(), std::uint64_t{0});
        left_ = work_of_pass_;
        progress_.tiles += work_of_pass_;
    }

    void end_pass() {
        executor_.end_pass();
        cursor_.next();
        begin_pass();
    }

    void run_pass(double deadline) {
        for (Worker& worker : workers_) worker.may_stop = false;
        executor_.pool().run(tiles_.size(), [&](std::size_t tile, int worker) {
            while (tiles_[tile] > 0 && !is_cancelled() && !is_late(worker, deadline)) step(tile, worker);
        });
    }

    void step(std::size_t tile, int number) {
        Worker& worker = workers_[static_cast<std::size_t>(number)];
        const std::uint32_t done = executor_.step(tile, number);
        tiles_[tile] -= done;
        left_.fetch_sub(done, std::memory_order_relaxed);
        worker.has_worked |= done > 0;
        worker.may_stop = true;
        if (report_) report(worker, done, executor_.rays(number).total());
    }

    /// Once seen it holds for all tiles, even if the flag is cleared meanwhile.
    bool is_cancelled() {
        if (glint::rendering::is_cancelled(cancel_)) cancelled_.store(true, std::memory_order_relaxed);
        return cancelled_.load(std::memory_order_relaxed);
    }

    bool is_late(int worker, double deadline) const {
        return !cursor_.is_first() && workers_[static_cast<std::size_t>(worker)].may_stop &&
               wall_seconds() >= deadline;
    }

    void report(Worker& worker, std::uint32_t done, std::uint64_t rays) {
        const std::lock_guard lock(mutex_);
        progress_.tiles_done += done;
        progress_.fraction = reached_now().fraction;
        progress_.rays += rays - worker.rays_reported;
        progress_.seconds = wall_seconds() - start_;
        worker.rays_reported = rays;
        report_(progress_);
    }

    Executor& executor_;
    ScheduleCursor cursor_;
    const CancelFlag* cancel_;
    std::function<void(const Progress&)> report_;
    std::vector<Worker> workers_;
    std::vector<std::uint32_t> tiles_; ///< of the pass: units of work that are left
    std::uint64_t work_of_pass_ = 0;   ///< units
    std::atomic<std::uint64_t> left_{0};
    std::atomic<bool> cancelled_{false};
    double start_ = wall_seconds();
    double seconds_ = 0; ///< in run()
    std::mutex mutex_;
    Progress progress_;
    Refinement reached_;
};

/// The picture of a film, measured in these passes. `begin`: when the picture began, by wall_seconds().
template <TileExecutor Executor>
Picture render_film(Executor& executor, Film& film, std::vector<Pass> passes, const RenderOptions& options,
                    double begin) {
    ScheduleRun run(executor, std::move(passes), options.cancel, options.progress);
    run.run(no_deadline);
    Picture picture;
    film.move_to(picture);
    picture.complete = run.is_finished();
    run.add_stats(picture.stats);
    picture.stats.wall_seconds = wall_seconds() - begin;
    return picture;
}

} // namespace glint::rendering
