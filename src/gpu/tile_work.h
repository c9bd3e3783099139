#pragma once
// A tile under way on the device: its slots are dispatched again and again until their samples are done.
// Short dispatches keep the desktop responsive, avoid driver timeouts, and make cancelling quick.

#include "gpu/device_state.h"

#include "glint/render.h"
#include "render/camera_sample.h"

#include <span>
#include <vector>

namespace glint::gpu {

/// A slot is a pixel of a tile.
std::uint32_t slots_of(const Rect& tile);

/// Words of a film for each slot: sums and counts.
std::size_t film_fields(std::size_t terms);

/// Tiles of a picture of width × height pixels, as large as a buffer has room for the waiting rays of all
/// slots. Their sides are multiples of 8; the last of a row or column may reach beyond the picture.
std::vector<Rect> tiles_of(const GpuContext& context, const GpuSettings& scene, std::size_t terms, int width,
                           int height);

class TileWork {
  public:
    TileWork(GpuDeviceState& device_state, std::size_t terms) : device_state_(device_state), terms_(terms) {}

    /// Abandons the tile under way and resets all counts.
    void start();
    /// Begins a tile with a number of slots. `settings` say which pixels and samples.
    void begin(const GpuSettings& settings, std::uint32_t slots);
    /// Leaves out slots, before the first step: `samples` has how many samples each slot has already.
    void skip(std::span<const std::uint32_t> samples);
    /// One dispatch. Counts are new when all slots had one. Throws Error(device) for a ray that the shader
    /// cannot follow.
    void step(const GpuProgram& program, const GpuBuffer& film);

    bool is_under_way() const { return unfinished_ > 0; }
    std::uint32_t unfinished_squares() const { return (unfinished_ + square_slots - 1) / square_slots; }
    const rendering::RayCounts& rays() const { return rays_; } ///< since start()
    double device_seconds() const { return seconds_; }         ///< time that the device worked since then
    /// The slots' fields, for show.glsl.
    const GpuBuffer& buffer() const { return *work_; }

  private:
    void count();

    GpuDeviceState& device_state_;
    const std::size_t terms_;
    std::unique_ptr<GpuBuffer> work_;
    std::unique_ptr<GpuTimer> timer_;
    GpuSettings settings_{};
    std::uint32_t slots_ = 0;
    std::uint32_t first_ = 0; ///< of the next dispatch
    std::uint32_t unfinished_ = 0;
    rendering::RayCounts rays_;
    double seconds_ = 0;
};

} // namespace glint::gpu
