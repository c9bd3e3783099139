// The explainer's thread: takes the latest question, answers it, and starts again when its scene changes.
#include "explainer.h"

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

/// Answers that take less follow every step of a slider. Slower ones wait until the slider rests: for as long
/// as the last answer took, at most `max_delay`.
constexpr Seconds quick(0.005);
constexpr Seconds max_delay(0.3);

} // namespace

struct SessionExplainer::State {
    explicit State(std::function<void()> on_answer) : changed(std::move(on_answer)) {}

    const std::function<void()> changed;

    mutable std::mutex mutex;
    std::condition_variable wake;
    // Guarded by `mutex`.
    PerView<std::optional<Scene>> scenes;
    std::optional<PixelQuestion> question;
    std::shared_ptr<const PixelAnswer> answer;
    bool is_open = false;    ///< the question needs an answer, the first one or a new one
    int changes = 0;         ///< number of changes to what is asked
    Clock::time_point since; ///< time of the last of them
    Seconds answer_time{0};  ///< what the last answer took
    bool closing = false;

    // Atomic. Set under `mutex` when the answer under way is not wanted any more; cleared by the thread.
    CancelFlag cancel{false};

    // Of the explainer's thread alone. Answers are freed there: large ones take long.
    std::vector<std::shared_ptr<const PixelAnswer>> answers;

    std::thread thread; ///< last: uses all of the above

    void replace_question(std::optional<PixelQuestion> asked) {
        const std::lock_guard lock(mutex);
        question = std::move(asked);
        answer.reset();
        open_question();
    }

    // With `mutex` held.
    bool is_repeat() const { return answer != nullptr; }
    bool waits_for_rest() const { return is_repeat() && answer_time > quick; }
    void open_question();
    bool wait(std::unique_lock<std::mutex>& lock);

    void run();
    std::shared_ptr<const PixelAnswer> explain(const PixelQuestion& asked, const Scene& scene) const;
};

/// Something of the question or its scene has changed.
void SessionExplainer::State::open_question() {
    is_open = question.has_value() && scenes[question->slot].has_value();
    ++changes;
    since = Clock::now();
    if (!is_repeat() || waits_for_rest()) cancel = true;
    wake.notify_one();
}

/// Waits for a question that is due; false at the end.
bool SessionExplainer::State::wait(std::unique_lock<std::mutex>& lock) {
    while (!closing) {
        if (!is_open) {
            wake.wait(lock);
            continue;
        }
        const Seconds delay = waits_for_rest() ? std::min(answer_time, max_delay) : Seconds(0);
        const auto due = since + std::chrono::duration_cast<Clock::duration>(delay);
        if (Clock::now() >= due) return true;
        wake.wait_until(lock, due);
    }
    return false;
}

void SessionExplainer::State::run() {
    std::unique_lock lock(mutex);
    while (wait(lock)) {
        const PixelQuestion asked = *question;
        const Scene scene = *scenes[asked.slot];
        const int change = changes;
        cancel = false;
        lock.unlock();
        std::erase_if(answers, [](const auto& old) { return old.use_count() == 1; });
        const Clock::time_point begin = Clock::now();
        std::shared_ptr<const PixelAnswer> made = explain(asked, scene);
        const Seconds time = Clock::now() - begin;
        if (made) answers.push_back(made);
        lock.lock();
        if (!made || cancel) continue;
        answer_time = time;
        answer = std::move(made);
        is_open = changes != change;
        lock.unlock();
        if (changed) changed();
        lock.lock();
    }
}

/// Null if it was cancelled.
std::shared_ptr<const PixelAnswer> SessionExplainer::State::explain(const PixelQuestion& asked,
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
    state_->wake.notify_one();
    state_->thread.join();
}

void SessionExplainer::set_scene(ViewSlot slot, std::optional<Scene> scene) {
    const std::lock_guard lock(state_->mutex);
    const bool has_scene = scene.has_value();
    state_->scenes[slot] = std::move(scene);
    if (!state_->question || state_->question->slot != slot) return;
    if (!has_scene) {
        state_->question.reset();
        state_->answer.reset();
    }
    state_->open_question();
}

void SessionExplainer::ask(const PixelQuestion& question) { state_->replace_question(question); }
void SessionExplainer::forget() { state_->replace_question(std::nullopt); }

std::shared_ptr<const PixelAnswer> SessionExplainer::latest() const {
    const std::lock_guard lock(state_->mutex);
    return state_->answer;
}

bool SessionExplainer::is_busy() const {
    const std::lock_guard lock(state_->mutex);
    return state_->is_open;
}

} // namespace glint::viewer
