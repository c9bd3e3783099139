#pragma once
// Runs a schedule (render/schedule.h) on the device, dispatch by dispatch: the counterpart of ScheduleRun.

#include "gpu/device_state.h"
#include "gpu/tile_work.h"
#include "render/film.h"
#include "render/schedule.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace glint {

/// A tile of a grid of pixels.
struct GpuTile {
    Rect rect;    ///< in the grid; its sides are multiples of 8
    Pixel origin; ///< of the grid, in the area of the schedule
    int step = 1; ///< pixels from one to the next
};

/// Terms that the device sums apart: each, or their sum alone.
std::size_t device_terms(const FilmLayout& layout);

/// All but the constructor needs the context to be entered, the destructor too.
class DeviceRun {
  public:
    /// Called when a tile is done, with the device's film of it.
    using TileDone = std::function<void(const GpuTile& tile, const GpuBuffer& film)>;

    explicit DeviceRun(GpuDeviceState& device_state) : device_state_(device_state) {}

    /// Begins to measure the scene that the device state holds.
    void start(const FilmLayout& layout, Aov show, std::vector<Pass> passes);
    /// Leaves nothing to go on with.
    void give_up();
    /// One dispatch, and what follows from it. True where counts of rays and slots are new. Throws
    /// Error(device): see TileWork::step().
    bool step(const TileDone& done);

    const ScheduleCursor& cursor() const { return cursor_; }
    const Pass& pass() const { return cursor_.pass(); }
    const FilmLayout& layout() const { return layout_; }
    std::size_t terms() const { return terms_; }
    bool first_hits() const { return first_hits_; }
    Refinement reached() const; ///< all but the seconds
    const TileWork& work() const { return *work_; }
    std::uint64_t slots_done() const; ///< of the pass; of the last where all are done
    std::uint64_t slots_of_pass() const;

    /// The tiles of the whole area, by which films of samples are kept.
    std::vector<GpuTile> picture_tiles() const { return tiles_of_grid({0, 0}, 1); }
    /// The film of such a tile; null where it has no samples.
    const GpuBuffer* film_of(std::size_t tile) const;
    std::uint32_t samples_of(std::size_t tile) const; ///< that are whole in its film
    bool is_under_way(std::size_t tile) const;        ///< are samples of it?
    /// The film of tiles that are not kept.
    const GpuBuffer* scratch() const { return scratch_.get(); }

    GpuSettings settings_of(const GpuTile& tile, const Pass& pass) const;

  private:
    void begin_pass();
    void begin_tile();
    std::vector<GpuTile> tiles_of_grid(const Pixel& origin, int step) const;
    bool keeps_film() const;
    const GpuBuffer& film();

    GpuDeviceState& device_state_;
    std::size_t terms_ = 0;
    std::optional<TileWork> work_;
    std::unique_ptr<GpuBuffer> scratch_;            ///< the film of tiles that are read at once
    std::vector<std::unique_ptr<GpuBuffer>> films_; ///< of samples, by tile of the picture
    std::vector<std::uint32_t> samples_;            ///< in each of them
    FilmLayout layout_;
    Aov show_ = Aov::final;
    bool first_hits_ = false;
    ScheduleCursor cursor_;
    std::vector<GpuTile> tiles_; ///< of the pass
    std::size_t tile_ = 0;       ///< the next, or the one under way
    std::uint64_t rays_before_ = 0;
};

} // namespace glint
