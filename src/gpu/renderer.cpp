// A whole picture on the device, tile by tile.

#include "glint/gpu.h"
#include "gpu/device_run.h"
#include "gpu/device_state.h"
#include "render/aov.h"
#include "render/film.h"

namespace glint {
namespace {

class Rendering {
  public:
    Rendering(GpuDeviceState& device_state, const RenderOptions& options)
        : device_state_(device_state), options_(options),
          film_(film_layout(device_state.scene()->render_settings(), options)), run_(device_state) {}

    Picture run() {
        film_.begin_pass({});
        run_.start(film_.layout(), options_.show, one_pass(film_.layout().samples));
        progress_.tiles = run_.slots_of_pass() / DispatchBudget::group_size;
        const auto read = [this](const GpuTile& tile, const GpuBuffer& film) { read_tile(tile.rect, film); };
        while (!run_.cursor().is_finished() && !is_cancelled(options_.cancel))
            if (run_.step(read)) report();
        Picture picture;
        film_.move_to(picture);
        picture.stats = stats_;
        picture.complete = run_.cursor().is_finished();
        picture.stats.wall_seconds = wall_seconds() - start_;
        picture.stats.threads = 1;
        return picture;
    }

  private:
    void report() {
        stats_ = {};
        add_rays(run_.work().rays(), stats_);
        stats_.device_seconds = run_.work().device_seconds();
        progress_.rays = stats_.rays();
        progress_.tiles_done = run_.slots_done() / DispatchBudget::group_size;
        progress_.seconds = wall_seconds() - start_;
        if (options_.progress) options_.progress(progress_);
    }

    void read_tile(const Rect& tile, const GpuBuffer& buffer) {
        const std::uint32_t slots = slots_of(tile);
        std::vector<float> fields(film_fields(run_.terms()) * slots);
        buffer.read(0, fields.data(), fields.size() * sizeof(float));
        device_state_.context().check("reading the picture");
        const int columns = tile.width / 8;
        const Rect& area = film_.layout().area;
        for (std::uint32_t slot = 0; slot < slots; ++slot) {
            const auto square = static_cast<int>(slot / 64);
            const int x = tile.x + 8 * (square % columns) + static_cast<int>(slot % 8);
            const int y = tile.y + 8 * (square / columns) + static_cast<int>(slot % 64 / 8);
            if (x < area.width && y < area.height) set_pixel({x, y}, fields, slot, slots);
        }
    }

    void set_pixel(const Pixel& pixel, const std::vector<float>& fields, std::size_t slot,
                   std::size_t slots) {
        const auto field = [&](std::size_t f) { return fields[f * slots + slot]; };
        const std::size_t terms = run_.terms();
        SignedSums<Terms> sums;
        for (std::size_t t = 0; t < terms; ++t) {
            sums.positive.value[t] = vec3(field(3 * t), field(3 * t + 1), field(3 * t + 2));
            const std::size_t n = 3 * terms + 3 * t;
            sums.negative.value[t] = vec3(field(n), field(n + 1), field(n + 2));
        }
        sums.count = static_cast<std::uint32_t>(film_.layout().samples);
        sums.positives = static_cast<std::uint32_t>(field(film_fields_of_term * terms));
        film_.set_pixel(pixel, sums, static_cast<std::uint32_t>(field(film_fields_of_term * terms + 1)));
    }

    GpuDeviceState& device_state_;
    const RenderOptions& options_;
    const double start_ = wall_seconds();
    Film film_;
    DeviceRun run_;
    Progress progress_;
    RenderStats stats_;
};

} // namespace

struct GpuRenderer::State {
    GpuDeviceState device_state;
};

GpuRenderer::GpuRenderer(int device, const GpuLimits& limits) : state_(new State{{device, limits}}) {}
GpuRenderer::~GpuRenderer() = default;
GpuRenderer::GpuRenderer(GpuRenderer&&) noexcept = default;
GpuRenderer& GpuRenderer::operator=(GpuRenderer&&) noexcept = default;

const GpuDevice& GpuRenderer::device() const { return state_->device_state.context().device(); }

void GpuRenderer::prepare(const Scene& scene) {
    const GpuScope scope(state_->device_state.context());
    state_->device_state.prepare(scene);
}

Picture GpuRenderer::render(const RenderOptions& options) {
    GpuDeviceState& device_state = state_->device_state;
    if (!device_state.scene()) throw Error(ErrorKind::usage, "no scene was prepared");
    const GpuScope scope(device_state.context());
    return Rendering(device_state, options).run();
}

} // namespace glint
