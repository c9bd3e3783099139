#include "renderer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
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
    CameraDescription camera;
    int width = 0;
    int height = 0;

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

/// How coarse the first picture must be to be there in time, learnt from those before.
class Pace {
  public:
    explicit Pace(double seconds) : seconds_(seconds) {}

    int step(int pixels) const {
        int step = 1;
        while (step < most_coarse && samples(pixels, step) * seconds_a_sample_ > seconds_) step *= 2;
        return step;
    }

    void learn(int pixels, int step, double seconds) {
        const double now = seconds / std::max(1.0, samples(pixels, step));
        // Views differ: what was slower counts at once, what was faster by and by.
        seconds_a_sample_ = std::max(now, 0.7 * seconds_a_sample_ + 0.3 * now);
    }

  private:
    static double samples(int pixels, int step) { return static_cast<double>(pixels) / (step * step); }

    double seconds_;
    double seconds_a_sample_ = 2e-6;
};

} // namespace

struct SessionRenderer::State {
    explicit State(Options given) : options(std::move(given)) {}

    const Options options;

    mutable std::mutex mutex; ///< guards the following
    std::condition_variable changed;
    Wish wish;
    bool is_stale = false;    ///< the wish is another than what is rendered
    bool must_finish = false; ///< the first picture is under way: it is shown even when it is stale
    bool closing = false;
    std::array<std::shared_ptr<const Frame>, picture_places> frames;

    CancelFlag cancel{false};
    std::thread thread;

    // Of the renderer's thread alone.
    std::array<std::unique_ptr<Progressive>, picture_places> pictures;
    std::array<std::optional<Scene>, picture_places> scenes; ///< as seen from the camera
    std::array<Aspect, picture_places> shows{};
    std::array<Pace, picture_places> paces{Pace(options.first_picture_seconds),
                                           Pace(options.first_picture_seconds)};
    FramePool pool;
    std::uint64_t number = 0;

    /// Something is to be rendered anew.
    void wake(const std::function<void()>& change) {
        {
            const std::lock_guard lock(mutex);
            change();
            is_stale = true;
            if (!must_finish || closing) cancel = true;
        }
        changed.notify_one();
    }

    void run();
    bool wait(bool is_finished, Wish& next);
    void begin(const Wish& next);
    void start(std::size_t place, const Wish& next);
    bool refine();
    void publish(std::size_t place);
};

/// Waits for something to do; false at the end. Sets `next` where all begins anew.
bool SessionRenderer::State::wait(bool is_finished, Wish& next) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return closing || is_stale || !is_finished; });
    if (closing) return false;
    next = {};
    if (!is_stale) return true;
    next = wish;
    is_stale = false;
    must_finish = true;
    cancel = false;
    return true;
}

void SessionRenderer::State::run() {
    bool is_finished = true;
    Wish next;
    while (wait(is_finished, next)) {
        if (next.is_possible()) begin(next);
        is_finished = !refine();
    }
}

/// The first picture of each place.
void SessionRenderer::State::begin(const Wish& next) {
    for (std::size_t place = 0; place < picture_places; ++place) {
        scenes[place].reset();
        if (next.scenes[place]) start(place, next);
    }
    const std::lock_guard lock(mutex);
    must_finish = false;
    if (is_stale || closing) cancel = true;
}

void SessionRenderer::State::start(std::size_t place, const Wish& next) {
    const Clock::time_point begin = Clock::now();
    if (!pictures[place]) pictures[place] = std::make_unique<Progressive>(options.threads);
    try {
        scenes[place] = with_view(*next.scenes[place], next.camera, next.width, next.height);
    } catch (const Error&) {
        return; // nothing can be seen from there: the last picture stays
    }
    shows[place] = next.show[place];
    const int pixels = next.width * next.height;
    ProgressiveOptions how;
    how.coarsest = paces[place].step(pixels);
    how.show = shows[place];
    how.kernel = options.kernel;
    how.cancel = &cancel;
    pictures[place]->start(*scenes[place], how);
    pictures[place]->advance(0);
    if (pictures[place]->reached().step == 0) return; // the program ends
    publish(place);
    paces[place].learn(pixels, how.coarsest, seconds_since(begin));
}

/// Makes all pictures a little better; is there anything left to do?
bool SessionRenderer::State::refine() {
    bool goes_on = false;
    for (std::size_t place = 0; place < picture_places && !cancel; ++place) {
        if (!scenes[place] || pictures[place]->reached().finished) continue;
        goes_on = pictures[place]->advance(slice_seconds) || goes_on;
        if (!cancel) publish(place);
    }
    return goes_on;
}

void SessionRenderer::State::publish(std::size_t place) {
    const Progressive& picture = *pictures[place];
    const std::shared_ptr<Frame> frame = pool.take();
    frame->reached = picture.reached();
    frame->camera = scenes[place]->camera();
    frame->number = ++number;
    frame->rays_per_second =
        frame->reached.seconds > 0 ? static_cast<double>(frame->reached.rays) / frame->reached.seconds : 0;
    frame->show = shows[place];
    if (shows[place] == Aspect::final)
        frame->image = picture.image(); // into the memory that the frame has
    else
        frame->image = visible(picture.image(), shows[place], *scenes[place]);
    {
        const std::lock_guard lock(mutex);
        frames[place] = frame;
    }
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
    });
}

void SessionRenderer::set_show(int place, Aspect show) {
    state_->wake([&] { state_->wish.show[static_cast<std::size_t>(place)] = show; });
}

void SessionRenderer::set_view(const CameraDescription& camera, int width, int height) {
    state_->wake([&] {
        state_->wish.camera = camera;
        state_->wish.width = width;
        state_->wish.height = height;
    });
}

std::shared_ptr<const Frame> SessionRenderer::latest(int place) const {
    const std::lock_guard lock(state_->mutex);
    return state_->frames[static_cast<std::size_t>(place)];
}

} // namespace glint::viewer
