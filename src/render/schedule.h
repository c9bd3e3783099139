#pragma once
// In which order a picture is measured, as values: passes over tiles. The CPU and the GPU run the same list.

#include "glint/progressive.h"
#include "glint/render.h"
#include "glint/scene.h"
#include "render/camera_sample.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace glint::rendering {

/// Seconds of a steady clock.
inline double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

inline void add_rays(const RayCounts& rays, RenderStats& stats) {
    stats.primary_rays += rays.primary;
    stats.reflected_rays += rays.reflected;
    stats.refracted_rays += rays.refracted;
    stats.shadow_rays += rays.shadow;
    stats.left_out_rays += rays.left_out;
    stats.light += rays.light;
    stats.clamped_light += rays.clamped;
}

inline bool is_cancelled(const CancelFlag* cancel) {
    return cancel != nullptr && cancel->load(std::memory_order_relaxed);
}

/// One visit of the pixels of a grid: every `step`-th of each row and column.
struct Pass {
    int step = 1;
    bool refines = false;  ///< pixels of the grid of 2 · step were measured before and are left out
    int first = 0;         ///< index of the first sample
    int count = 0;         ///< samples of each pixel; 0: a preview, one ray through each centre
    bool adaptive = false; ///< only of the pixels that differ from a neighbour (Film::refine())

    bool is_preview() const { return count == 0; }
    friend bool operator==(const Pass&, const Pass&) = default;
};

/// Part `index` of `count` equal parts of the work: every `count`-th tile from tile `index` on, or samples as
/// sample_shard() has them.
struct Shard {
    int index = 0;
    int count = 1;
};

/// An area cut into squares, row by row.
class TileGrid {
  public:
    TileGrid() = default;
    TileGrid(int width, int height, int tile_size);

    std::size_t count() const { return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_); }
    Rect tile(std::size_t index) const;

  private:
    int width_ = 0;
    int height_ = 0;
    int tile_size_ = 1;
    int columns_ = 0;
    int rows_ = 0;
};

/// The passes of render(): all samples of a tile in one visit, then those of the pixels that differ from a
/// neighbour; `coarse_first`, previews before that take at most a sixteenth of the work.
std::vector<Pass> picture_passes(const SampleCounts& samples, const RenderOptions& options);

/// Previews of every `coarsest`-th pixel of each row and column, then between these, until all have had one
/// ray through their centre. Then, unless one sample is all, samples double: 1, 1, 2, 4 … of each pixel and
/// what is left, so that one sum is all that a pixel needs to go on (PixelSum); those of the pixels that
/// differ from a neighbour too. Throws Error(usage) if `coarsest` is no power of two from 1 to max_coarsest.
std::vector<Pass> refining_passes(int coarsest, const SampleCounts& samples);

/// The samples of shard i of n: aligned blocks of a power of two of samples (the last of all may be shorter),
/// whose films join to the very bits of the whole. Empty where there are more shards than blocks.
std::vector<Pass> sample_shard(int samples, const Shard& shard);

/// How far the passes of a schedule are.
class ScheduleCursor {
  public:
    ScheduleCursor() = default; ///< finished
    explicit ScheduleCursor(std::vector<Pass> passes);

    bool is_finished() const { return index_ == passes_.size(); }
    bool is_first() const { return index_ == 0; }
    const Pass& pass() const { return passes_[index_]; } ///< the one under way
    void next();

    /// How good the picture has become where the share `of_pass` of the pass under way is done. Rays and
    /// seconds are not set.
    Refinement reached(double of_pass) const;

  private:
    std::vector<Pass> passes_;
    std::size_t index_ = 0;
    double work_ = 0; ///< of all passes, in samples of a pixel
    double done_ = 0; ///< of the passes before
};

} // namespace glint::rendering
