#pragma once
// Measures the tiles of a schedule with threads: camera samples to estimators, what they measure to a film.

#include "parallel/task_pool.h"
#include "render/camera_sampler.h"
#include "render/estimators/estimator.h"
#include "render/film.h"
#include "render/schedule.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace glint::rendering {

/// For ScheduleRun; its unit of work is a tile. Refers to scene, film and pool. Skips what the film has.
class CpuExecutor {
  public:
    CpuExecutor(const scene::SceneData& scene, Film& film, parallel::TaskPool& pool,
                const KernelChoice& kernel = {}, const CancelFlag* cancel = nullptr, const Shard& shard = {});

    parallel::TaskPool& pool() const { return pool_; }
    std::vector<std::uint32_t> begin_pass(const Pass& pass);
    std::uint32_t step(std::size_t task, int worker);
    void end_pass();
    RayCounts rays(int worker) const;

  private:
    struct Worker {
        explicit Worker(Estimator e) : estimator(std::move(e)) {}

        Estimator estimator;
        std::vector<CameraSample> samples = std::vector<CameraSample>(batch_samples);
        std::vector<Channels> channels = std::vector<Channels>(batch_samples);
        FilmTile values;
    };
    /// One visit of a tile.
    struct Visit {
        Pass pass;
        std::size_t tile = 0;
        Rect rect;              ///< of the tile, in the grid of the pass
        bool continues = false; ///< adds to the sums of earlier visits
        bool keeps_states = false;
        bool centres = false;    ///< one ray through the centre of each pixel
        bool sums_terms = false; ///< else one channel
        int block_width = 1;     ///< pixels of the grid that follow each other
        int block_height = 1;
        std::size_t pixels_at_once = 1;
    };

    bool shows_preview() const;
    void begin_adaptive();
    bool measure_tile(std::size_t tile, Worker& worker);
    Visit visit_of(const Pass& pass, std::size_t tile) const;
    bool measure(const Visit& visit, Worker& worker) const;
    void collect_pixels(const Visit& visit, FilmTile& values) const;
    bool takes(const Visit& visit, const Pixel& pixel) const;
    template <class T>
    void measure_samples(const Visit& visit, std::size_t from, std::size_t end, Worker& worker) const;
    template <class T>
    void measure_pixel(const Visit& visit, std::size_t pixel, Worker& worker) const;
    void estimate_samples(const Visit& visit, std::size_t from, std::size_t end, int first, int count,
                          Worker& worker) const;
    template <class T>
    const T& measured(const Channels& channels) const;
    template <class T>
    void put(const T& value, float coverage, std::size_t pixel, FilmTile& values) const;
    template <class T>
    struct PixelSamples;
    template <class T>
    void put_sums(const PixelSamples<T>& samples, const Visit& visit, std::size_t pixel,
                  FilmTile& values) const;
    bool is_cancelled() const { return glint::rendering::is_cancelled(cancel_); }

    Film& film_;
    parallel::TaskPool& pool_;
    const CancelFlag* cancel_;
    Shard shard_;
    CameraSampler sampler_;
    std::vector<Pixel> block_; ///< the first batch_samples points of the Morton curve
    std::vector<Worker> workers_;
    Pass pass_;     ///< the one under way
    TileGrid grid_; ///< its tiles
};

} // namespace glint::rendering
