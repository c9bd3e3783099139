// A whole picture on the device, tile by tile.

#include "glint/gpu.h"
#include "gpu/clock.h"
#include "gpu/studio.h"
#include "gpu/tile_work.h"
#include "imaging/film.h"
#include "render/aspect.h"
#include "render/camera_sampler.h"

#include <algorithm>

namespace glint {
namespace {

class Rendering {
  public:
    Rendering(GpuStudio& studio, const GpuProgram& program, const GpuSettings& scene,
              const RenderOptions& options, const RenderSettings& settings)
        : studio_(studio), program_(program), scene_(scene), options_(options), settings_(settings),
          area_(picture_area(settings, options.crop)), terms_(options.terms ? term_count : 1),
          work_(studio, terms_) {}

    Picture run() {
        const double start = wall_seconds();
        start_ = start;
        picture_.image = Image(area_.width, area_.height);
        if (options_.terms)
            for (Image& term : picture_.terms) term = Image(area_.width, area_.height);
        if (options_.coverage) picture_.coverage.resize(pixel_index(0, area_.height));
        make_tiles();
        for (const Rect& tile : tiles_) {
            if (cancelled()) break;
            if (render_tile(tile)) finished_ += 1;
        }
        picture_.complete = finished_ == tiles_.size();
        picture_.stats.wall_seconds = wall_seconds() - start;
        picture_.stats.threads = 1;
        return std::move(picture_);
    }

  private:
    bool cancelled() const {
        return options_.cancel != nullptr && options_.cancel->load(std::memory_order_relaxed);
    }
    std::size_t pixel_index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(area_.width) +
               static_cast<std::size_t>(x);
    }
    void make_tiles() {
        tiles_ = tiles_of(studio_.context(), scene_, terms_, area_.width, area_.height);
        std::uint64_t slots_in_all = 0;
        for (const Rect& tile : tiles_) slots_in_all += slots_of(tile);
        progress_.tiles = slots_in_all / Pace::group_size;
        // The first is the largest.
        film_ = std::make_unique<GpuBuffer>(studio_.context(), "the pixels", nullptr,
                                            4 * film_fields(terms_) * slots_of(tiles_.front()));
    }

    /// Whether it was not cancelled.
    bool render_tile(const Rect& tile) {
        const std::uint32_t slots = slots_of(tile);
        GpuSettings settings = scene_;
        settings.tile_x = static_cast<std::uint32_t>(area_.x + tile.x);
        settings.tile_y = static_cast<std::uint32_t>(area_.y + tile.y);
        settings.tile_width = static_cast<std::uint32_t>(tile.width);
        settings.end_x = static_cast<std::uint32_t>(area_.x + area_.width);
        settings.end_y = static_cast<std::uint32_t>(area_.y + area_.height);
        settings.end_sample = static_cast<std::uint32_t>(settings_.spp);
        film_->clear();
        work_.begin(settings, slots);
        const std::uint64_t groups_before = progress_.tiles_done;
        while (work_.is_under_way()) {
            if (cancelled()) return false;
            if (work_.step(program_, *film_)) tell(groups_before);
        }
        read_tile(tile, slots);
        return true;
    }

    void tell(std::uint64_t groups_before) {
        RenderStats& stats = picture_.stats;
        const TileWork::Rays& rays = work_.rays();
        stats.primary_rays = rays[0];
        stats.reflected_rays = rays[1];
        stats.refracted_rays = rays[2];
        stats.shadow_rays = rays[3];
        stats.device_seconds = work_.device_seconds();
        progress_.rays = stats.rays();
        progress_.tiles_done = groups_before + (work_.slots() - work_.unfinished()) / Pace::group_size;
        progress_.seconds = wall_seconds() - start_;
        if (options_.progress) options_.progress(progress_);
    }

