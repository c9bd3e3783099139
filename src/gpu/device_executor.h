#pragma once
// Measures the tiles of a schedule on the device, dispatch by dispatch: the counterpart of CpuExecutor. Its
// tiles are as large as buffers allow, since each takes several dispatches, which no other tile may
// interrupt.

#include "gpu/device_state.h"
#include "gpu/tile_work.h"
#include "parallel/task_pool.h"
#include "render/film.h"
#include "render/schedule.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace glint::gpu {

/// A tile of a grid of pixels.
struct GpuTile {
    Rect rect;               ///< in the grid; its sides are multiples of 8
    rendering::Pixel origin; ///< of the grid, in the area of the picture
    int step = 1;            ///< pixels from one to the next

    /// Of the area; it may lie beyond.
    rendering::Pixel pixel(std::uint32_t slot) const;
};

/// For ScheduleRun; its unit of work is a square of 64 slots. All but the constructor needs the context to be
/// entered, the destructor too.
class DeviceExecutor {
  public:
    /// Called when a tile is done, with the device's film of it.
    using TileDone = std::function<void(const GpuTile& tile, const GpuBuffer& film)>;
    /// Called when all tiles of a pass are done.
    using PassDone = std::function<void(const rendering::Pass& pass)>;

    explicit DeviceExecutor(GpuDeviceState& device_state) : device_state_(device_state) {}

    /// Begins a picture of the scene that the device state holds.
    void start(const rendering::FilmLayout& layout, TileDone tile_done, PassDone pass_done = {});
    /// Adaptive passes measure those pixels of the area only that `takes` says.
    void measure_only(std::function<bool(const rendering::Pixel&)> takes) { takes_ = std::move(takes); }

    parallel::TaskPool& pool() { return pool_; }
    std::vector<std::uint32_t> begin_pass(const rendering::Pass& pass);
    /// One dispatch. Throws Error(device): see TileWork::step().
    std::uint32_t step(std::size_t tile, int worker);
    void end_pass() {
        if (pass_done_) pass_done_(pass_);
    }
    rendering::RayCounts rays(int /*worker*/) const { return work_->rays(); }

    const rendering::Pass& pass() const { return pass_; } ///< the last that was begun
    const rendering::FilmLayout& layout() const { return layout_; }
    std::size_t terms() const { return terms_; } ///< that the device sums apart
    const TileWork& work() const { return *work_; }

    /// The tiles of the whole area, by which films of samples are kept.
    std::vector<GpuTile> picture_tiles() const { return tiles_of_grid({0, 0}, 1); }
    /// The film of such a tile; before it has samples, any.
    const GpuBuffer& film_of(std::size_t tile) const;
    std::uint32_t samples_in_film(std::size_t tile) const; ///< that are whole
    bool is_under_way(std::size_t tile) const;             ///< are samples of it?

    GpuSettings settings_of(const GpuTile& tile, const rendering::Pass& pass) const;

  private:
    void begin_tile();
    void skip_pixels(const GpuTile& tile);
    std::vector<GpuTile> tiles_of_grid(const rendering::Pixel& origin, int step) const;
    bool keeps_film() const;
    int samples_of(const rendering::Pass& pass) const;
    const GpuBuffer& film();

    GpuDeviceState& device_state_;
    parallel::TaskPool pool_{1}; ///< the thread that entered the context
    std::size_t terms_ = 0;
    std::optional<TileWork> work_;
    std::unique_ptr<GpuBuffer> scratch_;            ///< the film of tiles that are read when they are done
    std::vector<std::unique_ptr<GpuBuffer>> films_; ///< of samples, by tile of the picture
    std::vector<std::uint32_t> samples_;            ///< in each of them
    rendering::FilmLayout layout_;
    TileDone tile_done_;
    PassDone pass_done_;
    std::function<bool(const rendering::Pixel&)> takes_;
    rendering::Pass pass_;
    std::vector<GpuTile> tiles_; ///< of the pass
    std::size_t tile_ = 0;       ///< the one under way, or the last
};

} // namespace glint::gpu
