#include "gpu/device_executor.h"

#include "render/aov.h"

#include <algorithm>

namespace glint::gpu {

rendering::Pixel GpuTile::pixel(std::uint32_t slot) const {
    const uvec2 in_tile = pixel_of_slot(slot, static_cast<std::uint32_t>(rect.width));
    return {origin.x + (rect.x + static_cast<int>(in_tile.x)) * step,
            origin.y + (rect.y + static_cast<int>(in_tile.y)) * step};
}

void DeviceExecutor::start(const rendering::FilmLayout& layout, TileDone tile_done, PassDone pass_done) {
    const std::size_t terms = layout.terms || layout.term ? term_count : 1;
    if (!work_ || terms_ != terms) {
        terms_ = terms;
        work_.emplace(device_state_, terms_);
        scratch_.reset();
        films_.clear();
    }
    work_->start();
    layout_ = layout;
    tile_done_ = std::move(tile_done);
    pass_done_ = std::move(pass_done);
    samples_.assign(picture_tiles().size(), 0);
}

/// Between the pixels that are known, those at the middle of rows, of columns and of squares are measured one
/// after the other: each is a grid of its own.
std::vector<std::uint32_t> DeviceExecutor::begin_pass(const rendering::Pass& pass) {
    pass_ = pass;
    // The samples of adaptive passes are counted and summed anew.
    if (pass.adaptive && pass.first == 0) samples_.assign(samples_.size(), 0);
    tiles_.clear();
    std::vector<rendering::Pixel> origins{{0, 0}};
    if (pass.refines) origins = {{pass.step, 0}, {0, pass.step}, {pass.step, pass.step}};
    for (const rendering::Pixel& origin : origins) {
        const std::vector<GpuTile> grid = tiles_of_grid(origin, pass.refines ? 2 * pass.step : pass.step);
        tiles_.insert(tiles_.end(), grid.begin(), grid.end());
    }
    std::vector<std::uint32_t> squares;
    for (const GpuTile& tile : tiles_) squares.push_back(slots_of(tile.rect) / square_slots);
    return squares;
}

std::vector<GpuTile> DeviceExecutor::tiles_of_grid(const rendering::Pixel& origin, int step) const {
    const int across = (layout_.area.width - origin.x + step - 1) / step;
    const int down = (layout_.area.height - origin.y + step - 1) / step;
    std::vector<GpuTile> tiles;
    if (across <= 0 || down <= 0) return tiles;
    for (const Rect& rect : tiles_of(device_state_.context(), device_state_.settings(), terms_, across, down))
        tiles.push_back({rect, origin, step});
    return tiles;
}

std::uint32_t DeviceExecutor::step(std::size_t tile, int /*worker*/) {
    tile_ = tile;
    if (!work_->is_under_way()) begin_tile();
    const std::uint32_t squares = work_->unfinished_squares();
    work_->step(device_state_.program(terms_ > 1, !rendering::is_light(layout_.show)), film());
    if (!work_->is_under_way()) {
        tile_done_(tiles_[tile_], film());
        if (keeps_film()) samples_[tile_] = static_cast<std::uint32_t>(pass_.first + pass_.count);
    }
    return squares - work_->unfinished_squares();
}

void DeviceExecutor::begin_tile() {
    const GpuTile& tile = tiles_[tile_];
    const GpuBuffer& to = film();
    if (pass_.first == 0) to.clear(4 * film_fields(terms_) * slots_of(tile.rect));
    work_->begin(settings_of(tile, pass_), slots_of(tile.rect));
    if (pass_.adaptive) skip_pixels(tile);
}

void DeviceExecutor::skip_pixels(const GpuTile& tile) {
    std::vector<std::uint32_t> samples(slots_of(tile.rect));
    for (std::uint32_t slot = 0; slot < samples.size(); ++slot) {
        const rendering::Pixel pixel = tile.pixel(slot);
        const bool exists = pixel.x < layout_.area.width && pixel.y < layout_.area.height;
        if (!exists || !takes_(pixel)) samples[slot] = static_cast<std::uint32_t>(pass_.count);
    }
    work_->skip(samples);
}

/// Of a pixel when it is finished.
int DeviceExecutor::samples_of(const rendering::Pass& pass) const {
    if (pass.is_preview()) return 1;
    return pass.adaptive ? layout_.samples.differing : layout_.samples.all;
}

/// Samples to which later passes add.
bool DeviceExecutor::keeps_film() const {
    return !pass_.is_preview() && (pass_.first > 0 || pass_.count < samples_of(pass_));
}

/// The film of the tile, large enough and in a state to go on from.
const GpuBuffer& DeviceExecutor::film() {
    const std::size_t bytes = 4 * film_fields(terms_) * slots_of(tiles_[tile_].rect);
    if (keeps_film() && films_.size() <= tile_) films_.resize(tile_ + 1);
    std::unique_ptr<GpuBuffer>& held = keeps_film() ? films_[tile_] : scratch_;
    if (held == nullptr || held->bytes() < bytes) {
        held.reset();
        held = std::make_unique<GpuBuffer>(device_state_.context(), "the pixels", nullptr, bytes);
    }
    return *held;
}

const GpuBuffer& DeviceExecutor::film_of(std::size_t tile) const {
    return tile < films_.size() && films_[tile] != nullptr ? *films_[tile] : *scratch_;
}

std::uint32_t DeviceExecutor::samples_in_film(std::size_t tile) const { return samples_[tile]; }

bool DeviceExecutor::is_under_way(std::size_t tile) const {
    return !pass_.is_preview() && tile == tile_ && work_->is_under_way();
}

GpuSettings DeviceExecutor::settings_of(const GpuTile& tile, const rendering::Pass& pass) const {
    const Rect& area = layout_.area;
    GpuSettings s = device_state_.settings();
    s.tile_x = static_cast<std::uint32_t>(area.x + tile.origin.x + tile.rect.x * tile.step);
    s.tile_y = static_cast<std::uint32_t>(area.y + tile.origin.y + tile.rect.y * tile.step);
    s.tile_width = static_cast<std::uint32_t>(tile.rect.width);
    s.hides_background = layout_.coverage ? 1 : 0;
    s.samples = static_cast<std::uint32_t>(samples_of(pass));
    s.end_x = static_cast<std::uint32_t>(area.x + area.width);
    s.end_y = static_cast<std::uint32_t>(area.y + area.height);
    s.end_sample = static_cast<std::uint32_t>(pass.is_preview() ? 1 : pass.first + pass.count);
    s.pixel_step = static_cast<std::uint32_t>(tile.step);
    s.first_sample = static_cast<std::uint32_t>(pass.first);
    if (!rendering::is_light(layout_.show)) {
        // Nothing bounces.
        s.aov = static_cast<int>(layout_.show);
        s.max_depth = 0;
    }
    return s;
}

} // namespace glint::gpu
