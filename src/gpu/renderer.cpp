// Tiles and passes on the device. A tile's slots are sent in dispatches of some hundredths of a second, again
// and again until their samples are done: desktops stay alive, watchdogs asleep, and cancelling is quick.

#include "glint/gpu.h"
#include "gpu/context.h"
#include "gpu/pace.h"
#include "gpu/program.h"
#include "gpu/scene_buffers.h"
#include "imaging/film.h"
#include "render/aspect.h"
#include "render/ray_tree.h"
#include "render/samples.h"

#include <algorithm>
#include <chrono>
#include <epoxy/gl.h>
#include <map>
#include <optional>

namespace glint {
namespace {

constexpr std::uint32_t group_size = Pace::group_size;
constexpr std::size_t counters = 16; ///< words before the slots' fields (shaders/slots.glsl)
constexpr std::uint32_t fault_media = 1;
constexpr std::uint32_t fault_loops = 2;

double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// What the counters of a tile say.
struct Counters {
    std::uint32_t unfinished = 0;
    std::uint32_t faults = 0;
    std::uint32_t rays[4] = {};
};

class Rendering {
  public:
    Rendering(const GpuContext& context, const GpuProgram& program, const GpuSettings& scene,
              const SceneBuffers& buffers, const RenderOptions& options, const RenderSettings& settings,
              Pace& pace)
        : context_(context), program_(program), scene_(scene), buffers_(buffers), options_(options),
          settings_(settings), area_(picture_area(settings, options.crop)), pace_(pace),
          terms_(options.terms ? term_count : 1) {}

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
    static int whole_squares(int pixels) { return (pixels + 7) / 8 * 8; }

    std::size_t fields() const {
        const std::size_t rays = scene_.limits.x + 2;
        return 2 + 3 * terms_ + rays * 14;
    }
    std::size_t film_fields() const { return 6 * terms_ + 2; }

    /// Tiles as large as the waiting rays of all their pixels fit into a buffer.
    void make_tiles() {
        const std::size_t largest =
            std::min<std::uint64_t>(context_.device().largest_buffer, std::size_t{1} << 28);
        const std::size_t bytes = 4 * std::max(fields(), film_fields());
        const auto slots =
            static_cast<int>(std::clamp<std::size_t>((largest - 4 * counters) / bytes, 64, Pace::most_slots));
        const int width = std::min(whole_squares(area_.width), slots / 64 * 8);
        const int height = std::min(whole_squares(area_.height), std::max(slots / width / 8 * 8, 8));
        for (int y = 0; y < area_.height; y += height)
            for (int x = 0; x < area_.width; x += width)
                tiles_.push_back({x, y, std::min(width, whole_squares(area_.width - x)),
                                  std::min(height, whole_squares(area_.height - y))});
        const auto most = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        work_.emplace(context_, "the rays under way", nullptr, 4 * (counters + fields() * most));
        film_.emplace(context_, "the pixels", nullptr, 4 * film_fields() * most);
        block_.emplace(context_, "the settings", nullptr, sizeof(GpuSettings));
        timer_.emplace(context_);
        std::uint64_t slots_in_all = 0;
        for (const Rect& tile : tiles_)
            slots_in_all += std::uint64_t(tile.width) * std::uint64_t(tile.height);
        progress_.tiles = slots_in_all / group_size;
    }

    /// Whether it was not cancelled.
    bool render_tile(const Rect& tile) {
        const auto slots = static_cast<std::uint32_t>(tile.width * tile.height);
        GpuSettings settings = scene_;
        settings.tile.x = static_cast<std::uint32_t>(area_.x + tile.x);
        settings.tile.y = static_cast<std::uint32_t>(area_.y + tile.y);
        settings.tile.z = static_cast<std::uint32_t>(tile.width);
        settings.area.x = static_cast<std::uint32_t>(area_.x + area_.width);
        settings.area.y = static_cast<std::uint32_t>(area_.y + area_.height);
        settings.area.w = static_cast<std::uint32_t>(settings_.spp);
        work_->clear();
        film_->clear();
        program_.use();
        buffers_.bind();
        work_->bind_storage(6);
        film_->bind_storage(7);
        block_->bind_uniform(0);
        const std::uint64_t groups_before = progress_.tiles_done;
        for (Counters counted{slots, 0, {}}; counted.unfinished > 0;) {
            if (!sweep(settings, slots)) return false;
            counted = take_counters();
            progress_.tiles_done = groups_before + (slots - counted.unfinished) / group_size;
            progress_.seconds = wall_seconds() - start_;
            if (options_.progress) options_.progress(progress_);
            if (counted.unfinished < slots / 4) pace_.few_left();
        }
        pace_.next_tile();
        read_tile(tile, slots);
        return true;
    }

    /// One step of every slot; false if cancelled.
    bool sweep(GpuSettings& settings, std::uint32_t slots) {
        for (std::uint32_t first = 0; first < slots;) {
            if (cancelled()) return false;
            const std::uint32_t past = std::min(first + pace_.slots(), slots);
            const bool whole = past - first == pace_.slots();
            settings.turn = uvec4(first, past, slots, pace_.nodes());
            const double start = wall_seconds();
            block_->write(0, &settings, sizeof settings);
            timer_->start();
            glDispatchCompute((past - first + group_size - 1) / group_size, 1, 1);
            timer_->stop();
            glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
            glFinish();
            context_.check("rendering");
            pace_.learn(wall_seconds() - start, whole);
            picture_.stats.device_seconds += timer_->seconds();
            first = past;
        }
        return true;
    }

