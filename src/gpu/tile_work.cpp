#include "gpu/tile_work.h"

#include "render/schedule.h"

#include <algorithm>
#include <epoxy/gl.h>

namespace glint::gpu {
namespace {

int whole_squares(int pixels) { return (pixels + 7) / 8 * 8; }

std::size_t state_fields(std::size_t terms) { return field_terms + fields_of_term * terms; }

std::size_t slot_fields(const GpuSettings& scene, std::size_t terms) {
    const std::size_t rays = scene.max_depth + 2;
    return state_fields(terms) + rays * fields_of_ray;
}

/// What the counters of a tile say.
struct Counters {
    std::uint32_t unfinished = 0;
    std::uint32_t faults = 0;
    std::uint32_t rays[4] = {};
    std::uint32_t left_out = 0;
};

} // namespace

std::uint32_t slots_of(const Rect& tile) { return static_cast<std::uint32_t>(tile.width * tile.height); }

std::size_t film_fields(std::size_t terms) { return film_fields_of_term * terms + film_counts; }

std::vector<Rect> tiles_of(const GpuContext& context, const GpuSettings& scene, std::size_t terms, int width,
                           int height) {
    const std::size_t largest = std::min<std::uint64_t>(context.device().max_buffer, std::size_t{1} << 28);
    const std::size_t bytes = 4 * std::max(slot_fields(scene, terms), film_fields(terms));
    const auto slots = static_cast<int>(
        std::clamp<std::size_t>((largest - 4 * work_counters) / bytes, 64, DispatchBudget::max_slots));
    const int across = std::min(whole_squares(width), slots / 64 * 8);
    const int down = std::min(whole_squares(height), std::max(slots / std::max(across, 8) / 8 * 8, 8));
    std::vector<Rect> tiles;
    for (int y = 0; y < height; y += down)
        for (int x = 0; x < width; x += across)
            tiles.push_back({x, y, std::min(across, whole_squares(width - x)),
                             std::min(down, whole_squares(height - y))});
    return tiles;
}

void TileWork::start() {
    unfinished_ = 0;
    rays_ = {};
    seconds_ = 0;
}

void TileWork::begin(const GpuSettings& settings, std::uint32_t slots) {
    settings_ = settings;
    settings_.max_walk_steps = device_state_.budget().steps();
    slots_ = slots;
    const std::size_t bytes = 4 * (work_counters + slot_fields(settings, terms_) * slots);
    if (work_ == nullptr || work_->bytes() < bytes) {
        work_.reset();
        work_ = std::make_unique<GpuBuffer>(device_state_.context(), "the rays under way", nullptr, bytes);
    } else {
        work_->clear(4 * (work_counters + state_fields(terms_) * slots));
    }
    if (timer_ == nullptr) timer_ = std::make_unique<GpuTimer>(device_state_.context());
    first_ = 0;
    unfinished_ = slots;
    device_state_.budget().next_tile();
}

void TileWork::skip(std::span<const std::uint32_t> samples) {
    work_->write(4 * (work_counters + field_sample * std::size_t{slots_}), samples.data(),
                 samples.size_bytes());
}

void TileWork::step(const GpuProgram& program, const GpuBuffer& film) {
    device_state_.buffers().bind();
    work_->bind_storage(6);
    film.bind_storage(7);
    DispatchBudget& budget = device_state_.budget();
    const std::uint32_t past = std::min(first_ + budget.slots(), slots_);
    const bool whole = past - first_ == budget.slots();
    settings_.first_slot = first_;
    settings_.end_slot = past;
    settings_.slot_count = slots_;
    settings_.max_nodes = budget.nodes();
    const double start = rendering::wall_seconds();
    timer_->start();
    program.dispatch(settings_, past - first_);
    timer_->stop();
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    glFinish();
    device_state_.context().check("rendering");
    budget.learn(rendering::wall_seconds() - start, whole);
    seconds_ += timer_->seconds();
    first_ = past < slots_ ? past : 0;
    if (first_ == 0) count();
}

void TileWork::count() {
    Counters c;
    work_->read(0, &c, sizeof c);
    const Counters zero;
    work_->write(0, &zero, sizeof zero);
    if (c.faults != 0) unfinished_ = 0;
    if ((c.faults & fault_interiors) != 0)
        throw Error(ErrorKind::device,
                    "a ray is in more than eight transparent solids at once, which the GPU cannot follow",
                    "render on the CPU");
    if ((c.faults & fault_loops) != 0)
        throw Error(ErrorKind::device,
                    "the driver of " + device_state_.context().device().name +
                        " ended the walk of a ray before its end",
                    "the scene asks for too many steps at once: render on the CPU");
    rays_.primary += c.rays[0];
    rays_.reflected += c.rays[1];
    rays_.refracted += c.rays[2];
    rays_.shadow += c.rays[3];
    rays_.left_out += c.left_out;
    unfinished_ = c.unfinished;
    if (unfinished_ < slots_ / 4) device_state_.budget().few_left();
}

} // namespace glint::gpu
