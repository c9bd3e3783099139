#include "render/schedule.h"

#include "glint/error.h"

#include <algorithm>
#include <bit>

namespace glint::rendering {
namespace {

/// In samples of a pixel.
double work_of(const Pass& pass) {
    // How many pixels differ is not known before; this many in an ordinary picture.
    if (pass.adaptive) return 0.2 * pass.count;
    if (!pass.is_preview()) return pass.count;
    return (pass.refines ? 0.75 : 1.0) / (double(pass.step) * pass.step);
}

/// Previews of every `coarsest`-th pixel of each row and column, then between these, to every `finest`-th.
std::vector<Pass> previews(int coarsest, int finest) {
    std::vector<Pass> passes;
    for (int step = coarsest; step >= finest; step /= 2) passes.push_back({step, step != coarsest, 0, 0});
    return passes;
}

} // namespace

TileGrid::TileGrid(int width, int height, int tile_size)
    : width_(width), height_(height), tile_size_(tile_size), columns_((width + tile_size - 1) / tile_size),
      rows_((height + tile_size - 1) / tile_size) {}

Rect TileGrid::tile(std::size_t index) const {
    Rect r;
    r.x = static_cast<int>(index % static_cast<std::size_t>(columns_)) * tile_size_;
    r.y = static_cast<int>(index / static_cast<std::size_t>(columns_)) * tile_size_;
    r.width = std::min(tile_size_, width_ - r.x);
    r.height = std::min(tile_size_, height_ - r.y);
    return r;
}

std::vector<Pass> picture_passes(const SampleCounts& samples, const RenderOptions& options) {
    std::vector<Pass> passes;
    if (options.coarse_first) {
        int finest = 1;
        while (finest * finest * samples.all < 16) finest *= 2;
        passes = previews(16, finest);
    }
    passes.push_back({1, false, 0, samples.all});
    if (samples.adaptive()) passes.push_back({1, false, 0, samples.differing, true});
    return passes;
}

std::vector<Pass> refining_passes(int coarsest, const SampleCounts& samples) {
    if (coarsest < 1 || coarsest > max_coarsest || !std::has_single_bit(static_cast<unsigned>(coarsest)))
        throw Error(ErrorKind::usage, "the coarsest step is not a power of two",
                    "expected 1, 2, 4, 8, 16, 32 or 64");
    std::vector<Pass> passes = previews(coarsest, 1);
    const auto add_doubling = [&](int first, int all, bool adaptive) {
        for (int done = 0; done < all;) {
            const int count = std::min(std::max(done, first), all - done);
            passes.push_back({1, false, done, count, adaptive});
            done += count;
        }
    };
    // An adaptive picture needs samples of its own to compare, even if one is all.
    if (samples.all > 1 || samples.adaptive()) add_doubling(1, samples.all, false);
    // Not fewer at first than the pixels had before.
    if (samples.adaptive())
        add_doubling(static_cast<int>(std::bit_ceil(static_cast<unsigned>(samples.all))), samples.differing,
                     true);
    return passes;
}

std::vector<Pass> sample_shard(int samples, const Shard& shard) {
    const int share = (samples + shard.count - 1) / shard.count;
    const auto block = std::int64_t{std::bit_ceil(static_cast<std::uint32_t>(share))};
    const std::int64_t first = shard.index * block;
    if (first >= samples) return {};
    return {{1, false, static_cast<int>(first), static_cast<int>(std::min(block, samples - first))}};
}

ScheduleCursor::ScheduleCursor(std::vector<Pass> passes) : passes_(std::move(passes)) {
    for (const Pass& pass : passes_) work_ += work_of(pass);
}

void ScheduleCursor::next() {
    done_ += work_of(pass());
    ++index_;
}

Refinement ScheduleCursor::reached(double of_pass) const {
    Refinement reached;
    if (index_ > 0) {
        const Pass& last = passes_[index_ - 1];
        reached.step = last.step;
        reached.samples = last.first + last.count;
        reached.finished = is_finished();
    }
    if (!passes_.empty()) reached.fraction = is_finished() ? 1 : (done_ + work_of(pass()) * of_pass) / work_;
    return reached;
}

} // namespace glint::rendering
