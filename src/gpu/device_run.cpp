#include "gpu/device_run.h"

#include "render/aov.h"

#include <algorithm>

namespace glint {

std::size_t device_terms(const FilmLayout& layout) { return layout.terms || layout.term ? term_count : 1; }

void DeviceRun::start(const FilmLayout& layout, Aov show, std::vector<Pass> passes) {
    if (!work_ || terms_ != device_terms(layout)) {
        terms_ = device_terms(layout);
        work_.emplace(device_state_, terms_);
        scratch_.reset();
        films_.clear();
    }
    layout_ = layout;
    show_ = show;
    first_hits_ = !is_light(show);
    samples_.assign(picture_tiles().size(), 0);
    rays_before_ = work_->rays().total();
    cursor_ = ScheduleCursor(std::move(passes));
    begin_pass();
}

void DeviceRun::give_up() {
    cursor_ = {};
    if (work_) work_->give_up();
}

/// Between the pixels that are known, those at the middle of rows, of columns and of squares are measured one
/// after the other: each is a grid of its own.
void DeviceRun::begin_pass() {
    if (cursor_.is_finished()) return;
    tile_ = 0;
    tiles_.clear();
    const int step = pass().step;
    if (!pass().refines) {
        tiles_ = tiles_of_grid({0, 0}, step);
        return;
    }
    for (const Pixel& origin : {Pixel{step, 0}, Pixel{0, step}, Pixel{step, step}}) {
        const std::vector<GpuTile> grid = tiles_of_grid(origin, 2 * step);
        tiles_.insert(tiles_.end(), grid.begin(), grid.end());
    }
}

std::vector<GpuTile> DeviceRun::tiles_of_grid(const Pixel& origin, int step) const {
    const int across = (layout_.area.width - origin.x + step - 1) / step;
    const int down = (layout_.area.height - origin.y + step - 1) / step;
    std::vector<GpuTile> tiles;
    if (across <= 0 || down <= 0) return tiles;
    for (const Rect& rect : tiles_of(device_state_.context(), device_state_.settings(), terms_, across, down))
        tiles.push_back({rect, origin, step});
    return tiles;
}

bool DeviceRun::step(const TileDone& done) {
    bool counted = false;
    if (tile_ < tiles_.size()) {
        if (!work_->is_under_way()) begin_tile();
        counted = work_->step(device_state_.program(terms_ > 1, first_hits_), film());
        if (!work_->is_under_way()) {
            done(tiles_[tile_], film());
            if (keeps_film()) samples_[tile_] = static_cast<std::uint32_t>(pass().first + pass().count);
            ++tile_;
        }
    }
    if (tile_ == tiles_.size() && !cursor_.is_finished()) {
        cursor_.next();
        begin_pass();
    }
    return counted;
}

void DeviceRun::begin_tile() {
    const GpuTile& tile = tiles_[tile_];
    const GpuBuffer& to = film();
    if (pass().first == 0) to.clear(4 * film_fields(terms_) * slots_of(tile.rect));
    work_->begin(settings_of(tile, pass()), slots_of(tile.rect));
}

/// Samples to which later passes add.
bool DeviceRun::keeps_film() const {
    return !pass().is_preview() && (pass().first > 0 || pass().count < layout_.samples);
}

/// The film of the tile, large enough and in a state to go on from.
const GpuBuffer& DeviceRun::film() {
    const std::size_t bytes = 4 * film_fields(terms_) * slots_of(tiles_[tile_].rect);
    if (keeps_film() && films_.size() <= tile_) films_.resize(tile_ + 1);
    std::unique_ptr<GpuBuffer>& held = keeps_film() ? films_[tile_] : scratch_;
    if (held == nullptr || held->bytes() < bytes) {
        held.reset();
        held = std::make_unique<GpuBuffer>(device_state_.context(), "the pixels", nullptr, bytes);
    }
    return *held;
}

const GpuBuffer* DeviceRun::film_of(std::size_t tile) const {
    return tile < films_.size() ? films_[tile].get() : nullptr;
}

std::uint32_t DeviceRun::samples_of(std::size_t tile) const { return samples_[tile]; }

bool DeviceRun::is_under_way(std::size_t tile) const {
    return !cursor_.is_finished() && !pass().is_preview() && tile == tile_ && work_->is_under_way();
}

GpuSettings DeviceRun::settings_of(const GpuTile& tile, const Pass& pass) const {
    const Rect& area = layout_.area;
    GpuSettings s = device_state_.settings();
    s.tile_x = static_cast<std::uint32_t>(area.x + tile.origin.x + tile.rect.x * tile.step);
    s.tile_y = static_cast<std::uint32_t>(area.y + tile.origin.y + tile.rect.y * tile.step);
    s.tile_width = static_cast<std::uint32_t>(tile.rect.width);
    s.samples = static_cast<std::uint32_t>(pass.is_preview() ? 1 : layout_.samples);
    s.end_x = static_cast<std::uint32_t>(area.x + area.width);
    s.end_y = static_cast<std::uint32_t>(area.y + area.height);
    s.end_sample = static_cast<std::uint32_t>(pass.is_preview() ? 1 : pass.first + pass.count);
    s.pixel_step = static_cast<std::uint32_t>(tile.step);
    s.first_sample = static_cast<std::uint32_t>(pass.first);
    if (first_hits_) {
        // Nothing bounces.
        s.aov = static_cast<std::uint32_t>(show_);
        s.max_depth = 0;
    }
    return s;
}

std::uint64_t DeviceRun::slots_of_pass() const {
    std::uint64_t slots = 0;
    for (const GpuTile& tile : tiles_) slots += slots_of(tile.rect);
    return slots;
}

std::uint64_t DeviceRun::slots_done() const {
    std::uint64_t slots = 0;
    for (std::size_t i = 0; i < tile_; ++i) slots += slots_of(tiles_[i].rect);
    return work_->is_under_way() ? slots + work_->slots() - work_->unfinished() : slots;
}

Refinement DeviceRun::reached() const {
    double of_pass = 0;
    if (!cursor_.is_finished() && !tiles_.empty())
        of_pass = static_cast<double>(slots_done()) / static_cast<double>(slots_of_pass());
    Refinement reached = cursor_.reached(of_pass);
    if (work_) reached.rays = work_->rays().total() - rays_before_;
    return reached;
}

} // namespace glint
