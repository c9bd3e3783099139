#include "renderer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <new>
#include <thread>
#include <utility>
#include <vector>

namespace glint::viewer {
namespace {

using Clock = std::chrono::steady_clock;

/// How often a picture that gets better is shown.
constexpr double slice_seconds = 0.040;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// What is to be shown.
struct Wish {
    std::array<std::optional<Scene>, picture_places> scenes;
    std::array<Aspect, picture_places> show{};
    Kernel kernel = Kernel::automatic;
    CameraDescription camera;
    int width = 0;
    int height = 0;
    PainterMaker gpu;
    std::array<bool, picture_places> is_new{}; ///< scenes that the graphics card was not asked for yet
    bool same_view = false;                    ///< only who draws is another than before

    bool is_possible() const {
        return width > 0 && height > 0 &&
               std::any_of(scenes.begin(), scenes.end(), [](const auto& scene) { return scene.has_value(); });
    }
};

/// Frames that nobody looks at any more serve again: large memory is slow to get.
class FramePool {
  public:
    std::shared_ptr<Frame> take() {
        std::unique_ptr<Frame> frame;
        {
            const std::lock_guard lock(shelf_->mutex);
            if (!shelf_->frames.empty()) {
                frame = std::move(shelf_->frames.back());
                shelf_->frames.pop_back();
            }
        }
        if (!frame) frame = std::make_unique<Frame>();
        return {frame.release(), [shelf = shelf_](Frame* done) {
                    std::unique_ptr<Frame> back(done);
                    back->on_device.reset();
                    const std::lock_guard lock(shelf->mutex);
                    if (shelf->frames.size() < most_spare) shelf->frames.push_back(std::move(back));
                }};
    }

  private:
    static constexpr std::size_t most_spare = 4;
    struct Shelf {
        std::mutex mutex;
        std::vector<std::unique_ptr<Frame>> frames;
    };
    std::shared_ptr<Shelf> shelf_ = std::make_shared<Shelf>();
};

/// How coarse the first picture must be to be there in time, learnt from those before: each takes so long a
/// sample, and so long whatever its coarseness.
class Pace {
  public:
    explicit Pace(double seconds) : seconds_(seconds) {}

    int step(int pixels) const {
        int step = 1;
        while (step < most_coarse && seconds_of(pixels, step) > seconds_) step *= 2;
        return step;
    }

    void learn(int pixels, int step, double tracing, double showing) {
        // One late picture is no reason to make many coarse: the machine may have been busy otherwise.
        constexpr double share = 0.25;
        const double now = tracing / std::max(1.0, samples(pixels, step));
        seconds_a_sample_ += share * (std::min(now, 4 * seconds_a_sample_) - seconds_a_sample_);
        seconds_a_pixel_ += share * (std::min(showing / pixels, 4 * seconds_a_pixel_) - seconds_a_pixel_);
    }

  private:
    static double samples(int pixels, int step) { return static_cast<double>(pixels) / (step * step); }
    double seconds_of(int pixels, int step) const {
        return samples(pixels, step) * seconds_a_sample_ + pixels * seconds_a_pixel_;
    }

    double seconds_;
    double seconds_a_sample_ = 1e-6;
    double seconds_a_pixel_ = 1e-8;
};

/// One who draws for one place.
struct Desk {
    std::unique_ptr<Painter> painter;
    Pace pace;
};

/// What stands at one place.
struct Easel {
    explicit Easel(double seconds) : cpu{nullptr, Pace(seconds)}, gpu{nullptr, Pace(seconds)} {}

    Desk cpu, gpu;
    bool on_gpu = false;        ///< who draws
    std::optional<Scene> scene; ///< as seen from the camera
    Aspect show = Aspect::final;
    std::string fault;          ///< why the graphics card is not asked
    int coarsest = most_coarse; ///< no picture with a wider step is shown
    int first_step = 0;         ///< of its first picture; 0 where that tells nothing of the pace
    double first_seconds = 0;   ///< that it took

    Painter& painter() { return *(on_gpu ? gpu : cpu).painter; }
};

/// Does it on the graphics card, or says why not.
template <class Work>
std::string fault_of(const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.diagnostics().front().message;
    } catch (const std::bad_alloc&) {
        return "there is too little memory for the graphics card's part";
    }
    return {};
}

} // namespace

struct SessionRenderer::State {
    explicit State(Options given) : options(std::move(given)) {}

    const Options options;

    mutable std::mutex mutex; ///< guards the following
    std::condition_variable changed;
    Wish wish;
    View tone = View::srgb;
    bool is_retoned = false;  ///< pictures are to be shown with another tone
    bool is_stale = false;    ///< the wish is another than what is rendered
    bool must_finish = false; ///< the first picture is under way: it is shown even when it is stale
    bool closing = false;
    std::array<std::shared_ptr<const Frame>, picture_places> frames;

