// The renderer's thread: takes the latest request, renders first passes, refines in slices. Its states are
// those of RenderStates.
#include "renderer.h"

#include "clock.h"
#include "render_states.h"
#include "view_renderer.h"

#include "glint/scene.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace glint::viewer {
namespace {

/// Time between two frames of a picture that is being refined.
constexpr double slice_seconds = 0.040;

/// Everything that decides what is rendered.
struct RenderRequest {
    PerView<std::optional<Scene>> scenes;
    PerView<Aov> show;
    Kernel kernel = Kernel::automatic;
    CameraDescription camera;
    int width = 0;
    int height = 0;
    BackendFactory gpu;                ///< none: the CPU renders
    PerView<bool> retry_gpu;           ///< scene or backend have changed since the request was last taken
    bool only_backend_changed = false; ///< since then
};

/// A free list of frames: their images are large, and allocating large memory is slow. For any thread; frames
/// may outlive the pool.
class FramePool {
  public:
    /// A frame with whatever it last held, or a new one. It returns to the free list with its last reference,
    /// on whichever thread drops that; a GPU picture that it holds is released there.
    std::shared_ptr<RenderedFrame> take() {
        std::unique_ptr<RenderedFrame> frame;
        {
            const std::lock_guard lock(free_->mutex);
            if (!free_->frames.empty()) {
                frame = std::move(free_->frames.back());
                free_->frames.pop_back();
            }
        }
        if (!frame) frame = std::make_unique<RenderedFrame>();
        return {frame.release(), [list = free_](RenderedFrame* released) {
                    std::unique_ptr<RenderedFrame> returned(released);
                    returned->on_device.reset();
                    const std::lock_guard lock(list->mutex);
                    if (list->frames.size() < max_free) list->frames.push_back(std::move(returned));
                }};
    }

  private:
    static constexpr std::size_t max_free = 4;
    struct FreeList {
        std::mutex mutex;
        std::vector<std::unique_ptr<RenderedFrame>> frames; ///< guarded by `mutex`
    };
    std::shared_ptr<FreeList> free_ = std::make_shared<FreeList>();
};

} // namespace

struct SessionRenderer::State {
    explicit State(Options given) : options(std::move(given)) {}

    const Options options;

    mutable std::mutex mutex;
    std::condition_variable wake; ///< notified after every event of `states`
    // Guarded by `mutex`.
    RenderStates states;
    RenderRequest request; ///< the newest
    View tone = View::srgb;
    PerView<std::shared_ptr<const RenderedFrame>> frames; ///< null where `request` has no scene

    // Atomic. Written under `mutex`, always as states.must_cancel(); read by the renderer's thread without.
    CancelFlag cancel{false};

    // Of the renderer's thread alone.
    PerView<ViewRenderer> views{make_view(), make_view()};
    FramePool pool;
    std::uint64_t last_number = 0;

    std::thread thread; ///< last: uses all of the above

    ViewRenderer make_view() { return {options.threads, options.first_picture_seconds, cancel}; }

    // Any thread.
    template <class Change>
    void post(const Change& change);
    template <class Change>
    void change_request(const Change& change);

    // The renderer's thread.
    void run();
    RenderStates::State next_work(RenderRequest& taken, bool& show_again);
    void finish_work();
    void start_views(const RenderRequest& taken);
    void start_view(ViewSlot slot, const RenderRequest& taken);
    void refine_views(bool show_again);
    void publish(ViewSlot slot);
    int max_step(ViewSlot slot, const RenderRequest& taken) const;
    View current_tone() const;
};

// ── Any thread ─────────────────────────────────────────────────────────────────────────────────────────────

/// Applies an event under the lock, updates the cancel flag and wakes the renderer's thread.
template <class Change>
void SessionRenderer::State::post(const Change& change) {
    {
        const std::lock_guard lock(mutex);
        change();
        cancel = states.must_cancel();
    }
    wake.notify_one();
}

/// An event after which views are rendered again.
template <class Change>
void SessionRenderer::State::change_request(const Change& change) {
    post([&] {
        request.only_backend_changed = false;
        change();
        states.request_changed();
    });
}

// ── The renderer's thread ──────────────────────────────────────────────────────────────────────────────────

void SessionRenderer::State::run() {
    using Work = RenderStates::State;
    RenderRequest taken;
    bool show_again = false;
    for (Work work = next_work(taken, show_again); work != Work::closed;
         work = next_work(taken, show_again)) {
        if (work == Work::first_pass)
            start_views(taken);
        else
            refine_views(show_again);
        finish_work();
    }
    // GPU backends end on the thread that created them.
    for (ViewRenderer& view : views) view.release();
}