    Counters take_counters() {
        Counters c;
        work_->read(0, &c, sizeof c);
        const Counters zero;
        work_->write(0, &zero, sizeof zero);
        if ((c.faults & fault_media) != 0)
            throw Error(ErrorKind::device,
                        "a ray is in more than eight transparent solids at once, which the GPU cannot follow",
                        "render on the CPU");
        if ((c.faults & fault_loops) != 0)
            throw Error(ErrorKind::device,
                        "the driver of " + context_.device().name + " ended the walk of a ray before its end",
                        "the scene asks for too many steps at once: render on the CPU");
        RenderStats& stats = picture_.stats;
        stats.primary_rays += c.rays[0];
        stats.reflected_rays += c.rays[1];
        stats.refracted_rays += c.rays[2];
        stats.shadow_rays += c.rays[3];
        progress_.rays = stats.rays();
        return c;
    }

    void read_tile(const Rect& tile, std::uint32_t slots) {
        std::vector<float> film(film_fields() * slots);
        film_->read(0, film.data(), film.size() * sizeof(float));
        context_.check("reading the picture");
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

    const GpuContext& context_;
    const GpuProgram& program_;
    const GpuSettings& scene_;
    const SceneBuffers& buffers_;
    const RenderOptions& options_;
    const RenderSettings& settings_;
    const Rect area_;
    Pace& pace_;
    const std::size_t terms_;
    double start_ = 0;
    std::size_t finished_ = 0;
    std::vector<Rect> tiles_; ///< within the area, sides multiples of 8
    std::optional<GpuBuffer> work_, film_, block_;
    std::optional<GpuTimer> timer_;
    Progress progress_;
    Picture picture_;
};

} // namespace

struct GpuRenderer::State {
    State(int device, const GpuLimits& limits) : context(device, limits.buffer), pace(limits) {}
    ~State() {
        // Programs and buffers go while their context is current.
        const GpuScope scope(context);
        buffers.reset();
        programs.clear();
    }

    const GpuProgram& program(const ProgramChoice& choice) {
        auto& made = programs[choice];
        if (made == nullptr) made = std::make_unique<GpuProgram>(context, shader_source(choice));
        return *made;
    }

    /// Is the tree of a scene the one that is in the device's memory?
    bool has_tree_of(const Scene& other) const {
        return scene && &scene->frozen().world.data() == &other.frozen().world.data();
    }

    GpuContext context;
    std::map<ProgramChoice, std::unique_ptr<GpuProgram>> programs;
    std::unique_ptr<SceneBuffers> buffers;
    GpuSceneData data; ///< what stays of it: settings and numbers
    std::optional<Scene> scene;
    Pace pace;
};

GpuRenderer::GpuRenderer(int device, const GpuLimits& limits)
    : state_(std::make_unique<State>(device, limits)) {}
GpuRenderer::~GpuRenderer() = default;
GpuRenderer::GpuRenderer(GpuRenderer&&) noexcept = default;
GpuRenderer& GpuRenderer::operator=(GpuRenderer&&) noexcept = default;

const GpuDevice& GpuRenderer::device() const { return state_->context.device(); }

void GpuRenderer::prepare(const Scene& scene) {
    const GpuScope scope(state_->context);
    const bool same_tree = state_->has_tree_of(scene);
    std::unique_ptr<SceneBuffers> before = std::move(state_->buffers);
    if (!same_tree) before.reset();
    state_->scene.reset();
    GpuSceneData data = flatten(scene.frozen(), same_tree ? &state_->data.tree : nullptr);
    state_->buffers = std::make_unique<SceneBuffers>(state_->context, data, before.get());
    state_->context.check("laying out the scene");
    data.tree.nodes = {};
    data.tree.leaves = {};
    data.words = {};
    state_->data = std::move(data);
    state_->scene = scene;
}

Picture GpuRenderer::render(const RenderOptions& options) {
    if (!state_->scene) throw Error(ErrorKind::usage, "no scene was prepared");
    if (term_of(options.show))
        return render_term(options, [this](const RenderOptions& all) { return render(all); });
    const GpuScope scope(state_->context);
    const GpuSceneData& data = state_->data;
    GpuSettings settings = data.settings;
    RenderSettings picture = state_->scene->render_settings();
    ProgramChoice choice = program_for(data);
    choice.terms = options.terms;
    if (!is_light(options.show)) {
        // One ray through each pixel's centre, and nothing bounces.
        choice.first_hit = true;
        settings.area.z = static_cast<std::uint32_t>(options.show);
        settings.limits.x = 0;
        settings.tile.w = 1;
        picture.spp = 1;
    }
    return Rendering(state_->context, state_->program(choice), settings, *state_->buffers, options, picture,
                     state_->pace)
        .run();
}

} // namespace glint