    CancelFlag cancel{false};
    std::thread thread;

    // Of the renderer's thread alone.
    Wish current;
    std::array<Easel, picture_places> easels{Easel(options.first_picture_seconds),
                                             Easel(options.first_picture_seconds)};
    FramePool pool;
    std::uint64_t number = 0;

    /// Something is to be rendered anew.
    void wake(const std::function<void()>& change, bool same_view = false) {
        {
            const std::lock_guard lock(mutex);
            change();
            wish.same_view = same_view && (wish.same_view || !is_stale);
            is_stale = true;
            if (!must_finish || closing) cancel = true;
        }
        changed.notify_one();
    }

    void run();
    bool wait(bool is_finished, Wish& next, bool& again);
    void begin(const Wish& next);
    void start(std::size_t place);
    bool start_on_gpu(Easel& easel);
    void start_on_cpu(Easel& easel);
    void paint_first(Easel& easel, Desk& desk);
    bool refine(bool again);
    void advance(Easel& easel);
    void fall_back(Easel& easel, const std::string& fault);
    void publish(std::size_t place);
    View tone_now() const {
        const std::lock_guard lock(mutex);
        return tone;
    }
};

/// Waits for something to do; false at the end. Sets `next` where all begins anew, `again` where what there
/// is is to be shown once more.
bool SessionRenderer::State::wait(bool is_finished, Wish& next, bool& again) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return closing || is_stale || is_retoned || !is_finished; });
    if (closing) return false;
    again = std::exchange(is_retoned, false);
    next = {};
    if (!is_stale) return true;
    next = wish;
    wish.is_new = {};
    is_stale = false;
    must_finish = true;
    cancel = false;
    return true;
}

void SessionRenderer::State::run() {
    bool is_finished = true;
    Wish next;
    bool again = false;
    while (wait(is_finished, next, again)) {
        if (next.is_possible()) begin(next);
        is_finished = !refine(again);
    }
    // Painters end on the thread that made them.
    for (Easel& easel : easels) {
        easel.cpu.painter.reset();
        easel.gpu.painter.reset();
    }
}

/// The first picture of each place.
void SessionRenderer::State::begin(const Wish& next) {
    current = next;
    for (std::size_t place = 0; place < picture_places; ++place) {
        Easel& easel = easels[place];
        easel.scene.reset();
        if (next.is_new[place]) easel.fault.clear();
        if (next.scenes[place]) start(place);
    }
    const std::lock_guard lock(mutex);
    must_finish = false;
    if (is_stale || closing) cancel = true;
}

void SessionRenderer::State::start(std::size_t place) {
    Easel& easel = easels[place];
    try {
        easel.scene = with_view(*current.scenes[place], current.camera, current.width, current.height);
    } catch (const Error&) {
        return; // nothing can be seen from there: the last picture stays
    }
    easel.show = current.show[place];
    {
        const std::lock_guard lock(mutex);
        easel.coarsest = current.same_view && frames[place] ? frames[place]->reached.step : most_coarse;
    }
    if (!start_on_gpu(easel)) start_on_cpu(easel);
    const Clock::time_point begin = Clock::now();
    publish(place);
    if (easel.first_step > 0)
        (easel.on_gpu ? easel.gpu : easel.cpu)
            .pace.learn(current.width * current.height, easel.first_step, easel.first_seconds,
                        seconds_since(begin));
}

/// False where the CPU is to draw.
bool SessionRenderer::State::start_on_gpu(Easel& easel) {
    if (!current.gpu || !easel.fault.empty()) return false;
    easel.fault = fault_of([&] {
        if (!easel.gpu.painter) easel.gpu.painter = current.gpu();
        paint_first(easel, easel.gpu);
    });
    if (easel.fault.empty()) return true;
    easel.gpu.painter.reset();
    return false;
}

void SessionRenderer::State::fall_back(Easel& easel, const std::string& fault) {
    easel.fault = fault;
    easel.gpu.painter.reset();
    start_on_cpu(easel);
}

void SessionRenderer::State::start_on_cpu(Easel& easel) {
    if (!easel.cpu.painter) easel.cpu.painter = cpu_painter(options.threads);
    paint_first(easel, easel.cpu);
}

