#include "explainer.h"

#include "renderer.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <new>
#include <thread>
#include <utility>
#include <vector>

namespace glint::viewer {
namespace {

using Clock = std::chrono::steady_clock;

using Seconds = std::chrono::duration<double>;

/// What is quick is explained at every step of a slider; what takes longer is begun anew when that rests.
constexpr Seconds quick(0.005);
constexpr Seconds longest_rest(0.3);

} // namespace

struct SessionExplainer::State {
    explicit State(std::function<void()> told) : changed(std::move(told)) {}

    const std::function<void()> changed;

    mutable std::mutex mutex; ///< guards what follows, up to the thread's own
    std::condition_variable woken;
    std::array<std::optional<Scene>, picture_places> scenes;
    std::optional<PixelQuestion> question;
    std::shared_ptr<const PixelAnswer> answer;
    bool is_open = false; ///< the question is to be answered
    int changes = 0;      ///< of what is asked, and when the last one was
    Clock::time_point since;
    Seconds last_time{0}; ///< that an answer took
    bool closing = false;
    CancelFlag cancel{false};

    std::vector<std::shared_ptr<const PixelAnswer>> given; ///< freed by the thread: that takes long, too
    std::thread thread;                                    ///< last

    /// Of what was answered already the scene is another: until there is news, the answer stays.
    bool is_again() const { return answer != nullptr; }

    void open_question() {
        is_open = question.has_value() && scenes[static_cast<std::size_t>(question->place)].has_value();
        ++changes;
        since = Clock::now();
        if (!is_again() || last_time > quick) cancel = true;
        woken.notify_one();
    }

    void run();
    bool wait(std::unique_lock<std::mutex>& lock);
    std::shared_ptr<const PixelAnswer> answer_to(const PixelQuestion& asked, const Scene& scene) const;
};

/// Waits for a question whose time has come; false at the end.
bool SessionExplainer::State::wait(std::unique_lock<std::mutex>& lock) {
    while (!closing) {
        if (!is_open) {
            woken.wait(lock);
            continue;
        }
        const Seconds rest = is_again() && last_time > quick ? std::min(last_time, longest_rest) : Seconds(0);
        const auto due = since + std::chrono::duration_cast<Clock::duration>(rest);
        if (Clock::now() >= due) return true;
        woken.wait_until(lock, due);
    }
    return false;
}

void SessionExplainer::State::run() {
    std::unique_lock lock(mutex);
    while (wait(lock)) {
        const PixelQuestion asked = *question;
        const Scene scene = *scenes[static_cast<std::size_t>(asked.place)];
        const int change = changes;
        cancel = false;
        lock.unlock();
        std::erase_if(given, [](const auto& one) { return one.use_count() == 1; });
        const Clock::time_point begin = Clock::now();
        std::shared_ptr<const PixelAnswer> made = answer_to(asked, scene);
        const Seconds time = Clock::now() - begin;
        if (made) given.push_back(made);
        lock.lock();
        if (!made || cancel) continue;
        last_time = time;
        answer = std::move(made);
        is_open = changes != change;
        lock.unlock();
        if (changed) changed();
        lock.lock();
    }
}

/// None where it was cancelled.
std::shared_ptr<const PixelAnswer> SessionExplainer::State::answer_to(const PixelQuestion& asked,
                                                                      const Scene& scene) const {
    auto made = std::make_shared<PixelAnswer>();
    made->question = asked;
    try {
        const Scene seen = with_view(scene, asked.camera, asked.width, asked.height);
        made->explanation = Explainer(seen, &cancel).pixel(asked.x, asked.y, {explained_samples, 0});
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::cancelled) return nullptr;
        made->fault = error.diagnostics().front().message;
    } catch (const std::bad_alloc&) {
        made->fault = "there is not enough memory to explain the pixel";
    }
    return made;
}

SessionExplainer::SessionExplainer(std::function<void()> changed)
    : state_(std::make_unique<State>(std::move(changed))) {
    state_->thread = std::thread([state = state_.get()] { state->run(); });
}

SessionExplainer::~SessionExplainer() {
    {
        const std::lock_guard lock(state_->mutex);
        state_->closing = true;
        state_->cancel = true;
    }
    state_->woken.notify_one();
    state_->thread.join();
}

void SessionExplainer::set_scene(int place, std::optional<Scene> scene) {
    const std::lock_guard lock(state_->mutex);
    const bool is_there = scene.has_value();
    state_->scenes[static_cast<std::size_t>(place)] = std::move(scene);
    if (!state_->question || state_->question->place != place) return;
    if (!is_there) {
        state_->question.reset();
        state_->answer.reset();
    }
    state_->open_question();
}

void SessionExplainer::ask(const PixelQuestion& question) {
    const std::lock_guard lock(state_->mutex);
    state_->question = question;
    state_->answer.reset();
    state_->open_question();
}

void SessionExplainer::forget() {
    const std::lock_guard lock(state_->mutex);
    state_->question.reset();
    state_->answer.reset();
    state_->open_question();
}

std::shared_ptr<const PixelAnswer> SessionExplainer::latest() const {
    const std::lock_guard lock(state_->mutex);
    return state_->answer;
}

bool SessionExplainer::is_busy() const {
    const std::lock_guard lock(state_->mutex);
    return state_->is_open;
}

} // namespace glint::viewer