/// Sleeps until there is work. For a first pass, `taken` becomes the newest request; for a refinement,
/// `show_again` says that finished views are to be shown in another tone.
RenderStates::State SessionRenderer::State::next_work(RenderRequest& taken, bool& show_again) {
    std::unique_lock lock(mutex);
    wake.wait(lock, [&] { return states.has_work(); });
    const RenderStates::State work = states.begin_work();
    if (work == RenderStates::State::first_pass) {
        taken = request;
        request.retry_gpu = {};
    } else {
        show_again = states.take_tone_change();
    }
    cancel = states.must_cancel();
    return work;
}

void SessionRenderer::State::finish_work() {
    const bool views_finished =
        std::all_of(views.begin(), views.end(), [](const ViewRenderer& view) { return view.is_finished(); });
    const std::lock_guard lock(mutex);
    states.finish_work(views_finished);
    cancel = states.must_cancel();
}

void SessionRenderer::State::start_views(const RenderRequest& taken) {
    for (const ViewSlot slot : view_slots) {
        views[slot].clear();
        if (taken.retry_gpu[slot]) views[slot].forget_fault();
        if (taken.scenes[slot] && taken.width > 0 && taken.height > 0) start_view(slot, taken);
    }
}

void SessionRenderer::State::start_view(ViewSlot slot, const RenderRequest& taken) {
    std::optional<Scene> scene;
    try {
        scene = with_view(*taken.scenes[slot], taken.camera, taken.width, taken.height);
    } catch (const Error&) {
        return; // an impossible camera: the last frame stays
    }
    views[slot].start({std::move(*scene), taken.show[slot], taken.kernel, taken.gpu, max_step(slot, taken)});
    const double begin = now();
    publish(slot);
    views[slot].learn_show_seconds(now() - begin);
}

/// A change of backend must not make a view coarser than it is.
int SessionRenderer::State::max_step(ViewSlot slot, const RenderRequest& taken) const {
    const std::lock_guard lock(mutex);
    return taken.only_backend_changed && frames[slot] ? frames[slot]->reached.step : max_coarsest;
}

/// Makes each view a little better.
void SessionRenderer::State::refine_views(bool show_again) {
    for (const ViewSlot slot : view_slots) {
        if (cancel) return;
        ViewRenderer& view = views[slot];
        if (!view.has_picture()) continue;
        const bool was_finished = view.is_finished();
        view.refine(slice_seconds);
        if (!cancel && (show_again || !was_finished)) publish(slot);
    }
}

void SessionRenderer::State::publish(ViewSlot slot) {
    const std::shared_ptr<RenderedFrame> frame = pool.take();
    if (!views[slot].copy_to(*frame)) return;
    frame->number = ++last_number;
    if (!frame->on_device) screen_pixels(frame->image, current_tone(), frame->screen);
    {
        const std::lock_guard lock(mutex);
        // The scene may have been removed meanwhile.
        if (!request.scenes[slot]) return;
        frames[slot] = frame;
    }
    if (options.changed) options.changed();
}

View SessionRenderer::State::current_tone() const {
    const std::lock_guard lock(mutex);
    return tone;
}

// ── Interface ──────────────────────────────────────────────────────────────────────────────────────────────

SessionRenderer::SessionRenderer(Options options) : state_(std::make_unique<State>(std::move(options))) {
    state_->thread = std::thread([state = state_.get()] { state->run(); });
}

SessionRenderer::~SessionRenderer() {
    state_->post([this] { state_->states.close(); });
    state_->thread.join();
}

void SessionRenderer::set_scene(ViewSlot slot, std::optional<Scene> scene) {
    state_->change_request([&] {
        if (!scene) state_->frames[slot].reset();
        state_->request.scenes[slot] = std::move(scene);
        state_->request.retry_gpu[slot] = true;
    });
}

void SessionRenderer::set_show(ViewSlot slot, Aov show) {
    state_->change_request([&] { state_->request.show[slot] = show; });
}

void SessionRenderer::set_kernel(Kernel kernel) {
    state_->change_request([&] { state_->request.kernel = kernel; });
}

void SessionRenderer::set_tone(View tone) {
    if (state_->current_tone() == tone) return;
    state_->post([&] {
        state_->tone = tone;
        state_->states.tone_changed();
    });
}

void SessionRenderer::set_camera(const CameraDescription& camera, int width, int height) {
    state_->change_request([&] {
        state_->request.camera = camera;
        state_->request.width = width;
        state_->request.height = height;
    });
}

void SessionRenderer::set_backend(BackendFactory gpu) {
    state_->post([&] {
        // Still true if the pending changes, not yet taken, were all of the backend.
        RenderRequest& request = state_->request;
        request.only_backend_changed = request.only_backend_changed || !state_->states.is_request_pending();
        request.gpu = std::move(gpu);
        for (bool& retry : request.retry_gpu) retry = true;
        state_->states.request_changed();
    });
}

std::shared_ptr<const RenderedFrame> SessionRenderer::latest(ViewSlot slot) const {
    const std::lock_guard lock(state_->mutex);
    return state_->frames[slot];
}

} // namespace glint::viewer
