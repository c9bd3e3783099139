// Workers take task numbers from one atomic counter.

#include "parallel/task_pool.h"

#include "parallel/resources.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace glint::parallel {

struct TaskPool::State {
    std::mutex mutex;
    std::condition_variable job_posted;
    std::condition_variable job_done;
    std::vector<std::thread> helpers; ///< workers 1, 2, …; the caller of run() is worker 0
    const std::atomic<bool>* cancel = nullptr;

    // The job: written under the mutex before `generation` is incremented, then constant until `busy` is 0.
    const std::function<void(std::size_t, int)>* body = nullptr;
    std::size_t count = 0;
    std::uint64_t generation = 0;
    int busy = 0; ///< helpers that have not finished the job
    bool closing = false;
    std::exception_ptr failure;

    std::atomic<std::size_t> next{0};
    std::atomic<bool> stopped{false};

    int threads() const { return static_cast<int>(helpers.size()) + 1; }

    void fail(std::exception_ptr error) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::move(error);
        stopped.store(true, std::memory_order_relaxed);
    }

    /// Runs one worker's tasks: its own first one, then whichever is next.
    void work(int worker) {
        try {
            std::size_t task = static_cast<std::size_t>(worker);
            while (task < count && !stopped.load(std::memory_order_relaxed)) {
                if (cancel != nullptr && cancel->load(std::memory_order_relaxed)) throw TasksCancelled();
                (*body)(task, worker);
                task = next.fetch_add(1, std::memory_order_relaxed);
            }
        } catch (...) {
            fail(std::current_exception());
        }
    }

    /// Main loop of a helper thread.
    void serve(int worker) {
        std::uint64_t seen = 0;
        for (;;) {
            {
                std::unique_lock lock(mutex);
                job_posted.wait(lock, [&] { return closing || generation != seen; });
                if (closing) return;
                seen = generation;
            }
            work(worker);
            const std::lock_guard lock(mutex);
            if (--busy == 0) job_done.notify_one();
        }
    }

    void close() {
        {
            const std::lock_guard lock(mutex);
            closing = true;
        }
        job_posted.notify_all();
        for (std::thread& helper : helpers) helper.join();
    }
};

TaskPool::TaskPool(int threads, const std::atomic<bool>* cancel) : state_(std::make_unique<State>()) {
    state_->cancel = cancel;
    const int wanted = threads > 0 ? threads : available_threads();
    try {
        state_->helpers.reserve(static_cast<std::size_t>(wanted - 1));
        for (int worker = 1; worker < wanted; ++worker)
            state_->helpers.emplace_back([state = state_.get(), worker] { state->serve(worker); });
    } catch (const std::system_error&) {
        // The system starts no more threads: those that run do the work.
    } catch (...) {
        // Join the others before the exception leaves.
        state_->close();
        throw;
    }
}

TaskPool::~TaskPool() { state_->close(); }

int TaskPool::threads() const { return state_->threads(); }

void TaskPool::run(std::size_t count, const std::function<void(std::size_t task, int worker)>& body) {
    State& state = *state_;
    {
        const std::lock_guard lock(state.mutex);
        state.body = &body;
        state.count = count;
        state.failure = nullptr;
        state.stopped.store(false, std::memory_order_relaxed);
        // Tasks below the number of workers are each worker's first task.
        state.next.store(state.helpers.size() + 1, std::memory_order_relaxed);
        // Run a single task on the caller; wake no helper.
        state.busy = count > 1 ? static_cast<int>(state.helpers.size()) : 0;
        if (state.busy > 0) ++state.generation;
    }
    if (count > 1) state.job_posted.notify_all();
    state.work(0);

    std::exception_ptr failure;
    {
        std::unique_lock lock(state.mutex);
        state.job_done.wait(lock, [&] { return state.busy == 0; });
        state.body = nullptr;
        std::swap(failure, state.failure);
    }
    if (failure) std::rethrow_exception(failure);
}

} // namespace glint::parallel
