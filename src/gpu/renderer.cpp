// A whole picture on the device, tile by tile.

#include "glint/gpu.h"
#include "gpu/device_executor.h"
#include "gpu/device_state.h"
#include "render/film.h"
#include "render/schedule_run.h"

#include <span>

namespace glint {
namespace {

/// A pixel of a tile, from the fields of its slot.
void read_pixel(const rendering::Pass& pass, const rendering::Pixel& pixel, std::span<const float> fields,
                std::size_t slot, std::size_t slots, std::size_t terms, rendering::Film& film) {
    const auto field = [&](std::size_t f) { return fields[f * slots + slot]; };
    const auto sum = [&](std::size_t f) { return vec3(field(f), field(f + 1), field(f + 2)); };
    const auto count = [&](std::size_t i) {
        return static_cast<std::uint32_t>(field(film_fields_of_term * terms + i));
    };
    imaging::SignedSums<rendering::Terms> sums;
    for (std::size_t t = 0; t < terms; ++t) {
        sums.positive.value[t] = sum(3 * t);
        sums.negative.value[t] = sum(3 * (terms + t));
    }
    sums.count = pass.is_preview() ? 1 : static_cast<std::uint32_t>(pass.count);
    sums.positives = count(0);
    film.set_pixel(pass, pixel, sums, {count(1), count(2)});
}

void read_tile(const rendering::Pass& pass, const gpu::GpuTile& tile, const gpu::GpuBuffer& buffer,
               std::size_t terms, rendering::Film& film) {
    const std::uint32_t slots = gpu::slots_of(tile.rect);
    std::vector<float> fields(gpu::film_fields(terms) * slots);
    buffer.read(0, fields.data(), fields.size() * sizeof(float));
    const Rect& area = film.layout().area;
    for (std::uint32_t slot = 0; slot < slots; ++slot) {
        const rendering::Pixel pixel = tile.pixel(slot);
        if (pixel.x < area.width && pixel.y < area.height && (!pass.adaptive || film.takes(pixel)))
            read_pixel(pass, pixel, fields, slot, slots, terms, film);
    }
}

} // namespace

struct GpuRenderer::State {
    gpu::GpuDeviceState device_state;
};

GpuRenderer::GpuRenderer(int device, const GpuLimits& limits) : state_(new State{{device, limits}}) {}
GpuRenderer::~GpuRenderer() = default;
GpuRenderer::GpuRenderer(GpuRenderer&&) noexcept = default;
GpuRenderer& GpuRenderer::operator=(GpuRenderer&&) noexcept = default;

const GpuDevice& GpuRenderer::device() const { return state_->device_state.context().device(); }

void GpuRenderer::prepare(const Scene& scene) {
    const gpu::GpuScope scope(state_->device_state.context());
    state_->device_state.prepare(scene);
}

Picture GpuRenderer::render(const RenderOptions& options) {
    const double start = rendering::wall_seconds();
    gpu::GpuDeviceState& device_state = state_->device_state;
    if (!device_state.scene()) throw Error(ErrorKind::usage, "no scene was prepared");
    const gpu::GpuScope scope(device_state.context());
    rendering::Film film(rendering::film_layout(device_state.scene()->render_settings(), options));
    const std::vector<rendering::Pass> passes = rendering::picture_passes(film.layout().samples, options);
    for (const rendering::Pass& pass : passes) film.begin_pass(pass);
    gpu::DeviceExecutor executor(device_state);
    executor.start(
        film.layout(),
        [&](const gpu::GpuTile& tile, const gpu::GpuBuffer& buffer) {
            read_tile(executor.pass(), tile, buffer, executor.terms(), film);
            device_state.context().check("reading the picture");
        },
        [&](const rendering::Pass& pass) {
            if (pass.is_preview()) film.show_preview(pass, executor.pool());
            // The next pass is adaptive.
            else if (film.layout().samples.adaptive())
                film.refine(executor.pool());
        });
    executor.measure_only([&](const rendering::Pixel& pixel) { return film.takes(pixel); });
    Picture picture = rendering::render_film(executor, film, passes, options, start);
    picture.stats.device_seconds = executor.work().device_seconds();
    return picture;
}

} // namespace glint