void SessionRenderer::State::paint_first(Easel& easel, Desk& desk) {
    const Clock::time_point begin = Clock::now();
    const int pixels = current.width * current.height;
    ProgressiveOptions how;
    how.coarsest = desk.pace.step(pixels);
    how.show = easel.show;
    how.kernel.kernel = current.kernel;
    how.cancel = &cancel;
    // The first one of all waits for what later ones find: compiled shaders, memory.
    const bool is_warm = desk.painter->reached().step > 0;
    desk.painter->start(*easel.scene, how);
    desk.painter->advance(0);
    easel.on_gpu = &desk == &easel.gpu;
    easel.first_step = is_warm && desk.painter->reached().step > 0 ? how.coarsest : 0;
    easel.first_seconds = seconds_since(begin);
}

/// Makes all pictures a little better; is there anything left to do?
bool SessionRenderer::State::refine(bool again) {
    bool goes_on = false;
    for (std::size_t place = 0; place < picture_places && !cancel; ++place) {
        Easel& easel = easels[place];
        if (!easel.scene) continue;
        const bool was_finished = easel.painter().reached().finished;
        if (!was_finished) advance(easel);
        if (!cancel && (again || !was_finished)) publish(place);
        // Asked last: after a fault another painter has only begun.
        goes_on = goes_on || !easel.painter().reached().finished;
    }
    return goes_on;
}

/// Where the graphics card fails on the way, the CPU begins anew.
void SessionRenderer::State::advance(Easel& easel) {
    if (!easel.on_gpu) {
        easel.cpu.painter->advance(slice_seconds);
        return;
    }
    const std::string fault = fault_of([&] { easel.gpu.painter->advance(slice_seconds); });
    if (!fault.empty()) fall_back(easel, fault);
}

void SessionRenderer::State::publish(std::size_t place) {
    Easel& easel = easels[place];
    Painter& painter = easel.painter();
    // Nothing is known where the program ends.
    if (painter.reached().step == 0 || painter.reached().step > easel.coarsest) return;
    const std::shared_ptr<Frame> frame = pool.take();
    if (!easel.on_gpu) {
        painter.show(*frame);
    } else if (const std::string fault = fault_of([&] { painter.show(*frame); }); !fault.empty()) {
        fall_back(easel, fault);
        return publish(place);
    }
    frame->reached = painter.reached();
    frame->camera = easel.scene->camera();
    frame->number = ++number;
    frame->rays_per_second =
        frame->reached.seconds > 0 ? static_cast<double>(frame->reached.rays) / frame->reached.seconds : 0;
    frame->show = easel.show;
    frame->device = painter.device();
    frame->why_cpu = easel.fault;
    if (!is_visible(easel.show)) frame->image = visible(frame->image, easel.show, *easel.scene);
    if (!frame->on_device) screen_pixels(frame->image, tone_now(), frame->screen);
    {
        const std::lock_guard lock(mutex);
        frames[place] = frame;
    }
    // Whoever draws this view after a fault, it is not seen to become coarser.
    easel.coarsest = std::min(easel.coarsest, frame->reached.step);
    if (options.changed) options.changed();
}

SessionRenderer::SessionRenderer(Options options) : state_(std::make_unique<State>(std::move(options))) {
    state_->thread = std::thread([state = state_.get()] { state->run(); });
}

SessionRenderer::~SessionRenderer() {
    state_->wake([this] { state_->closing = true; });
    state_->thread.join();
}

void SessionRenderer::set_scene(int place, std::optional<Scene> scene) {
    const auto at = static_cast<std::size_t>(place);
    state_->wake([&] {
        if (!scene) state_->frames[at].reset();
        state_->wish.scenes[at] = std::move(scene);
        state_->wish.is_new[at] = true;
    });
}

void SessionRenderer::set_show(int place, Aspect show) {
    state_->wake([&] { state_->wish.show[static_cast<std::size_t>(place)] = show; });
}

void SessionRenderer::set_kernel(Kernel kernel) {
    state_->wake([&] { state_->wish.kernel = kernel; });
}

void SessionRenderer::set_tone(View tone) {
    {
        const std::lock_guard lock(state_->mutex);
        if (state_->tone == tone) return;
        state_->tone = tone;
        state_->is_retoned = true;
    }
    state_->changed.notify_one();
}

void SessionRenderer::set_view(const CameraDescription& camera, int width, int height) {
    state_->wake([&] {
        state_->wish.camera = camera;
        state_->wish.width = width;
        state_->wish.height = height;
    });
}

void SessionRenderer::set_backend(PainterMaker gpu) {
    state_->wake(
        [&] {
            state_->wish.gpu = std::move(gpu);
            state_->wish.is_new = {true, true};
        },
        true);
}

std::shared_ptr<const Frame> SessionRenderer::latest(int place) const {
    const std::lock_guard lock(state_->mutex);
    return state_->frames[static_cast<std::size_t>(place)];
}

} // namespace glint::viewer