    void read_tile(const Rect& tile, std::uint32_t slots) {
        std::vector<float> film(film_fields(terms_) * slots);
        film_->read(0, film.data(), film.size() * sizeof(float));
        studio_.context().check("reading the picture");
        const int columns = tile.width / 8;
        for (std::uint32_t slot = 0; slot < slots; ++slot) {
            const auto square = static_cast<int>(slot / 64);
            const int x = tile.x + 8 * (square % columns) + static_cast<int>(slot % 8);
            const int y = tile.y + 8 * (square / columns) + static_cast<int>(slot % 64 / 8);
            if (x < area_.width && y < area_.height) store(film, slot, slots, x, y);
        }
    }

    void store(const std::vector<float>& film, std::size_t slot, std::size_t slots, int x, int y) {
        const auto field = [&](std::size_t f) { return film[f * slots + slot]; };
        SignedSums<Terms> sums;
        for (std::size_t t = 0; t < terms_; ++t) {
            sums.positive.value[t] = vec3(field(3 * t), field(3 * t + 1), field(3 * t + 2));
            const std::size_t n = 3 * terms_ + 3 * t;
            sums.negative.value[t] = vec3(field(n), field(n + 1), field(n + 2));
        }
        sums.count = static_cast<std::uint32_t>(settings_.spp);
        sums.positives = static_cast<std::uint32_t>(field(6 * terms_));
        const Terms value = pixel_value(sums);
        write(picture_.image.at(x, y), value.sum());
        if (options_.terms)
            for (std::size_t t = 0; t < terms_; ++t) write(picture_.terms[t].at(x, y), value.value[t]);
        if (options_.coverage)
            picture_.coverage[pixel_index(x, y)] = field(6 * terms_ + 1) / static_cast<float>(settings_.spp);
    }

    static void write(float* pixel, const vec3& value) {
        pixel[0] = value.x;
        pixel[1] = value.y;
        pixel[2] = value.z;
    }

    GpuStudio& studio_;
    const GpuProgram& program_;
    const GpuSettings& scene_;
    const RenderOptions& options_;
    const RenderSettings& settings_;
    const Rect area_;
    const std::size_t terms_;
    TileWork work_;
    double start_ = 0;
    std::size_t finished_ = 0;
    std::vector<Rect> tiles_;
    std::unique_ptr<GpuBuffer> film_;
    Progress progress_;
    Picture picture_;
};

} // namespace

struct GpuRenderer::State {
    GpuStudio studio;
};

GpuRenderer::GpuRenderer(int device, const GpuLimits& limits) : state_(new State{{device, limits}}) {}
GpuRenderer::~GpuRenderer() = default;
GpuRenderer::GpuRenderer(GpuRenderer&&) noexcept = default;
GpuRenderer& GpuRenderer::operator=(GpuRenderer&&) noexcept = default;

const GpuDevice& GpuRenderer::device() const { return state_->studio.context().device(); }

void GpuRenderer::prepare(const Scene& scene) {
    const GpuScope scope(state_->studio.context());
    state_->studio.prepare(scene);
}

Picture GpuRenderer::render(const RenderOptions& options) {
    GpuStudio& studio = state_->studio;
    if (!studio.scene()) throw Error(ErrorKind::usage, "no scene was prepared");
    if (term_of(options.show))
        return render_term(options, [this](const RenderOptions& all) { return render(all); });
    const GpuScope scope(studio.context());
    GpuSettings settings = studio.settings();
    RenderSettings picture = studio.scene()->render_settings();
    RenderOptions wanted = options;
    const bool first_hit = !is_light(options.show);
    if (first_hit) {
        // One ray through each pixel's centre, nothing bounces, and numbers have no terms.
        wanted.terms = false;
        wanted.coverage = false;
        settings.aov = static_cast<std::uint32_t>(options.show);
        settings.max_depth = 0;
        settings.samples = 1;
        picture.spp = 1;
    }
    return Rendering(studio, studio.program(wanted.terms, first_hit), settings, wanted, picture).run();
}

} // namespace glint
